#include "tests/extremes/extreme_cases.h"

#include "tests/gl/gl_scenes.h"

namespace cg {

namespace {

MeshHandle faces(std::vector<glm::dvec3> positions, const std::vector<std::vector<std::uint32_t>>& polygons) {
  MeshData d;
  d.positions = std::move(positions);
  for (const auto& polygon : polygons) {
    std::vector<Corner> corners;
    for (const std::uint32_t i : polygon) corners.push_back({i, no_index, no_index});
    d.add_face(corners.data(), corners.data() + corners.size());
  }
  return Mesh::make(std::move(d));
}

MeshHandle sphere_with_normals(double length) {
  MeshData d = sphere_mesh()->data();
  for (const glm::dvec3& p : d.positions) d.normals.push_back(p * length);
  for (Corner& c : d.corners) c.normal = c.position;
  return Mesh::make(std::move(d));
}

Change mesh(MeshHandle m) {
  return [m](Scene& s) { s.objects[0].mesh = m; };
}

// A light of that kind, with the rest as it was.
Change kind(LightKind k) {
  return [k](Scene& s) { s.lights[0].kind = k; };
}

Change position(const glm::dvec3& p, double w = 1, LightKind k = LightKind::point) {
  return [=](Scene& s) { s.lights[0].position = p, s.lights[0].w = w, s.lights[0].kind = k; };
}

Change both(Change a, Change b) {
  return [=](Scene& s) { a(s), b(s); };
}

// A square in the plane z = 0 before the eye, whose highlights are thin.
void square(Scene& s) { s.objects[0].mesh = square_mesh(), s.camera.position = {0, 0, 4}, s.material.n = 32; }

// Two pages that stand at a right angle, open to the light; the light in a corner of the left.
void light_at_a_vertex(Scene& s) {
  s.objects[0].mesh =
      faces({{-1, -1, 1}, {0, -1, 0}, {1, -1, 1}, {-1, 1, 1}, {0, 1, 0}, {1, 1, 1}}, {{0, 1, 4, 3}, {1, 2, 5, 4}});
  s.camera.position = {0, 0, 4};
  s.lights[0].position = {-1, 1, 1};
}

// All of `polygons`, lit by their face's normal, beside each as an object of its own.
ExtremeCase as_single_faces(std::string name, std::vector<glm::dvec3> positions,
                            std::vector<std::vector<std::uint32_t>> polygons) {
  const auto view = [](Scene& s) {
    s.shading.normals = NormalRule::face, s.shading.two_sided = true, s.camera.position = {0.5, 1.5, 3.5};
  };
  return {std::move(name), both(view, mesh(faces(positions, polygons))), [=](Scene& s) {
            view(s);
            s.objects.assign(polygons.size(), s.objects[0]);
            for (std::size_t i = 0; i < polygons.size(); ++i) s.objects[i].mesh = faces(positions, {polygons[i]});
          }};
}

}  // namespace

void unlit(Scene& s) { s.lights.clear(); }

std::vector<ExtremeCase> extreme_lights() {
  const auto attenuated = [](double k_0, double k_1, double k_2) {
    return [=](Scene& s) { s.lights[0].k_0 = k_0, s.lights[0].k_1 = k_1, s.lights[0].k_2 = k_2; };
  };
  const auto ambient = [](Scene& s) { s.lights[0].ambient = {0.6, 0.4, 0.2}, s.lights[0].k_1 = 0.5; };
  std::vector<ExtremeCase> all{
      {"none", unlit},
      {"in the surface's plane", both(both(square, ambient), position({3, 0, 0}))},
      {"in the surface", both(both(square, ambient), position({0.3, 0.2, 0}))},
      {"behind the surface", both(both(square, ambient), position({0, 0, -3}))},
      {"inside", position({0, 0, 0})},
      {"at a vertex", light_at_a_vertex},
      {"at the eye", [](Scene& s) { s.lights[0].position = s.camera.position; }},
      {"attenuation 0, 0, 0", attenuated(0, 0, 0), attenuated(1, 0, 0), "attenuation 0, 0, 0"},
      {"attenuation 1e20", attenuated(1e20, 1e20, 1e20), unlit},
      {"attenuated from 1e20 away", both(position({0, 0, 1e20}), attenuated(1, 0, 1)), unlit},
      {"attenuation of float's least numbers, from as far", both(position({0, 0, 1e20}), attenuated(0, 0, 4e-38))},
      {.name = "attenuation below them",
       .change = both(position({0, 0, 1e20}), attenuated(0, 0, 4e-40)),
       .denormal = true},
      {"1e20 away", position({1e20, 2e20, 3e20}), position({1, 2, 3}, 1, LightKind::directional)},
      {"1e-20 away from the middle", position({1e-20, 2e-20, 3e-20})},
      {"w = 0", position({1, 2, 3}, 0), position({1, 2, 3}, 1, LightKind::directional)},
      {"w = 1e-30", position({1, 2, 3}, 1e-30), position({1, 2, 3}, 1, LightKind::directional), "w next to 0"},
      {"w = 1e-7", position({1, 2, 3}, 1e-7), position({1, 2, 3}, 1, LightKind::directional), "w next to 0"},
      {"w = -1", position({1, 2, 3}, -1), position({-1, -2, -3})},
      {"w = 0 at 0", position({0, 0, 0}, 0), unlit},
      {"switched off", [](Scene& s) { s.lights[0].enabled = false; }, unlit},
      {"nine",
       [](Scene& s) {
         s.lights.resize(9, s.lights[0]), s.lights[8].diffuse = {0, 0, 1};
       },
       {},
       {},
       [](Scene& s) { s.lights.resize(8, s.lights[0]); },
       "the first 8 of 9"},
      {"64",
       [](Scene& s) {
         s.lights[0].diffuse = {0.01, 0.02, 0.03}, s.lights.resize(64, s.lights[0]);
       },
       {},
       {},
       [](Scene& s) {
         s.lights[0].diffuse = {0.01, 0.02, 0.03}, s.lights.resize(8, s.lights[0]);
       },
       "the first 8 of 64"},
      {"of 1e20", [](Scene& s) { s.lights[0].diffuse = glm::dvec3(1e20); }},
      {"negative",
       [](Scene& s) {
         s.lights[0].diffuse = {-0.5, -1e20, 0.5};
       }},
      {"NaN", [](Scene& s) { s.lights[0].diffuse.g = std::nan(""); }, unlit},
      {"infinite", [](Scene& s) { s.lights[0].specular.g = HUGE_VAL; }, unlit},
  };
  // Exactly grazing: neither diffuse light nor a highlight, and no leap to either side.
  for (const double z : {0.0, -0.0, -1e-8, 1e-8})
    all.push_back({"grazing", both(square, position({1, 0, z}, 1, LightKind::directional)), both(square, unlit)});
  return all;
}

std::vector<ExtremeCase> extreme_cones() {
  std::vector<ExtremeCase> all;
  const auto spot = [](double cutoff, double exponent, double w = 1, glm::dvec3 axis = {-1, -1.1, -3}) {
    return [=](Scene& s) {
      s.lights[0].kind = LightKind::spot, s.lights[0].position = {1, 1, 3}, s.lights[0].direction = axis;
      s.lights[0].cutoff = cutoff, s.lights[0].exponent = exponent, s.lights[0].w = w;
    };
  };
  for (const double cutoff : {1.0, 90.0})
    for (const double exponent : {0.0, 1.0, 128.0})
      all.push_back({"cut-off " + std::to_string(cutoff), spot(cutoff, exponent)});
  all.push_back({"cut-off 0: its axis alone", spot(0, 0), unlit});
  all.push_back({"cut-off 180: no cone", spot(180, 0), position({1, 1, 3})});
  all.push_back({"cut-off 180: no exponent either", spot(180, 128), position({1, 1, 3})});
  all.push_back({"no axis", spot(90, 0, 1, {0, 0, 0}), unlit});
  all.push_back({"parallel, in the cone", spot(30, 0, 0), position({1, 1, 3}, 1, LightKind::directional)});
  all.push_back({"parallel, with an exponent", spot(30, 128, 0)});
  all.push_back({"parallel, out of the cone", spot(30, 0, 0, {1, 0, 0}), unlit});
  all.push_back({"parallel, half-space behind", spot(90, 0, 0, {1, 1, 3}), unlit});
  return all;
}

std::vector<ExtremeCase> extreme_materials() {
  std::vector<ExtremeCase> all;
  const auto n = [](double n) { return [n](Scene& s) { s.material.n = n; }; };
  for (const double x : {0.0, 1e-9, 128.0}) all.push_back({"n = " + std::to_string(x), n(x)});
  all[0].fixed_note = "n = 0";
  for (const double x : {129.0, 1e4, 1e6})
    all.push_back({"n = " + std::to_string(x), n(x), {}, {}, n(128), "ends at 128"});
  for (const double k : {0.0, 0.999, 1.0})  // the sum is up to 3: clamped
    all.push_back({"k = " + std::to_string(k), [k](Scene& s) {
                     s.material.k_a = s.material.k_d = s.material.k_s = glm::dvec3(k), s.shading.ambient = {1, 0.5, 0};
                   }});
  all.push_back({"ambient NaN", [](Scene& s) { s.shading.ambient.g = std::nan(""), unlit(s); },
                 [](Scene& s) { s.shading.ambient.g = 0, unlit(s); }});
  all.push_back({"emission NaN", [](Scene& s) { s.material.emission = glm::dvec3(std::nan("")); },
                 [](Scene& s) {
                   s.material.k_a = s.material.k_d = s.material.k_s = {0, 0, 0};
                 }});
  return all;
}

std::vector<ExtremeCase> extreme_surfaces() {
  std::vector<ExtremeCase> all;
  for (const double length : {1e-30, 1e-20, 1e20, 1e30})
    all.push_back({"normals of length " + std::to_string(std::log10(length)), mesh(sphere_with_normals(length)),
                   mesh(sphere_with_normals(1))});
  all.push_back({.name = "normals of length 0",
                 .change = mesh(sphere_with_normals(0)),
                 .same_as = unlit,
                 .note = "no normal",
                 .flat = false});
  all.push_back({"stretched", [](Scene& s) { s.objects[0].transform.scale = {1, 1e-3, 1}; }});
  all.push_back({"mirrored", [](Scene& s) { s.objects[0].transform.scale = {-1, 1.5, 0.5}; }});
  for (const double x : {1.0, -1.0})
    all.push_back({"mirrored, two sides", [x](Scene& s) {
                     square(s), s.objects[0].transform.scale = {x, 1, 1}, s.objects[0].transform.rotate = {0, 160, 0};
                     s.shading.two_sided = true;
                   }});

  const std::vector<glm::dvec3> corners{{-1, -1, 0}, {1, -1, 0},           {1, 1, 0},
                                        {-1, 1, 0},  {0.3, -1 + 1e-30, 0}, {0, -1, 0}};
  all.push_back({"a sliver and a face without area",
                 both(square, mesh(faces(corners, {{0, 1, 2, 3}, {0, 1, 4}, {0, 5, 1}}))), square});
  all.push_back({"a corner named twice", both(square, mesh(faces(corners, {{0, 0, 1, 1, 1, 2, 3, 0}}))), square});
  all.push_back({"one vertex named thrice", both(square, mesh(faces(corners, {{0, 1, 2, 3}, {2, 2, 2}}))), square});
  // Under a directional light, as a face is lit at its last corner.
  const std::vector<glm::dvec3> dart{{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {0.6, 0, 0}};
  const auto dart_of = [&](const std::vector<std::vector<std::uint32_t>>& polygons) {
    return both(both(square, kind(LightKind::directional)), mesh(faces(dart, polygons)));
  };
  for (const auto& quad :
       std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3}, {1, 2, 3, 0}, {2, 3, 0, 1}, {3, 0, 1, 2}})
    all.push_back({"a concave face", dart_of({quad}), dart_of({{0, 1, 3}, {3, 1, 2}})});

  const std::vector<glm::dvec3> fan{{0, -1, 0}, {0, 1, 0}, {1, 0, 0.3}, {-1, 0, 0.3}, {0, 0, 1}};
  all.push_back(as_single_faces("an edge of three faces", fan, {{0, 2, 1}, {0, 1, 3}, {0, 4, 1}}));
  all.push_back(as_single_faces("a face twice", fan, {{0, 2, 1}, {0, 2, 1}, {0, 1, 3}}));
  all.push_back(as_single_faces("faces wound against one another", fan, {{0, 2, 1}, {0, 3, 1}}));

  const Change parallel = kind(LightKind::directional);
  for (const double size : {1e-20, 1e-6, 1e6, 1e20}) {
    const auto seen = [=](Scene& s) {
      parallel(s), s.camera.position *= size, s.camera.near_plane *= size, s.camera.far_plane *= size;
    };
    all.push_back({"size " + std::to_string(std::log10(size)), both(seen, mesh(sphere_mesh(24, 12, size))), parallel});
    all.push_back({"scaled " + std::to_string(std::log10(size)),
                   both(seen, [=](Scene& s) { s.objects[0].transform.scale = glm::dvec3(size); }), parallel});
  }
  const glm::dvec3 far(1e6, -2e6, 3e6);
  all.push_back({"1e6 away from the origin",
                 [=](Scene& s) {
                   s.objects[0].mesh = sphere_mesh(24, 12, 1, far);
                   s.camera.position += far, s.camera.target += far, s.lights[0].position += far;
                 },
                 [](Scene&) {}});
  return all;
}

std::vector<ExtremeCase> extreme_cameras() {
  const auto floor = [](Scene& s) {
    s.objects[0].mesh = square_mesh(), s.objects[0].transform.rotate = {-90, 0, 0};
    s.objects[0].transform.scale = glm::dvec3(50);
    s.camera.position = {0, 1, 0}, s.camera.target = {0, 0.8, -1};
  };
  std::vector<ExtremeCase> all{
      {"a floor under and behind the eye", floor},
      {"inside the object",
       [](Scene& s) {
         s.camera.position = {0, 0, 0.1}, s.shading.two_sided = true;
       }},
      {"eye and target in one place",
       [](Scene& s) {
         s.camera.position = s.camera.target = {0, 0, 3};
       },
       [](Scene& s) {
         s.camera.position = {0, 0, 3}, s.camera.target = {0, 0, 2};
       }},
      {"up along the view",
       [](Scene& s) {
         s.camera.position = {0, 0, 3}, s.camera.up = {0, 0, 1};
       }},
      {"no up",
       [](Scene& s) {
         s.camera.position = {0, 0, 3}, s.camera.up = {0, 0, 0};
       }},
      {"far before near", [](Scene& s) { s.camera.near_plane = 100, s.camera.far_plane = 0.1; }},
      {"orthographic, of height 1e-20",
       [](Scene& s) { s.camera.projection = Projection::orthographic, s.camera.height = 1e-20; }},
      {"orthographic, of height 1e20",
       [](Scene& s) { s.camera.projection = Projection::orthographic, s.camera.height = 1e20; }},
  };
  for (const double near_plane : {1e-20, 1e-4, 2.8, 100.0, 1e20})
    all.push_back({"near at " + std::to_string(near_plane), [=](Scene& s) { s.camera.near_plane = near_plane; }});
  for (const double fov : {1.0, 170.0})
    all.push_back({"field of view " + std::to_string(fov), [=](Scene& s) { s.camera.fov = fov; }});
  return all;
}

}  // namespace cg
