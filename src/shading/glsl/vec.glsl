// The twin of math/vec.h: vectors that stay finite.
#ifdef CLAMP
float saturate(float x) { return x > 0.0 ? (x < 1.0 ? x : 1.0) : 0.0; }

vec3 saturate(vec3 v) { return vec3(saturate(v.x), saturate(v.y), saturate(v.z)); }
#endif

#ifdef UNIT
// |v| and v/|v|; 0 and (0, 0, 0) where there is no direction.
float length_and_unit(vec3 v, out vec3 unit) {
  float square = dot(v, v);
  if (square > 1e-30 && square < 1e30) {
    float length = sqrt(square);
    unit = v / length;
    return length;
  }
  float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
  unit = vec3(0.0);
  if (!(largest > 0.0) || any(isnan(v)) || any(isinf(v))) return 0.0;
  vec3 scaled = v / largest;
  float length = sqrt(dot(scaled, scaled));
  unit = scaled / length;
  return length * largest;
}

vec3 unit(vec3 v) {
  vec3 u;
  length_and_unit(v, u);
  return u;
}
#endif
