// Geometry at its extremes in float: slivers, far planes, shared edges, large offsets.
// This work is based on: Jonathan Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates, 1997 (edges); Nathan Reed, Depth Precision Visualized, 2015 (reversed depth).
#include <cmath>

#include "measure/arithmetic.h"
#include "measure/extreme_scenes.h"
#include "measure/extreme_tables.h"
#include "params/numbers.h"
#include "shading/surface.h"

namespace cg {

namespace {

using Rows = std::vector<Naive::Row>;
using P2 = glm::dvec2;

// The weight of c at p, from areas; exact inputs in float.
template <class Real>
Real weight(const P2& a, const P2& b, const P2& c, const P2& p, bool local) {
  const auto area = [&](const P2& u, const P2& v, const P2& w) {
    if (local)  // relative to one corner, as TriangleWeights
      return (Real(v.x) - Real(u.x)) * (Real(w.y) - Real(u.y)) - (Real(w.x) - Real(u.x)) * (Real(v.y) - Real(u.y));
    return (Real(u.x) * Real(v.y) - Real(v.x) * Real(u.y)) + (Real(v.x) * Real(w.y) - Real(w.x) * Real(v.y)) +
           (Real(w.x) * Real(u.y) - Real(u.x) * Real(w.y));
  };
  return area(a, b, p) / area(a, b, c);
}

// A triangle of height h beside a long edge, far from the picture's corner; p is a quarter of the way up.
Rows slivers() {
  Rows rows;
  for (const double h : {1.0, 0x1p-6, 0x1p-10, 0x1p-13}) {
    const P2 a{1024, 1024}, b{1536, 1024}, c{1024, 1024 + h}, p{1100, 1024 + h / 4};
    rows.push_back(
        {"height " + number_text(h), weight<float>(a, b, c, p, false), weight<double>(a, b, c, p, true), 0.25});
  }
  return rows;
}

// The distance z read back from a depth buffer of float, near = 1e-4, far = 1e4.
Rows depths() {
  constexpr double n = 1e-4, f = 1e4;
  Rows rows;
  for (const double z : {1.0, 100.0, 9000.0}) {
    const float usual = float((1 / n - 1 / z) / (1 / n - 1 / f));
    const float reversed = float((1 / z - 1 / f) / (1 / n - 1 / f));
    rows.push_back({"z = " + number_text(z) + " m", 1 / (1 / n - usual * (1 / n - 1 / f)),
                    1 / (1 / f + reversed * (1 / n - 1 / f)), z});
  }
  return rows;
}

// On which side of the edge a-b the origin lies, seen from each of its two triangles: opposite, or neither.
template <class Side>
int disagreements(Side side, double size) {
  std::uint32_t state = 12345;
  const auto random = [&] {
    state = state * 1664525u + 1013904223u;
    return float((double(state >> 8) / 0x1p24 - 0.5) * size);
  };
  int wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    const float ax = random(), ay = random(), t = random();
    const float bx = -ax * t, by = -ay * t;  // the origin lies on the edge, up to rounding
    wrong += side(ax, ay, bx, by) != -side(bx, by, ax, ay);
  }
  return wrong;
}

int sign(float x) { return (x > 0) - (x < 0); }

Rows shared_edges() {
  Rows rows;
  for (const double size : {1.0, 1000.0}) {
    const int contracted =
        disagreements([](float ax, float ay, float bx, float by) { return sign(std::fma(ax, by, -(ay * bx))); }, size);
    const int plain =
        disagreements([](float ax, float ay, float bx, float by) { return sign(ax * by - ay * bx); }, size);
    rows.push_back({"20 000 edges of size " + number_text(size), double(contracted), double(plain), 0});
  }
  return rows;
}

Rows offsets() {
  Rows rows;
  for (const double offset : {1e3, 1e6, 1e8}) {
    const double p = offset + 0.3;
    rows.push_back({"offset " + number_text(offset), float(p) - float(offset), float(p - offset), p - offset});
  }
  return rows;
}

// The normal of a triangle of extreme size in the plane x = z, as its y and z are crossed.
Rows face_normals() {
  Rows rows;
  for (const double size : {1e-20, 1e-12, 1.0, 1e12, 1e20}) {
    const auto f = [size](double x, double y, double z) { return Vec3<float>(glm::dvec3(x, y, z) * size); };
    const Vec3<float> n = glm::cross(f(1, 0, 1), f(0, 1, 0));
    const MeshHandle mesh =
        mesh_of_faces({glm::dvec3(0), glm::dvec3(size, 0, size), glm::dvec3(0, size, 0)}, {{0, 1, 2}});
    const SurfaceHandle surface = make_surface(*mesh, NormalRule::face, 180);
    const double robust = surface->normals.empty() ? 0 : double(surface->normals[0].z);
    rows.push_back({"size " + number_text(size), n.z / std::sqrt(glm::dot(n, n)), robust, std::sqrt(0.5)});
  }
  return rows;
}

Rows flat_matrices() {
  Rows rows;
  for (const double s : {1.0, 1e-30, 0.0}) {
    const glm::dmat4 m = scaling({1, 1, s});
    const glm::mat3 inverse = glm::inverse(glm::mat3(m));  // adjugate over determinant
    const glm::vec3 naive = glm::transpose(inverse) * glm::vec3(0.0f, 0.6f, 0.8f);
    const glm::dvec3 robust = unit(normal_matrix(m) * glm::dvec3(0, 0.6, 0.8));
    const glm::dvec3 right = glm::normalize(glm::dvec3(0, 0.6 * s, 0.8));
    rows.push_back({"scale 1, 1, " + number_text(s), (naive / std::sqrt(glm::dot(naive, naive))).z, robust.z, right.z});
  }
  return rows;
}

Rows views() {
  Rows rows;
  for (const double d : {1.0, 0.0}) {
    const Vec3<float> way(0.0f, 0.0f, float(-d));
    const glm::dmat4 m = look_at({0, 0, 3}, {0, 0, 3 - d}, {0, 1, 0});
    rows.push_back(
        {"target " + number_text(d) + " m before the eye", -(way / std::sqrt(glm::dot(way, way))).z, m[2][2], 1});
  }
  return rows;
}

Rows middles() {
  Rows rows;
  for (const double size : {1.0, 3e38}) {
    const float a = float(size), b = float(size / 2);
    rows.push_back({"of " + number_text(size) + " and half of it", (a + b) / 2, a * 0.5f + b * 0.5f, size * 0.75});
  }
  return rows;
}

}  // namespace

void add_geometry_arithmetic(ExtremeTable& all) {
  all.push_back(naive_case("sliver", {"Barycentric weights in a sliver", "細い三角形の重心座標"}, "height",
                           "1 … 1e-4 pixels",
                           {"1/4: the point lies a quarter of the way up.", "1/4。点は高さの四分の一にある。"}, 1e-6,
                           {"sums of x_i y_j, in float",
                            "differences to a corner, in double",
                            {"Products of 1e6 round to 0.06, more than the whole area of the sliver.",
                             "1e6 の積は 0.06 まで丸められ、三角形全体の面積より大きな誤差になるため。"},
                            slivers}));
  all.push_back(
      naive_case("far-depth", {"Distance from a depth buffer", "奥行きバッファから求めた距離"}, "camera.near",
                 "1e-4, far 1e4", {"The distance itself.", "距離そのもの。"}, 1e-5,
                 {"d = (1/n - 1/z) / (1/n - 1/f)",
                  "d = (1/z - 1/f) / (1/n - 1/f)",
                  {"All that is far lies next to d = 1, where float has its coarsest steps; next to 0 they are fine.",
                   "遠くはすべて d = 1 の近くに集まり、float の刻みはそこで最も粗い。0 の近くなら細かい。"},
                  depths}));
  all.push_back(naive_case(
      "shared-edge", {"A pixel on the edge of two triangles", "二つの三角形が共有する辺の上の画素"}, "edge",
      "through the pixel's centre", {"None is on the same side of both.", "両方の内側や外側にはならない。"}, 0,
      {"fma(a.x, b.y, -(a.y b.x))",
       "a.x b.y - a.y b.x",
       {"A contracted multiply-add rounds one product and not the other, so a-b and b-a do not cancel.",
        "縮約した積和は片方の積だけを丸めるので、a-b と b-a の符号が反対にならないため。"},
       shared_edges}));
  all.push_back(naive_case("offset", {"Survey coordinates", "測量座標のような大きな値"}, "OBJ file, v", "1e6 + 0.3",
                           {"0.3.", "0.3。"}, 1e-6,
                           {"float(p) - float(o)",
                            "float(p - o)",
                            {"float's steps at 1e6 are 0.06: the offset is to be subtracted before it is rounded.",
                             "1e6 での float の刻みは 0.06。丸める前に引かなければならない。"},
                            offsets}));
  all.push_back(
      naive_case("face-normal", {"The normal of a face of extreme size", "極端な大きさの面の法線"}, "size", "1e±20",
                 {"1/√2.", "1/√2。"}, 1e-6,
                 {"e1 × e2 / |e1 × e2|",
                  "scaled to size 1 in double first",
                  {"A cross product squares the size and its length does so again: 1e-80 is 0, and 0/0 is NaN.",
                   "外積で大きさは二乗、長さでさらに二乗になる。1e-80 は 0 になり、0/0 は NaN。"},
                  face_normals}));
  all.push_back(naive_case(
      "flat-matrix", {"Normals under a scale that flattens", "平らに潰す変換での法線"}, "objects.0.transform.scale",
      "1, 1, 0", {"The limit: across what was flattened.", "極限の向き。潰れた方向を向く。"}, 1e-6,
      {"inverse(M)^T n",
       "cofactors(M) n, made unit",
       {"The inverse divides by the determinant, which is 0; the cofactors have the same direction without it.",
        "逆行列は行列式 0 で割る。余因子行列なら割らずに同じ向きが得られる。"},
       flat_matrices}));
  all.push_back(naive_case("look-at", {"The axis of an eye at its target", "視点と注視点が同じときの軸"},
                           "camera.target", "the eye", {"A unit axis: z.", "単位長の軸。z 軸。"}, 1e-12,
                           {"(eye - target) / |eye - target|",
                            "-z where they are one",
                            {"0/0 is NaN, and with it the whole matrix.", "0/0 は NaN で、行列全体が NaN になるため。"},
                            views}));
  all.push_back(naive_case("middle", {"The middle of a large box", "大きな箱の中心"}, "v", "3e38",
                           {"3/4 of it.", "その 3/4。"}, 1e-6,
                           {"(a + b) / 2",
                            "a/2 + b/2",
                            {"The sum is over 3.4e38 before it is halved.", "半分にする前に和が 3.4e38 を超えるため。"},
                            middles}));
}

}  // namespace cg
