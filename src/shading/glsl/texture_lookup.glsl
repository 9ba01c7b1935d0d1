// The twin of shading/texture_lookup.h, of level 0 alone: for vertices, which have no level, and for heights, whose
// differences would show the weights of few bits that drivers interpolate with. All else the driver reads.
float wrapped(int wrap, float u) {
  if (wrap == 0) {
    u -= floor(u);
  } else if (wrap == 1) {
    u -= 2.0 * floor(u / 2.0);
    if (u > 1.0) u = 2.0 - u;
  } else {
    u = u > -1.0 ? (u < 2.0 ? u : 2.0) : (u <= -1.0 ? -1.0 : u);
  }
  return u == u ? u : 0.0;
}

int wrapped_texel(int wrap, int i, int size) {
  if (wrap == 0) return (i + size) % size;
  if (wrap == 3) return i >= 0 && i < size ? i : -1;
  return clamp(i, 0, size - 1);
}

vec4 texel_or_border(sampler2D image, int layer, int i, int j) {
  return i >= 0 && j >= 0 ? texelFetch(image, ivec2(i, j), 0) : layers[layer].border;
}

vec4 linear_texels(sampler2D image, int layer, vec2 uv) {
  ivec2 size = textureSize(image, 0), wrap = layers[layer].wrap;
  vec2 p = vec2(wrapped(wrap.x, uv.x), wrapped(wrap.y, uv.y)) * vec2(size) - 0.5;
  vec2 low = floor(p), part = p - low;
  int i0 = wrapped_texel(wrap.x, int(low.x), size.x), i1 = wrapped_texel(wrap.x, int(low.x) + 1, size.x);
  int j0 = wrapped_texel(wrap.y, int(low.y), size.y), j1 = wrapped_texel(wrap.y, int(low.y) + 1, size.y);
  vec4 below = mix(texel_or_border(image, layer, i0, j0), texel_or_border(image, layer, i1, j0), part.x);
  vec4 above = mix(texel_or_border(image, layer, i0, j1), texel_or_border(image, layer, i1, j1), part.x);
  return mix(below, above, part.y);
}

#ifndef PHONG
vec4 nearest_texel(sampler2D image, int layer, vec2 uv) {
  ivec2 size = textureSize(image, 0), wrap = layers[layer].wrap;
  int i = int(floor(wrapped(wrap.x, uv.x) * float(size.x))), j = int(floor(wrapped(wrap.y, uv.y) * float(size.y)));
  return texel_or_border(image, layer, wrapped_texel(wrap.x, i, size.x), wrapped_texel(wrap.y, j, size.y));
}

vec4 texture_at_vertex(sampler2D image, int layer, vec2 uv) {
  return layers[layer].linear ? linear_texels(image, layer, uv) : nearest_texel(image, layer, uv);
}
#endif
