// The twin of shading/bump.h; needs vec.glsl and, for heights, texture_lookup.glsl.
struct TangentFrame {
  vec3 P_u, P_v;
};

// Of the triangle that the pixel is in: on a plane the steps to the neighbours, p1 and p2 in space, a and b in uv, give
// the frame that its edges give. False where uv do not change.
bool tangent_frame(vec3 p1, vec3 p2, vec2 a, vec2 b, out TangentFrame frame) {
  float area = a.x * b.y - b.x * a.y;
  frame = TangentFrame(vec3(0.0), vec3(0.0));
  if (!(abs(area) > 0.0)) return false;
  frame = TangentFrame((p1 * b.y - p2 * a.y) / area, (p2 * a.x - p1 * b.x) / area);
  return !any(isnan(frame.P_u)) && !any(isnan(frame.P_v)) && !any(isinf(frame.P_u)) && !any(isinf(frame.P_v));
}

#ifdef HEIGHTS
vec2 height_gradient(sampler2D heights, int layer, vec2 uv) {
  vec2 h = 1.0 / vec2(textureSize(heights, 0));
  vec2 u = vec2(h.x, 0.0), v = vec2(0.0, h.y);
  return vec2(linear_texels(heights, layer, uv + u).r - linear_texels(heights, layer, uv - u).r,
              linear_texels(heights, layer, uv + v).r - linear_texels(heights, layer, uv - v).r) / (2.0 * h);
}

vec3 bumped_normal(vec3 N, TangentFrame frame, vec2 F) {
  if (F == vec2(0.0)) return N;
  float area = dot(cross(frame.P_u, frame.P_v), N);
  if (!(abs(area) > 0.0)) return N;
  vec3 bumped = unit(N + (F.x * cross(N, frame.P_v) - F.y * cross(N, frame.P_u)) / area);
  return bumped == vec3(0.0) ? N : bumped;
}
#endif

#ifdef NORMAL_MAP
vec3 mapped_normal(vec3 N, TangentFrame frame, vec3 colour, float strength) {
  vec3 n = 2.0 * colour - 1.0;
  n = vec3(n.xy * strength, max(n.z, 1e-3));
  if (n.xy == vec2(0.0)) return N;
  vec3 T = unit(frame.P_u - dot(frame.P_u, N) * N), B = unit(frame.P_v - dot(frame.P_v, N) * N);
  vec3 mapped = unit(n.x * T + n.y * B + n.z * N);
  return mapped == vec3(0.0) ? N : mapped;
}
#endif
