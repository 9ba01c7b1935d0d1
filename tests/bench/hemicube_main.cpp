// bench_hemicube [--pairs N]: a hemicube's row at R = 128, one position, beside the same by OpenGL (llvmpipe on the
// thread that calls it) and by Embree's packets of sixteen rays. They take turns in one process; CPU time of the whole
// process, one thread; medians, and medians of the ratios of neighbours. Not a test: a time is no promise on another
// machine.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "gl/hemicube_items.h"
#include "radiosity/hemicube_rows.h"
#include "scene/cpu_clock.h"
#include "tests/radiosity/patch_rooms.h"
#ifdef SHADEBENCH_EMBREE
#include <embree3/rtcore.h>
#endif

namespace {

using namespace cg;

constexpr int resolution = 128;

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.empty() ? 0 : v[v.size() / 2];
}

#ifdef SHADEBENCH_EMBREE
// The same pixels by rays, sixteen at once, one for each pixel of a tile.
class EmbreeItems {
 public:
  explicit EmbreeItems(std::span<const ItemPolygon> polygons) : device_(rtcNewDevice("threads=1")) {
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_QUAD);
    auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                3 * sizeof(float), 4 * polygons.size()));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
                                                                   4 * sizeof(unsigned), polygons.size()));
    for (std::size_t i = 0; i < polygons.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        for (int c = 0; c < 3; ++c) *corners++ = float(polygons[i][k][c]);
        *indices++ = unsigned(4 * i + k);
      }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~EmbreeItems() { rtcReleaseScene(scene_), rtcReleaseDevice(device_); }
  EmbreeItems(const EmbreeItems&) = delete;
  EmbreeItems& operator=(const EmbreeItems&) = delete;

  // The directions, on the cube's surface, are made before: they are the same for all positions but for a rotation.
  void draw(const HemicubeFrame& frame, HemicubeItems& items) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[16];
    std::fill(valid, valid + 16, -1);
    alignas(64) RTCRayHit16 rays;
    const glm::vec3 o(frame.position), fx(frame.x), fy(frame.y), fz(frame.z);
    for (const HemicubeFace f : hemicube_faces) {
      const FaceTiles places(f, resolution);
      for (std::size_t t = 0; t < places.count(); ++t) {
        const int x0 = int(t) % places.across * tile_side, y0 = int(t) / places.across * tile_side;
        const FacePoint<double> first = pixel_centre(f, x0, y0, resolution);
        const glm::dvec3 d0 = on_cube(f, first), ds = on_cube(f, {first.s + 1, first.t}) - d0,
                         dt = on_cube(f, {first.s, first.t + 1}) - d0;
        const auto turned = [&](const glm::dvec3& d) { return float(d.x) * fx + float(d.y) * fy + float(d.z) * fz; };
        const glm::vec3 corner = turned(d0), along_s = turned(ds) * (2.0f / resolution),
                        along_t = turned(dt) * (2.0f / resolution);
        for (int i = 0; i < 16; ++i) {
          const glm::vec3 d = corner + float(i % 4) * along_s + float(i / 4) * along_t;
          rays.ray.org_x[i] = o.x, rays.ray.org_y[i] = o.y, rays.ray.org_z[i] = o.z;
          rays.ray.dir_x[i] = d.x, rays.ray.dir_y[i] = d.y, rays.ray.dir_z[i] = d.z;
          rays.ray.tnear[i] = 1e-5f, rays.ray.tfar[i] = 1e30f, rays.ray.time[i] = 0;
          rays.ray.mask[i] = ~0u, rays.ray.flags[i] = 0;
          rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID, rays.hit.primID[i] = no_item;
          rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect16(valid, scene_, &context, &rays);
        std::memcpy(&items.tiles(f)[t].item, rays.hit.primID, sizeof rays.hit.primID);
      }
    }
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};
#endif

// One row: what is above the horizon, the item buffers, their weights added up.
struct Bench {
  Patches patches;
  std::vector<ItemPolygon> polygons = item_polygons(patches);
  ItemScene scene{polygons};
  TiledWeights weights{PixelWeights(resolution, PixelWeight::delta_form_factor)};
  DrawItems gl = gl_draw_items()(polygons);
#ifdef SHADEBENCH_EMBREE
  EmbreeItems embree{polygons};
#endif
  RowSums sums{};
  HemicubeItems items{};

  template <class Draw>
  double row_ms(std::uint32_t patch, const Draw& draw) {
    const Patch& p = patches.patches[patch];
    const double begin = process_cpu_ms();
    sums.begin(scene, p, patch);
    draw(hemicube_frame(p.centre, p.normal, patch % 4, 2));  // turned as one of 2 x 2 positions
    weights.add(items, 1, sums.of_patch.data(), sums.rest);
    const FormFactorRow row = sums.finish(true);
    const double ms = process_cpu_ms() - begin;
    if (row.sum < 0.99) std::printf("patch %u: a row's sum is %g\n", patch, row.sum);
    return ms;
  }
};

void run(const char* name, Patches patches, int pairs) {
  Bench bench{std::move(patches)};
  std::vector<double> ours, gl, embree, gl_ratio, embree_ratio;
  const auto software = [&](const HemicubeFrame& f) {
    draw_items(bench.scene, {}, f, resolution, bench.sums, bench.items);
  };
  const auto by_gl = [&](HemicubeFrame f) {
    f.staggered = false;  // it would draw the sides four times as fine
    draw_items(bench.scene, bench.gl, f, resolution, bench.sums, bench.items);
  };
  for (int i = -2; i < pairs; ++i) {
    const auto patch = std::uint32_t(std::uint64_t(i + 3) * 7919 % bench.patches.patches.size());
    const double a = bench.row_ms(patch, software), b = bench.row_ms(patch, by_gl);
    double c = 0;
#ifdef SHADEBENCH_EMBREE
    c = bench.row_ms(patch, [&](const HemicubeFrame& f) { bench.embree.draw(f, bench.items); });
#endif
    const double again = bench.row_ms(patch, software);
    if (i < 0) continue;  // warm
    ours.push_back(a), ours.push_back(again), gl.push_back(b), embree.push_back(c);
    gl_ratio.push_back(b / std::min(a, again)), embree_ratio.push_back(c / std::min(a, again));
  }
  std::printf(
      "%-18s %6zu patches: %7.3f ms   llvmpipe %8.3f ms, %5.1f times (goal 5)   Embree %7.3f ms, %5.1f times "
      "(goal 2)\n",
      name, bench.patches.patches.size(), median(ours), median(gl), median(gl_ratio), median(embree),
      median(embree_ratio));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int pairs = 25;
  for (int i = 1; i + 1 < argc; i += 2)
    if (std::strcmp(argv[i], "--pairs") == 0) pairs = std::max(1, std::atoi(argv[i + 1]));
  setenv("LP_NUM_THREADS", "0", 1);  // llvmpipe draws on the thread that calls it
  std::printf("a row of form factors by hemicube, R = %d, one position, CPU time, one thread, median of %d\n",
              resolution, pairs);
#ifndef SHADEBENCH_EMBREE
  std::printf("(built without Embree: libembree-dev)\n");
#endif
  for (const int n : {13, 26, 52}) run("closed cube", closed_cube(n), pairs);
  for (const int n : {13, 26, 52}) run("sphere's interior", closed_sphere(2 * n, 3 * n), pairs);
}
