// The twin of shading/light_model.h, for what a scene uses of it; needs vec.glsl.
//
//   I = E + I_a k_a + sum_i att_i spot_i [ I_ai k_a + I_di k_d (N.L_i) + f_i I_si k_s (R_i.V)^n  or  (N.H_i)^n ]
#ifdef MATERIAL
struct EyeMaterial {
#ifdef K_A
  vec3 k_a;
#endif
#ifdef DIFFUSE
  vec3 k_d;
#endif
#ifdef SPECULAR
  vec3 k_s;
  float n;
#endif
#ifdef EMISSION
  vec3 emission;
#endif
};
#ifdef LAYERED_MATERIAL
uniform EyeMaterial given;
EyeMaterial material;  // as the layers of textures leave it
#else
uniform EyeMaterial material;
#endif
#endif

#ifdef AMBIENT
uniform vec3 ambient;  // I_a, global
#endif

#ifdef LIT
struct EyeLight {
#ifdef LIGHT_AMBIENT
  vec3 ambient;  // I_ai
#endif
#ifdef DIFFUSE
  vec3 diffuse;  // I_di
#endif
#ifdef SPECULAR
  vec3 specular;  // I_si
#endif
#ifdef DIRECTION
  vec3 position;  // of a directional light: the unit direction towards it
#endif
#ifdef SPOT
  vec3 spot_direction;
  float spot_cosine;  // of the cut-off; -2: no cone
  float spot_exponent;
#endif
#ifdef ATTENUATION
  float k_0, k_1, k_2;
#endif
#ifdef MIXED
  bool directional;
#endif
};
uniform EyeLight lights[LIGHTS];

#ifdef SPECULAR
// log(1 - x), 0 <= x < 1, without losing the digits of a small x.
float log1m(float x) {
  if (x > 0.25) return log(1.0 - x);
  float z = x / (2.0 - x), w = z * z;
  return -2.0 * z * (1.0 + w * (1.0 / 3.0 + w * (1.0 / 5.0 + w * (1.0 / 7.0 + w * (1.0 / 9.0)))));
}

// max(a.b, 0)^n; from the sine where a and b are unit, the angle is small and n is large. 0^0 = 1.
float lobe_power(vec3 a, vec3 b, float cosine, float n) {
  if (n == 0.0) return 1.0;
  if (!(cosine > 0.0)) return 0.0;
  if (n > 128.0 && cosine > 0.5 && abs(dot(a, a) * dot(b, b) - 1.0) < 1e-4) {
    vec3 s = cross(a, b);
    return exp(0.5 * n * log1m(min(dot(s, s), 1.0)));
  }
  return min(pow(cosine, n), 1e30);
}
#endif

#ifdef DIRECTION
struct LightFactors {
  vec3 L;
#ifdef NORMAL
  float n_dot_l;
#endif
#ifdef SPECULAR
  float lobe;
#endif
#ifdef SCALED
  float share;  // attenuation times spot
#endif
};

LightFactors light_factors(EyeLight light, vec3 P, vec3 N, vec3 V) {
  LightFactors f;
  f.L = light.position;
#ifdef NORMAL
  f.n_dot_l = 0.0;
#endif
#ifdef SPECULAR
  f.lobe = 0.0;
#endif
#ifdef SCALED
  f.share = 1.0;
#endif
#ifdef POINT
#ifdef MIXED
  if (!light.directional) {
#endif
    float r = length_and_unit(light.position - P, f.L);
#ifdef ATTENUATION
    float d = light.k_0 + r * (light.k_1 + r * light.k_2);
    f.share = d > 0.0 ? 1.0 / d : 1.0;
#endif
#ifdef MIXED
  }
#endif
#endif
#ifdef SPOT
  if (light.spot_cosine > -2.0) {
    float c = -dot(f.L, light.spot_direction);
    f.share *= c >= light.spot_cosine && c > 0.0
                   ? (light.spot_exponent == 0.0 ? 1.0 : pow(min(c, 1.0), light.spot_exponent))
                   : 0.0;
  }
#endif
#ifdef NORMAL
  float cosine = dot(N, f.L);
  if (!(cosine > 0.0)) return f;
  f.n_dot_l = cosine;
#endif
#ifdef SPECULAR
#ifdef HALF_VECTOR
  vec3 H = unit(f.L + V);
  f.lobe = lobe_power(N, H, max(dot(N, H), 0.0), material.n);
#endif
#ifdef REFLECTION_VECTOR
  vec3 R = 2.0 * cosine * N - f.L;
  f.lobe = lobe_power(R, V, max(dot(R, V), 0.0), material.n);
#endif
#endif
  return f;
}
#endif
#endif

#ifdef RADIOSITY
// B: light of a radiosity solution, in place of I_a k_a and I_ai k_a.
vec3 light_point(vec3 P, vec3 N, vec3 B) {
#else
vec3 light_point(vec3 P, vec3 N) {
#endif
  vec3 I = vec3(0.0);
#ifdef EMISSION
  I += material.emission;
#endif
#ifdef AMBIENT
  I += ambient * material.k_a;
#endif
#ifdef RADIOSITY
  I += B;
#endif
#ifdef LIT
  vec3 V = vec3(0.0, 0.0, 1.0);  // the unit vector towards the viewer
#ifdef LOCAL_VIEWER
  V = unit(-P);
#endif
  for (int i = 0; i < LIGHTS; ++i) {
    vec3 C = vec3(0.0);
#ifdef LIGHT_AMBIENT
    C += lights[i].ambient * material.k_a;
#endif
#ifdef DIRECTION
    LightFactors f = light_factors(lights[i], P, N, V);
#ifdef DIFFUSE
    C += lights[i].diffuse * material.k_d * f.n_dot_l;
#endif
#ifdef SPECULAR
    C += lights[i].specular * material.k_s * f.lobe;
#endif
#ifdef SCALED
    C *= f.share;
#endif
#endif
    I += C;
  }
#endif
#ifdef CLAMP
  return saturate(I);
#else
  return I;
#endif
}
