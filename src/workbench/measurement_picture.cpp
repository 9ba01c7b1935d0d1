// Measurements of whole pictures.
#include "workbench/measurement_picture.h"

#include <algorithm>
#include <array>

#include "image/difference.h"
#include "params/input_error.h"
#include "workbench/camera_control.h"
#include "workbench/isolate.h"
#include "workbench/technique_list.h"

namespace cg {

Scene as_asked(const Scene& scene, const MeasurementOptions& options) {
  Scene out = isolated(scene, quantity_of(options.term), options.light);
  if (options.orbit != 0) out.camera = orbit(out.camera, radians(options.orbit), 0);
  return out;
}

Frame picture_for(const MeasureInput& in, const Scene& scene, std::string_view id) {
  const Technique& technique = find_technique(in.techniques, id);
  require(technique, scene);
  View view;
  view.width = view.height = in.options.size;
  view.normals = true;
  view.ids = true;
  return technique.render(scene, technique.plan(scene, view), view, in.progress);
}

double channel_of(const glm::vec3& colour, Channel channel) {
  return channel == Channel::mean ? (double(colour.x) + double(colour.y) + double(colour.z)) / 3
                                  : double(colour[int(channel)]);
}

glm::ivec2 pixel_of(const MeasurementOptions& o) {
  const auto place = [&](double share) { return std::clamp(int(share * o.size), 0, o.size - 1); };
  return {place(o.x), place(o.y)};
}

void nothing_there() {
  throw InputError("measurement", {"the picture shows no surface there", "その場所に面が写っていない"},
                   {"bring the object into view", "物体を視野に入れる"});
}

namespace {

// Calls for each pixel that shows a surface: (x, y, value of the options' channel). Throws where there is none.
template <class Each>
void each_covered(const Frame& frame, Channel channel, Each&& each) {
  bool any = false;
  for (int y = 0; y < frame.colour.height(); ++y)
    for (int x = 0; x < frame.colour.width(); ++x)
      if (frame.covered.at(x, y)) any = true, each(x, y, channel_of(frame.colour.at(x, y), channel));
  if (!any) nothing_there();
}

Frame drawn(const MeasureInput& in) { return picture_for(in, as_asked(in.scene, in.options), in.options.technique); }

double colour(const MeasureInput& in) {
  const Frame frame = drawn(in);
  const glm::ivec2 p = pixel_of(in.options);
  if (!frame.covered.at(p.x, p.y)) nothing_there();
  return channel_of(frame.colour.at(p.x, p.y), in.options.channel);
}

double brightest(const MeasureInput& in) {
  double most = -1e300;
  each_covered(drawn(in), in.options.channel, [&](int, int, double v) { most = std::max(most, v); });
  return most;
}

double mean(const MeasureInput& in) {
  double sum = 0, count = 0;
  each_covered(drawn(in), in.options.channel, [&](int, int, double v) { sum += v, ++count; });
  return sum / count;
}

double covered_pixels(const MeasureInput& in) {
  double count = 0;
  each_covered(drawn(in), Channel::mean, [&](int, int, double) { ++count; });
  return count;
}

double largest_step(const MeasureInput& in) {
  const Frame frame = drawn(in);
  double most = 0;
  each_covered(frame, in.options.channel, [&](int x, int y, double v) {
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)})
      if (x + dx < frame.colour.width() && y + dy < frame.colour.height() && frame.covered.at(x + dx, y + dy))
        most = std::max(most, std::abs(channel_of(frame.colour.at(x + dx, y + dy), in.options.channel) - v));
  });
  return most;
}

double share_above(const MeasureInput& in) {
  double above = 0, count = 0;
  each_covered(drawn(in), in.options.channel, [&](int, int, double v) { above += v > in.options.level, ++count; });
  return 100 * above / count;
}

double clamped_share(const MeasureInput& in) {
  Scene scene = as_asked(in.scene, in.options);
  scene.shading.clamp = false;
  const Frame frame = picture_for(in, scene, in.options.technique);
  constexpr float rounding = 1e-5f;
  double clamped = 0, count = 0;
  each_covered(frame, Channel::mean, [&](int x, int y, double) {
    const glm::vec3 c = frame.colour.at(x, y);
    clamped += std::max({c.x, c.y, c.z}) > 1 + rounding || std::min({c.x, c.y, c.z}) < -rounding;
    ++count;
  });
  return 100 * clamped / count;
}

Difference difference_of(const MeasureInput& in) {
  const Scene a = as_asked(in.scene, in.options), b = as_asked(in.against, in.options);
  const Frame left = picture_for(in, a, in.options.technique), right = picture_for(in, b, in.options.other);
  return difference(left.colour, right.colour, left.covered, right.covered, a.display);
}

double largest_difference(const MeasureInput& in) { return difference_of(in).max_error; }
double rms_difference(const MeasureInput& in) { return difference_of(in).rmse; }

// The terms drawn one by one, each light's, and their sum against the picture of all.
double term_sum_error(const MeasureInput& in) {
  Scene scene = in.scene;
  scene.shading.clamp = false;
  const Frame whole = picture_for(in, scene, in.options.technique);
  ColourImage sum(whole.colour.width(), whole.colour.height());
  const auto add = [&](Quantity term, int light) {
    const Frame part = picture_for(in, isolated(scene, term, light), in.options.technique);
    for (int y = 0; y < sum.height(); ++y)
      for (int x = 0; x < sum.width(); ++x) sum.at(x, y) += part.colour.at(x, y);
  };
  add(Quantity::ambient, no_light);
  add(Quantity::emission, no_light);
  for (int light = 0; light < int(scene.lights.size()); ++light)
    for (const Quantity term : {Quantity::ambient, Quantity::diffuse, Quantity::specular}) add(term, light);
  double most = 0;
  each_covered(whole, Channel::mean, [&](int x, int y, double) {
    const glm::vec3 d = glm::abs(whole.colour.at(x, y) - sum.at(x, y));
    most = std::max({most, double(d.x), double(d.y), double(d.z)});
  });
  return most;
}

// Between neighbouring pixels of which one is over the level and one is not, the angle of the normal is interpolated;
// the mean of all these places does not depend on where the maximum lies in its pixel.
double highlight_width(const MeasureInput& in) {
  const Scene scene = as_asked(in.scene, in.options);
  const Frame frame = picture_for(in, scene, in.options.technique);
  const Frame shape = picture_for(in, scene, "software");
  double most = 0;
  glm::ivec2 peak{0};
  const auto value = [&](int x, int y) { return channel_of(frame.colour.at(x, y), in.options.channel); };
  each_covered(frame, in.options.channel, [&](int x, int y, double v) {
    if (v > most) most = v, peak = {x, y};
  });
  if (!(most > 0))
    throw InputError("highlight-width", {"the picture is black", "画像が真っ黒"}, {"raise k_s", "k_s を上げる"});
  const double half = in.options.level * most;
  // The direction in the middle of what is over the level.
  glm::dvec3 middle{0};
  const auto normal = [&](int x, int y) { return glm::dvec3(shape.normal.at(x, y)); };
  each_covered(frame, in.options.channel, [&](int x, int y, double v) {
    if (v >= half) middle += normal(x, y);
  });
  middle = unit(middle);
  double sum = 0, count = 0;
  const auto angle = [&](int x, int y) {
    return std::atan2(glm::length(glm::cross(middle, normal(x, y))), glm::dot(middle, normal(x, y)));
  };
  each_covered(frame, in.options.channel, [&](int x, int y, double v) {
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
      const int u = x + dx, w = y + dy;
      if (u >= frame.colour.width() || w >= frame.colour.height() || !frame.covered.at(u, w) ||
          !shape.covered.at(u, w) || !shape.covered.at(x, y))
        continue;
      const double next = value(u, w);
      if ((v >= half) == (next >= half)) continue;
      const double t = (half - v) / (next - v);
      sum += (1 - t) * angle(x, y) + t * angle(u, w);
      ++count;
    }
  });
  if (count == 0)
    throw InputError("highlight-width", {"the highlight has no edge in the picture", "ハイライトの縁が画像にない"},
                     {"raise n", "n を上げる"});
  return degrees(sum / count);
}

// The direction of the one light that a diffuse picture was lit by: the least-squares solution x of N.x = I over the
// pixels that are lit, by their world normals.
glm::dvec3 light_direction(const MeasureInput& in, const Scene& scene, std::string_view technique) {
  const Frame frame = picture_for(in, scene, technique), shape = picture_for(in, scene, "software");
  double most = 0;
  each_covered(frame, Channel::mean, [&](int, int, double v) { most = std::max(most, v); });
  glm::dmat3 A(0);
  glm::dvec3 b(0);
  each_covered(frame, Channel::mean, [&](int x, int y, double v) {
    if (!shape.covered.at(x, y) || v < 0.1 * most) return;
    const glm::dvec3 N(shape.normal.at(x, y));
    A += glm::outerProduct(N, N);
    b += v * N;
  });
  if (!(most > 0) || !(std::abs(glm::determinant(A)) > 1e-9))
    throw InputError("light-turn", {"the picture does not tell where the light is", "画像から光源の方向が分からない"},
                     {"show a lit round object", "光の当たった丸い物体を見せる"});
  return unit(glm::inverse(A) * b);
}

double light_turn(const MeasureInput& in) {
  MeasurementOptions diffuse = in.options;
  diffuse.term = LightTerm::diffuse;
  diffuse.light = std::max(0, diffuse.light);
  const MeasureInput as{in.scene, in.against, diffuse, in.techniques, in.progress, in.solved};
  Scene scene = as_asked(in.scene, diffuse);
  scene.shading.clamp = false;
  const glm::dvec3 drawn_at = light_direction(as, scene, in.options.technique);
  const glm::dvec3 meant = light_direction(as, scene, in.options.other);
  return degrees(std::atan2(glm::length(glm::cross(drawn_at, meant)), glm::dot(drawn_at, meant)));
}

// What a plan says of the technique that would draw the picture: nothing is drawn.
template <class Count>
double over_plan(const MeasureInput& in, Count&& count) {
  const Scene scene = as_asked(in.scene, in.options);
  const Technique& technique = find_technique(in.techniques, in.options.technique);
  require(technique, scene);
  View view;
  view.width = view.height = in.options.size;
  double sum = 0;
  for (const Pass& pass : technique.plan(scene, view).passes) sum += count(pass);
  return sum;
}
double passes(const MeasureInput& in) {
  return over_plan(in, [](const Pass& p) { return p.kind == PassKind::pass && p.needed ? 1 : 0; });
}
double passes_left_out(const MeasureInput& in) {
  return over_plan(in, [](const Pass& p) { return p.kind == PassKind::pass && !p.needed ? 1 : 0; });
}
double plan_bytes(const MeasureInput& in) {
  return over_plan(in, [](const Pass& p) { return double(p.bytes); });
}

constexpr std::array table{
    Measurement{"colour",
                {"Colour of a pixel", "画素の色"},
                "1",
                {"x, y; channel; term, light; technique", "x、y、channel、term、light、technique"},
                colour},
    Measurement{"brightest",
                {"Largest value", "最大値"},
                "1",
                {"channel; term, light; technique", "channel、term、light、technique"},
                brightest},
    Measurement{"mean",
                {"Mean over the surface", "面全体の平均"},
                "1",
                {"channel; term, light; technique", "channel、term、light、technique"},
                mean},
    Measurement{"covered-pixels",
                {"Pixels that show a surface", "面の写っている画素の数"},
                "pixel",
                {"size; technique", "size、technique"},
                covered_pixels},
    Measurement{"largest-step",
                {"Largest step between neighbouring pixels", "隣の画素との差の最大"},
                "1",
                {"channel; term, light; technique", "channel、term、light、technique"},
                largest_step},
    Measurement{"share-above",
                {"Share of the surface brighter than level", "level より明るい面の割合"},
                "%",
                {"level; channel; term, light; technique", "level、channel、term、light、technique"},
                share_above},
    Measurement{"clamped-share",
                {"Share of the surface that clamping changes", "クランプされる面の割合"},
                "%",
                {"technique", "technique"},
                clamped_share},
    Measurement{"largest-difference",
                {"Largest difference of two pictures", "二つの画像の最大の差"},
                "1",
                {"technique, other; the second scene may be another", "technique、other。二つ目のシーンは別でもよい"},
                largest_difference},
    Measurement{"rms-difference",
                {"Root-mean-square difference of two pictures", "二つの画像の差の二乗平均平方根"},
                "1",
                {"technique, other; the second scene may be another", "technique、other。二つ目のシーンは別でもよい"},
                rms_difference},
    Measurement{"term-sum-error",
                {"Picture less the sum of its terms", "画像と項の和の差"},
                "1",
                {"technique", "technique"},
                term_sum_error},
    Measurement{"highlight-width",
                {"Half-angle of the highlight at half its height", "ハイライトの半値半角"},
                "deg",
                {"level; channel; term, light; technique", "level、channel、term、light、technique"},
                highlight_width},
    Measurement{"light-turn",
                {"Angle between the light as drawn and as meant", "描かれた光源と意図した光源の角度"},
                "deg",
                {"light; orbit; technique, other", "light、orbit、technique、other"},
                light_turn},
    Measurement{"passes",
                {"Passes that the plan runs", "計画が行う処理の数"},
                "1",
                {"size; technique", "size、technique"},
                passes},
    Measurement{"passes-left-out",
                {"Passes that the plan leaves out", "計画が省く処理の数"},
                "1",
                {"size; technique", "size、technique"},
                passes_left_out},
    Measurement{"plan-bytes",
                {"Memory that the plan names", "計画に挙がるメモリ"},
                "B",
                {"size; technique", "size、technique"},
                plan_bytes},
};

}  // namespace

std::span<const Measurement> picture_measurements() { return table; }

}  // namespace cg
