#include "ui/hemicube_desk.h"

#include <algorithm>

#include "params/input_error.h"
#include "ui/app.h"
#include "ui/radiosity_desk.h"
#include "workbench/model_library.h"
#include "workbench/scene_radiosity.h"

namespace cg {
namespace {

constexpr int most_picture = 1024, disc_size = 512;
constexpr std::size_t most_known = 64;  // closed forms beside the largest factors
constexpr std::chrono::milliseconds patience{200};
constexpr double slow_pixels = 1 << 18;  // of all hemicubes of a patch: beyond, a row takes longer than a frame

// Always the same drawing of the same polygons, made at its first call.
MakeDrawItems drawing_once(const MakeDrawItems& gl, std::span<const ItemPolygon> polygons) {
  if (!gl) return {};
  struct Made {
    std::once_flag once;
    DrawItems draw;
  };
  const auto made = std::make_shared<Made>();
  const DrawItems draw = [gl, polygons, made](const HemicubeFrame& frame, int resolution,
                                              const std::vector<bool>& drawn, ItemFaces& out) {
    std::call_once(made->once, [&] { made->draw = gl(polygons); });
    made->draw(frame, resolution, drawn, out);
  };
  return [draw](std::span<const ItemPolygon>) { return draw; };
}

std::uint64_t key_of(const Scene& loaded) { return geometry_key(loaded, loaded.radiosity); }

}  // namespace

HemicubeGround::HemicubeGround(Scene from, const Scene& loaded, const MakeDrawItems& make_gl, Progress& progress)
    : inputs(std::move(from)),
      geometry(key_of(loaded)),
      patches(make_patches(loaded, loaded.radiosity, progress)),
      polygons(item_polygons(patches)),
      gl(drawing_once(make_gl, polygons)),
      viewer(patches, gl),
      tree(polygons),
      all(patches.patches.size() / 16 + 1, 0xffff) {}

std::optional<std::uint32_t> HemicubeGround::met(const glm::dvec3& origin, const glm::dvec3& direction) const {
  const std::uint32_t item = tree.first_met(origin, direction, all);
  if (item == no_item) return std::nullopt;
  return item & ~from_behind;
}

std::optional<std::uint32_t> HemicubeGround::at_place_of(const Patch& patch) const {
  const double above = 1e-3 * std::sqrt(patch.area);
  const std::optional<std::uint32_t> found = met(patch.centre + above * patch.normal, -patch.normal);
  if (!found) return std::nullopt;
  const Patch& p = patches.patches[*found];
  const bool same_plane = std::abs(glm::dot(p.normal, patch.centre - p.centre)) <= above;
  return same_plane && glm::dot(p.normal, patch.normal) > 0.99 ? found : std::nullopt;
}

const PatchPixels* HemicubeSight::of(std::uint32_t item) const {
  const auto found = std::lower_bound(pixels.begin(), pixels.end(), item,
                                      [](const PatchPixels& p, std::uint32_t i) { return p.item < i; });
  return found != pixels.end() && found->item == item ? &*found : nullptr;
}

double HemicubeRow::factor(std::uint32_t other) const {
  const auto found = std::lower_bound(row.factors.begin(), row.factors.end(), other,
                                      [](const FormFactor& f, std::uint32_t i) { return f.patch < i; });
  return found != row.factors.end() && found->patch == other ? double(found->value) : 0;
}

HemicubeDesk::HemicubeDesk(std::function<void()> wake, MakeDrawItems gl)
    : wake_(wake ? std::move(wake) : [] {}), gl_(std::move(gl)) {}

// What of the options the hemicubes depend on.
Radiosity HemicubeDesk::options_of(const Radiosity& r) const {
  Radiosity out;
  out.form_factors = FormFactors::hemicube, out.item_buffer = gl_ ? r.item_buffer : ItemBuffer::software;
  out.resolution = r.resolution, out.samples = r.samples, out.placement = r.placement;
  out.weight = r.weight, out.normalise = r.normalise;
  return out;
}

Scene HemicubeDesk::inputs_of(const Scene& scene) {
  Scene out = radiosity_inputs(scene);
  out.radiosity = {};
  out.radiosity.patch_size = scene.radiosity.patch_size;
  return out;
}

template <class T>
void HemicubeDesk::publish(std::shared_ptr<const T> State::*what, std::shared_ptr<const T> value) {
  {
    const std::lock_guard lock(mutex_);
    std::swap(newest_.*what, value);
  }
  wake_();
}

void HemicubeDesk::make_ground(Scene inputs, Progress& progress) {
  GroundHandle ground;
  std::optional<Text> message;
  try {
    Scene loaded = inputs;
    load_meshes(loaded);
    ground = std::make_shared<const HemicubeGround>(std::move(inputs), loaded, gl_, progress);
    const auto& all = ground->patches.patches;
    if (std::none_of(all.begin(), all.end(), [](const Patch& p) { return p.area > 0; })) {
      message = Text("The scene has no face with an area: there are no patches",
                     "面積のある面がシーンにないので、パッチがない");
      ground = nullptr;
    }
  } catch (const InputError& e) {
    message = Text(e.message(Language::english), e.message(Language::japanese));
  } catch (const std::bad_alloc&) {
    message = Text("There is not enough memory for the patches", "パッチを保存するメモリが足りない");
  }
  {
    const std::lock_guard lock(mutex_);
    if (progress.cancelled) return;
    newest_.ground = std::move(ground), newest_.message = std::move(message);
  }
  wake_();
}

void HemicubeDesk::update(const Scene& scene, const SolutionHandle& solution, Settings& settings) {
  if (Scene inputs = inputs_of(scene); !asked_inputs_ || !(*asked_inputs_ == inputs)) {
    asked_inputs_ = inputs;
    grounder_.submit([this, inputs = std::move(inputs)](Progress& p) { make_ground(inputs, p); }, true);
  }
  {
    const std::lock_guard lock(mutex_);
    shown_ = newest_;
  }
  current_ = shown_.ground && shown_.ground->inputs == *asked_inputs_;
  if (!current_) return;
  settle(scene, settings);
  ask_sight(scene, solution, settings);
  ask_row(scene, settings);
  ask_pair(settings);
}

// The numbers name patches of the ground.
void HemicubeDesk::settle(const Scene& scene, Settings& settings) {
  const HemicubeGround& ground = *shown_.ground;
  const auto& all = ground.patches.patches;
  const auto fits = [&](int number) {
    return number >= 0 && std::size_t(number) < all.size() && all[std::size_t(number)].area > 0;
  };
  const auto follow = [&](const std::optional<Place>& place, int& number) {
    if (!place || place->number != number) return;
    const auto now = ground.at_place_of(place->patch);
    number = now ? int(*now) : -1;
  };
  if (settled_ != shown_.ground) {
    follow(place_, settings.patch), follow(other_place_, settings.other_patch);
    settled_ = shown_.ground;
  }
  if (!fits(settings.patch)) {
    const Camera& camera = scene.camera;
    const auto ahead = ground.met(camera.position, unit(camera.target - camera.position));
    const auto first = std::find_if(all.begin(), all.end(), [](const Patch& p) { return p.area > 0; });
    settings.patch = ahead ? int(*ahead) : int(first - all.begin());
  }
  if (!fits(settings.other_patch) || settings.other_patch == settings.patch) settings.other_patch = -1;
  const auto place_of = [&](int number) -> std::optional<Place> {
    if (number < 0) return std::nullopt;
    return Place{number, all[std::size_t(number)]};
  };
  place_ = place_of(settings.patch), other_place_ = place_of(settings.other_patch);
}

void HemicubeDesk::ask_sight(const Scene& scene, const SolutionHandle& solution, const Settings& settings) {
  SightKey key{shown_.ground, std::uint32_t(settings.patch), 0, options_of(scene.radiosity), settings.hemicube, nullptr,
               scene.display};
  key.options.normalise = Normalise::rows;  // it does not matter here
  const std::size_t positions = HemicubeViewer::positions(key.ground->patches.patches[key.patch], key.options);
  key.position = std::min(std::size_t(std::max(settings.position, 0)), positions - 1);
  if (key.show == HemicubeShow::seen && solution && solution->geometry == key.ground->geometry &&
      solution->radiosity.size() == key.ground->patches.patches.size())
    key.solution = solution;
  if (asked_sight_ && *asked_sight_ == key) return;
  asked_sight_ = key;
  viewer_.submit([this, key, positions](Progress&) {
    HemicubeSight sight{key.ground, key.patch,          key.position, positions, key.options,
                        key.show,   bool(key.solution), {},           {},        {}};
    std::optional<Text> trouble;
    try {
      sight.view = key.ground->viewer.view(key.patch, key.position, key.options);
    } catch (const InputError& e) {  // no OpenGL
      trouble = Text(e.message(Language::english), e.message(Language::japanese));
    }
    const bool drawn = !trouble;
    {
      const std::lock_guard lock(mutex_);
      newest_.trouble = std::move(trouble);
    }
    if (!drawn) return wake_();
    sight.pixels = patch_pixels(sight.view);
    static const std::vector<glm::dvec3> unsolved;
    const PixelColour colour =
        key.show == HemicubeShow::seen
            ? seen_colours(key.ground->patches, key.solution ? key.solution->radiosity : unsolved, key.display)
        : key.show == HemicubeShow::weights ? weight_colours(largest_delta_form_factor(sight.view.resolution))
                                            : item_colours();
    sight.picture = key.show == HemicubeShow::nusselt ? disc_picture(sight.view, colour, disc_size)
                                                      : cross_picture(sight.view, colour, most_picture);
    publish(&State::sight, std::make_shared<const HemicubeSight>(std::move(sight)));
  });
}

void HemicubeDesk::ask_row(const Scene& scene, const Settings& settings) {
  const RowKey key{shown_.ground, std::uint32_t(settings.patch), options_of(scene.radiosity)};
  if (asked_row_ && *asked_row_ == key) {
    // One that takes long is of no use when another is wanted; a quick one is shown while a slider moves.
    if (std::chrono::steady_clock::now() - row_since_ > patience) rower_.cancel_stale();
    return;
  }
  asked_row_ = key;
  if (!rower_.waiting()) row_since_ = std::chrono::steady_clock::now();
  rower_.submit([this, key](Progress& progress) {
    HemicubeRow out{key.ground, key.patch, key.options, {}, {}, {}, {}};
    try {
      out.method = form_factor_method(key.ground->patches, key.options, key.ground->gl);
      out.row = out.method.row(key.patch, progress);
    } catch (const InputError&) {  // no OpenGL: the sight says so
      return;
    }
    out.by_size = out.row.factors;
    std::stable_sort(out.by_size.begin(), out.by_size.end(),
                     [](const FormFactor& a, const FormFactor& b) { return a.value > b.value; });
    for (const FormFactor& f : out.by_size) {
      if (out.known.size() == most_known) break;
      if (progress.cancelled || rower_.waiting()) return;
      out.known.push_back(known_factor(key.ground->patches, key.patch, f.patch));
    }
    publish(&State::row, std::make_shared<const HemicubeRow>(std::move(out)));
  });
}

std::uint32_t HemicubeDesk::item(const Settings& settings) const {
  if (pointed_ != no_item) return pointed_;
  if (settings.other_patch >= 0) return std::uint32_t(settings.other_patch);
  const std::shared_ptr<const HemicubeRow>& row = shown_.row;
  const bool known = row && row->ground == shown_.ground && row->patch == std::uint32_t(settings.patch);
  return known && !row->by_size.empty() ? row->by_size.front().patch : no_item;
}

bool HemicubeDesk::turn_pointed() {
  const bool changed = pointed_ != next_pointed_;
  pointed_ = std::exchange(next_pointed_, no_item);
  return changed;
}

void HemicubeDesk::ask_pair(const Settings& settings) {
  const PairKey key{shown_.sight, shown_.row, item(settings)};
  if (asked_pair_ && *asked_pair_ == key) {
    if (std::chrono::steady_clock::now() - pair_since_ > patience) pairer_.cancel_stale();
    return;
  }
  if (!key.sight || key.sight->ground != shown_.ground || key.item == no_item ||
      (key.item & ~from_behind) >= key.sight->ground->patches.patches.size())
    return;
  asked_pair_ = key;
  if (!pairer_.waiting()) pair_since_ = std::chrono::steady_clock::now();
  HemicubePair pair;
  pair.sight = key.sight, pair.item = key.item;
  if (key.row && key.row->ground == key.sight->ground && key.row->patch == key.sight->patch) pair.row = key.row;
  pairer_.submit([this, pair = std::move(pair)](Progress& progress) { make_pair(pair, progress); });
}

void HemicubeDesk::make_pair(HemicubePair pair, Progress& progress) {
  const HemicubeSight& sight = *pair.sight;
  const Patches& patches = sight.ground->patches;
  const std::uint32_t i = sight.patch, j = pair.other();
  const Patch& other = patches.patches[j];
  const int resolution = sight.view.resolution;
  if (const PatchPixels* pixels = sight.of(pair.item)) pair.outline = item_outline(sight.view, *pixels);
  if (sight.show != HemicubeShow::nusselt)
    pair.others = cross_picture(
        sight.view,
        [&](std::uint32_t item, float, const glm::dvec3&) { return glm::u8vec4(0, 0, 0, item == pair.item ? 0 : 150); },
        most_picture);
  // What comes quickly comes at once: numbers that are gone for a moment flicker.
  const Radiosity& options = sight.options;
  const bool slow = double(options.samples) * options.samples * resolution * resolution > slow_pixels;
  if (slow || i == j) publish(&State::pair, std::make_shared<const HemicubePair>(pair));
  if (i == j || pairer_.waiting()) return;
  if (other.area > 0) {
    pair.point = known_factor(patches, i, sight.view.frame.position, j);
    pair.shadow = nusselt_projection(sight.view.frame.position, sight.view.frame.z,
                                     std::span(other.corner.data(), std::size_t(other.corners)));
  }
  if (!weights_ || (*weights_)[0].resolution() != resolution)
    weights_ = std::make_shared<const AllWeights>(all_weights(resolution));
  pair.weighted = weighted_sums(sight.view, pair.item, *weights_);
  if (slow || !pair.row || !(other.area > 0)) publish(&State::pair, std::make_shared<const HemicubePair>(pair));
  if (!pair.row || !(other.area > 0) || pairer_.waiting()) return;
  HemicubePair::Whole whole;
  whole.there = pair.row->factor(j);
  whole.known = known_factor(patches, i, j);
  const FormFactorRow back = pair.row->method.row(j, progress);
  for (const FormFactor& f : back.factors)
    if (f.patch == i) whole.back = double(f.value);
  const double flow = patches.patches[i].area * whole.there;
  whole.reciprocity = std::abs(flow - other.area * whole.back);
  whole.relative = flow > 0 ? whole.reciprocity / flow : 0;
  pair.whole = whole;
  publish(&State::pair, std::make_shared<const HemicubePair>(std::move(pair)));
}

HemicubeDesk& hemicube_of(App& app) {
  if (!app.hemicube) app.hemicube = std::make_shared<HemicubeDesk>(app.wake, desk_of(app).draw_items());
  return *app.hemicube;
}

bool looks_at_hemicube(const App& app) {
  if (app.settings.side != Side::hemicube) return false;
  return !app.hemicube || app.hemicube->busy();
}

void show_hemicube(App& app, const LessonView& view) {
  Settings& s = app.settings;
  s.patch = view.patch, s.other_patch = view.other_patch, s.position = view.position, s.hemicube = view.hemicube;
  if (app.hemicube) app.hemicube->forget_place();
}

}  // namespace cg
