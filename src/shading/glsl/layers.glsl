// The twin of shading/layers.h, for what a scene's layers use of it.
struct TextureLayer {
  vec2 u, v, offset;  // the texture matrix by rows
  float scale, amount;
#ifdef BLEND
  vec3 blend_colour;  // C_c
#endif
#ifdef LEVEL_ZERO
  ivec2 wrap;  // 0 repeat, 1 mirror, 2 clamp, 3 border
  bool linear;
  vec4 border;
#endif
};
uniform TextureLayer layers[LAYERS];
uniform sampler2D pictures[LAYERS];

vec2 texture_difference(int i, vec2 d) { return vec2(dot(layers[i].u, d), dot(layers[i].v, d)); }

vec2 texture_point(int i, vec2 uv) { return texture_difference(i, uv) + layers[i].offset; }

#ifdef REPLACE
vec4 replaced(vec4 C, vec4 T) { return T; }
#endif

#ifdef MODULATE
vec4 modulated(vec4 C, vec4 T) { return C * T; }
#endif

#ifdef DECAL
vec4 decalled(vec4 C, vec4 T) { return vec4(C.rgb * (1.0 - T.a) + T.rgb * T.a, C.a); }
#endif

#ifdef BLEND
vec4 blended(vec4 C, vec4 T, vec3 C_c) { return vec4(C.rgb * (1.0 - T.rgb) + C_c * T.rgb, C.a * T.a); }
#endif

#ifdef ADD
vec4 added(vec4 C, vec4 T) { return vec4(C.rgb + T.rgb, C.a * T.a); }
#endif
