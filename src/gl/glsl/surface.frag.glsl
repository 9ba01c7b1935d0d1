// The colour of a pixel: interpolated (flat, Gouraud) or lit here (Phong).
#ifdef PHONG
#ifdef EYE_POSITION
in vec3 P;
#endif
#ifdef NORMAL
in vec3 N;
#endif
#ifdef RADIOSITY
in vec3 B;
#endif
#else
#ifdef FLAT
flat in vec3 front;
#ifdef TWO_SIDED
flat in vec3 back;
#endif
#else
in vec3 front;
#ifdef TWO_SIDED
in vec3 back;
#endif
#endif
#endif
out vec4 colour;

#ifdef IDS
uniform int object;
out ivec2 id;
#endif
#ifdef NORMALS
in vec3 world_normal;
out vec4 normal_out;
#endif
#ifdef ALPHA_TEST
uniform float alpha_threshold;
#endif

void main() {
#ifdef PHONG
  vec3 at = vec3(0.0), facing = vec3(0.0);
#ifdef EYE_POSITION
  at = P;
#endif
#ifdef NORMAL
#ifdef NORMALIZE
  facing = unit(N);
#else
  facing = N;
#endif
#ifdef NORMAL_LAYERS
  facing = layered_normal(facing, at);
#endif
#ifdef TWO_SIDED
  if (!gl_FrontFacing) facing = -facing;
#endif
#endif
#ifdef LAYERED_MATERIAL
  apply_layers();
#endif
#ifdef RADIOSITY
  colour = vec4(light_point(at, facing, B), 1.0);
#else
  colour = vec4(light_point(at, facing), 1.0);
#endif
#else
#ifdef TWO_SIDED
  colour = vec4(gl_FrontFacing ? front : back, 1.0);
#else
  colour = vec4(front, 1.0);
#endif
#endif
#ifdef COMPOSED
  colour = layered_colour(colour);
#ifdef CLAMP
  colour.rgb = clamp(colour.rgb, 0.0, 1.0);
#endif
#endif
#ifdef ALPHA_TEST
  if (!(colour.a > alpha_threshold)) discard;
#endif
#ifdef IDS
  id = ivec2(object, gl_PrimitiveID);
#endif
#ifdef NORMALS
  normal_out = vec4(world_normal, 0.0);
#endif
}
