// Surface positions to clip space; light at the vertices (flat, Gouraud), or what a pixel needs for it (Phong).
uniform mat4 surface_to_clip;
invariant gl_Position;  // the order of the sum below is the one of shading/clip_position.h

in vec3 position;
#ifdef EYE_POSITION
uniform mat4 surface_to_eye;
#endif
#ifdef VERTEX_NORMAL
in vec3 normal;
#endif
#ifdef RADIOSITY
in vec3 radiosity;
#endif
#ifdef NORMAL
uniform mat3 normal_to_eye;

vec3 eye_normal(vec3 n) {
#ifdef NORMALIZE
  return unit(normal_to_eye * n);
#else
  return normal_to_eye * n;
#endif
}
#endif

#ifdef PHONG
#ifdef EYE_POSITION
out vec3 P;
#endif
#ifdef NORMAL
out vec3 N;
#endif
#ifdef RADIOSITY
out vec3 B;
#endif
#else
#ifdef FLAT
flat out vec3 front;
#ifdef TWO_SIDED
flat out vec3 back;
#endif
#else
out vec3 front;
#ifdef TWO_SIDED
out vec3 back;
#endif
#endif
#endif

#ifdef NORMALS
uniform mat3 normal_to_world;
out vec3 world_normal;
#endif

void main() {
  mat4 m = surface_to_clip;
  gl_Position = m[0] * position.x + m[1] * position.y + m[2] * position.z + m[3];
#ifndef PHONG
  vec3 P = vec3(0.0), N = vec3(0.0);
#endif
#ifdef EYE_POSITION
  P = (surface_to_eye * vec4(position, 1.0)).xyz;
#endif
#ifdef NORMAL
  N = eye_normal(normal);
#endif
#ifdef TEXTURED
  pass_uv();
#endif
#ifndef PHONG
#ifdef LAYERED_MATERIAL
  apply_layers();
#endif
#endif
#ifdef RADIOSITY
#ifdef PHONG
  B = radiosity;
#else
  front = light_point(P, N, radiosity);
#ifdef TWO_SIDED
  back = light_point(P, -N, radiosity);
#endif
#endif
#else
#ifndef PHONG
  front = light_point(P, N);
#ifdef TWO_SIDED
  back = light_point(P, -N);
#endif
#endif
#endif
#ifdef NORMALS
  world_normal = normal_to_world * normal;
#endif
}
