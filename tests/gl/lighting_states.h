// Random states of lights, materials and normals for the lighting equation alone: each pixel of a float picture
// shows one point with a state of its own, and is compared with the light model in double.
#pragma once
#include <functional>
#include <random>
#include <vector>

#include "gl/fixed_player.h"
#include "gl/frame_target.h"
#include "gl/gl_thread.h"
#include "gl/program.h"
#include "gl/surface_buffers.h"
#include "shading/clip_position.h"

namespace cg {

using Random = std::mt19937_64;

inline double uniform(Random& r, double low, double high) { return low + (high - low) * (double(r() >> 11) * 0x1p-53); }
inline glm::dvec3 colour(Random& r) { return {uniform(r, 0, 1), uniform(r, 0, 1), uniform(r, 0, 1)}; }
inline glm::dvec3 direction(Random& r) {
  const double z = uniform(r, -1, 1), a = uniform(r, 0, 2 * pi), s = std::sqrt(1 - z * z);
  return {s * std::cos(a), s * std::sin(a), z};
}

// A light 4 to 10 m from the origin; the points lie within 3.5 m of it.
inline Light random_light(Random& r, LightKind kind) {
  Light l;
  l.kind = kind;
  l.position = direction(r) * uniform(r, 4, 10);
  l.ambient = colour(r), l.diffuse = colour(r), l.specular = colour(r);
  return l;
}
inline void add_attenuation(Random& r, Light& l) {
  l.k_0 = uniform(r, 0.1, 1.5), l.k_1 = uniform(r, 0, 1), l.k_2 = uniform(r, 0, 0.5);
}
inline Light random_spot(Random& r, double exponent) {
  Light l = random_light(r, LightKind::spot);
  l.direction = -l.position + direction(r) * 3.0;
  l.cutoff = uniform(r, 5, 90);
  l.exponent = exponent;
  return l;
}

// One kind of state: the part of a scene that it draws at random. The rest is OpenGL's default, unclamped.
struct StateKind {
  const char* name;
  std::function<void(Random&, Scene&)> state;
  glm::dvec3 scale{1, 1, 1};         // of the object: powers of two, so that positions stay exact
  double shortest = 1, longest = 1;  // of the normals
};

inline std::vector<StateKind> state_kinds() {
  const auto lights = [](int count, auto make) {
    return [=](Random& r, Scene& s) {
      for (int i = 0; i < count; ++i) s.lights.push_back(make(r));
    };
  };
  const auto directional = [](Random& r) { return random_light(r, LightKind::directional); };
  const auto point = [](Random& r) { return random_light(r, LightKind::point); };
  const auto fading = [](Random& r) {
    Light l = random_light(r, LightKind::point);
    add_attenuation(r, l);
    return l;
  };
  const auto spot = [](double exponent) { return [=](Random& r) { return random_spot(r, exponent); }; };
  const auto with_n = [=](double n) {
    return [=](Random& r, Scene& s) {
      s.lights.push_back(directional(r));
      s.material.n = n;
    };
  };
  const auto any_mixture = [=](Random& r, Scene& s) {
    const LightKind kinds[] = {LightKind::directional, LightKind::point, LightKind::spot, LightKind::point};
    for (const LightKind kind : kinds) {
      Light l = kind == LightKind::spot ? random_spot(r, uniform(r, 0, 128)) : random_light(r, kind);
      add_attenuation(r, l);
      l.w = uniform(r, 0.5, 2);
      s.lights.push_back(l);
    }
    s.material.emission = colour(r);
    s.material.color = colour(r);
    s.shading.color_material = ColorMaterial::ambient_and_diffuse;
  };
  return {
      {"directional", lights(1, directional)},
      {"local viewer", [=](Random& r, Scene& s) { s.shading.local_viewer = true, s.lights.push_back(directional(r)); }},
      {"point, attenuated", lights(1, fading)},
      {"8 points", lights(8, point)},
      {"8 spots, exponent 0", lights(8, spot(0))},
      {"8 spots, exponent 10", lights(8, spot(10))},
      {"8 spots, exponent 128", lights(8, spot(128))},
      {"4 kinds, w, emission, colour material", any_mixture},
      {"GL_NORMALIZE, stretched", lights(1, directional), {0.5, 2, 1}, 0.1, 10},
      {"GL_RESCALE_NORMAL",
       [=](Random& r, Scene& s) {
         s.shading.normal_length = NormalLength::rescale, s.lights.push_back(directional(r));
       },
       {0.25, 0.25, 0.25}},
      {"normals as they come",
       [=](Random& r, Scene& s) {
         s.shading.normal_length = NormalLength::off, s.lights.push_back(directional(r)), s.material.n = 2;
       },
       {1, 1, 1},
       0.5,
       1.2},
      {"n = 0", with_n(0)},
      {"n = 1", with_n(1)},
      {"n = 128", with_n(128)},
      {"n = 0, attenuated", [=](Random& r, Scene& s) { s.lights.push_back(fading(r)), s.material.n = 0; }},
  };
}

inline Scene random_scene(Random& r, const StateKind& kind) {
  Scene s;
  s.objects.resize(1);
  s.lights.clear();
  s.shading.clamp = false;
  s.shading.ambient = colour(r);
  s.material.k_a = colour(r), s.material.k_d = colour(r), s.material.k_s = colour(r);
  s.material.n = uniform(r, 1, 128);
  s.camera.position = direction(r) * uniform(r, 0.1, 1);
  s.camera.target = direction(r);
  kind.state(r, s);
  return s;
}

// A batch of points under one scene; each point has a pixel of its own.
struct Batch {
  Scene scene;
  std::size_t first, count;
};

struct Points {
  static constexpr int side = 64;  // pixels
  std::vector<Batch> batches;
  std::vector<glm::vec3> P, N;  // in object coordinates
  std::vector<int> pixel;       // x + y * side, from the bottom
};

inline constexpr double half_extent = 2;  // the picture shows -2..2 in x and y, z too

inline Points random_points(Random& r, const StateKind& kind, std::size_t a_batch = 64) {
  Points p;
  constexpr int n = Points::side * Points::side;
  for (int i = 0; i < n; ++i) p.pixel.push_back(i);
  for (int i = n - 1; i > 0; --i) std::swap(p.pixel[std::size_t(i)], p.pixel[std::size_t(r() % std::uint64_t(i + 1))]);
  for (int i = 0; i < n; ++i) {
    if (std::size_t(i) % a_batch == 0) p.batches.push_back({random_scene(r, kind), std::size_t(i), a_batch});
    const int x = p.pixel[std::size_t(i)] % Points::side, y = p.pixel[std::size_t(i)] / Points::side;
    const double step = 2 * half_extent / Points::side;
    const glm::dvec3 at((x + 0.5) * step - half_extent, (y + 0.5) * step - half_extent, uniform(r, -1.9, 1.9));
    p.P.emplace_back(at / kind.scale);
    p.N.emplace_back(direction(r) * uniform(r, kind.shortest, kind.longest));
  }
  return p;
}

// Eye space is what the picture shows, so positions and pixels belong together whatever the camera is.
inline glm::mat4 points_projection() { return glm::mat4(scaling(glm::dvec3(1 / half_extent))); }

class LightingPictures {
 public:
  LightingPictures() {
    legacy_.at_exit([this] { fixed_target_.release(); });
    core_.at_exit([this] { glsl_target_.release(), programs_.clear(); });
  }

  std::vector<glm::vec4> fixed(const Points& p, const StateKind& kind) {
    std::vector<glm::vec4> out;
    legacy_.run([&] { out = draw_fixed(p, kind); });
    return out;
  }
  std::vector<glm::vec4> glsl(const Points& p, const StateKind& kind) {
    std::vector<glm::vec4> out;
    core_.run([&] { out = draw_glsl(p, kind); });
    return out;
  }

 private:
  std::vector<glm::vec4> draw_fixed(const Points& p, const StateKind& kind) {
    fixed_target_.bind(Points::side, Points::side, {});
    fixed_target_.clear(glm::vec3(-1));
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, p.P.data());
    glNormalPointer(GL_FLOAT, 0, p.N.data());
    const glm::mat4 projection = points_projection(), object(scaling(kind.scale));
    for (const Batch& b : p.batches) {
      FixedPlayer player(1);
      for (const GlCall& call : gl_calls(b.scene))
        if (call.section <= GlSection::lights || call.section == GlSection::material) player.play(call);
      glMatrixMode(GL_PROJECTION);
      glLoadMatrixf(&projection[0].x);
      glMatrixMode(GL_MODELVIEW);
      glLoadMatrixf(&object[0].x);
      glDrawArrays(GL_POINTS, GLint(b.first), GLsizei(b.count));
    }
    return fixed_target_.read_floats(0);
  }

  std::vector<glm::vec4> draw_glsl(const Points& p, const StateKind& kind) {
    glsl_target_.bind(Points::side, Points::side, {});
    glsl_target_.clear(glm::vec3(-1));
    GLuint array = 0, buffers[2];
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(2, buffers);
    const std::vector<glm::vec3>* data[2] = {&p.P, &p.N};
    for (GLuint i = 0; i < 2; ++i) {
      glBindBuffer(GL_ARRAY_BUFFER, buffers[i]);
      glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(data[i]->size() * sizeof(glm::vec3)), data[i]->data(), GL_STREAM_DRAW);
      glEnableVertexAttribArray(i == 0 ? position_attribute : normal_attribute);
      glVertexAttribPointer(i == 0 ? position_attribute : normal_attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    }
    Plan plan;
    for (const char* id : {"highlights", "local-viewer", "attenuation", "spot-cones"})
      plan.passes.push_back({.id = id, .name = {}, .needed = true, .reason = {}});
    const glm::mat4 object(scaling(kind.scale));
    for (const Batch& b : p.batches) {
      const glm::dmat4 view = view_matrix(b.scene.camera);
      const auto lighting = lighting_in_eye_space<float>(b.scene, view);
      const auto material = eye_material<float>(b.scene.material, b.scene.shading.color_material);
      Plan of_this = plan;
      of_this.passes[1].needed = b.scene.shading.local_viewer;
      Program& program = programs_.get(shader_features(b.scene.shading, of_this, lighting, material));
      program.use();
      program.set(lighting, material, material);
      program.set("surface_to_clip", surface_to_clip(points_projection(), object));
      program.set("surface_to_eye", object);
      program.set("normal_to_eye", normals_to_eye<float>(scaling(kind.scale), b.scene.shading.normal_length).matrix);
      glDrawArrays(GL_POINTS, GLint(b.first), GLsizei(b.count));
    }
    glDeleteVertexArrays(1, &array);
    glDeleteBuffers(2, buffers);
    return glsl_target_.read_floats(0);
  }

  FrameTarget fixed_target_, glsl_target_;
  ProgramCache programs_;
  GlThread legacy_{GlProfile::legacy}, core_{GlProfile::core};
};

// Where the light model itself jumps, rounding decides: on the edge of a cone (within 1e-5 of its cosine) and where
// the light stands in the plane of the surface (N.L within 1e-6 of 0, where the highlight begins).
inline bool on_an_edge(const EyeLighting<double>& lighting, const glm::dvec3& P, const glm::dvec3& N) {
  for (const EyeLight<double>& light : lighting.lights) {
    const glm::dvec3 L = light.directional ? light.position : unit(light.position - P);
    if (light.spot_cosine > -2 && std::abs(-glm::dot(L, light.spot_direction) - light.spot_cosine) < 1e-5) return true;
    if (std::abs(glm::dot(N, L)) < 1e-6) return true;
  }
  return false;
}

// Mesa takes an exponent of exactly 0 wrong where a light has a position, so gl-fixed sends 1e-6 for it, and max(N.H,
// 0)^0 = 1 becomes 0 where N.H <= 0: known and said in the plan, and left out here.
inline bool meets_the_fault(const EyeLighting<double>& lighting, const EyeMaterial<double>& m, const glm::dvec3& P,
                            const glm::dvec3& N) {
  if (m.n != 0) return false;
  const glm::dvec3 V = towards_viewer(lighting.local_viewer, P);
  for (const EyeLight<double>& light : lighting.lights)
    if (!light.directional && glm::dot(N, unit(light.position - P) + V) < 1e-6) return true;
  return false;
}

struct StateErrors {
  double largest = 0;
  std::size_t states = 0, left_out = 0, faults = 0, not_finite = 0;
};

inline void compare(const Points& p, const StateKind& kind, const std::vector<glm::vec4>& pixels, StateErrors& e) {
  for (const Batch& b : p.batches) {
    const auto lighting = lighting_in_eye_space<double>(b.scene, view_matrix(b.scene.camera));
    const auto material = eye_material<double>(b.scene.material, b.scene.shading.color_material);
    const auto normals = normals_to_eye<double>(scaling(kind.scale), b.scene.shading.normal_length);
    for (std::size_t i = b.first; i < b.first + b.count; ++i) {
      const glm::dvec3 P = glm::dvec3(p.P[i]) * kind.scale, N = eye_normal(normals, glm::dvec3(p.N[i]));
      if (on_an_edge(lighting, P, N)) {
        ++e.left_out;
        continue;
      }
      if (meets_the_fault(lighting, material, P, N)) {
        ++e.faults;
        continue;
      }
      const glm::dvec3 c(pixels[std::size_t(p.pixel[i])]), d = glm::abs(c - light_point(lighting, material, P, N));
      ++e.states;
      if (!is_finite(c)) ++e.not_finite;
      e.largest = std::max({e.largest, d.x, d.y, d.z});
    }
  }
}

}  // namespace cg
