#include "ui/trade_desk.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "params/input_error.h"
#include "params/slots.h"
#include "raster/software.h"
#include "ui/app.h"
#include "workbench/model_library.h"
#include "workbench/scene_differences.h"

namespace cg {
namespace {

// 1, 2 or 5 times a power of ten, so that the largest difference comes near white.
double round_gain(double largest) {
  if (!(largest > 0)) return 1;
  const double wanted = 1 / largest, power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double digit = wanted / power;
  return std::max(1.0, (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power);
}

std::vector<std::string> touched_paths(const Scene& base, const Ladder& ladder) {
  std::vector<std::string> paths;
  for (const Setting& s : ladder.settings)
    for (const ParameterDifference& d : scene_differences(base, s.scene))
      if (std::find(paths.begin(), paths.end(), d.path) == paths.end()) paths.push_back(d.path);
  return paths;
}

std::string name_of(const App& app) {
  if (!app.preset.empty()) return std::filesystem::path(app.preset).filename().string();
  return app.scene.objects.empty() ? std::string() : app.scene.objects[0].model;
}

// In the narrow panel the tab says the title, and a line under the plot what the error is.
std::shared_ptr<const Plot> in_panel(Plot plot, const Knob& knob) {
  const std::string unit = knob.error_unit == "1" ? "" : " [" + std::string(knob.error_unit) + "]";
  plot.title = {};
  plot.y.title =
      knob.plotted == ErrorKind::max ? Text("Max error" + unit, "最大誤差" + unit) : Text("RMSE" + unit, "RMSE" + unit);
  return std::make_shared<Plot>(std::move(plot));
}

Text text_of(const InputError& e) { return {e.message(Language::english), e.message(Language::japanese)}; }

}  // namespace

TradeDesk::TradeDesk(std::function<void()> wake) : wake_(wake ? std::move(wake) : [] {}) {}

TradeDesk::~TradeDesk() {
  if (link_) link_->cancelled = true;
}

// Software needs no turn of its own. A drawing ends when `link` says so: a trade asks its own progress between two.
std::vector<Technique> TradeDesk::own_techniques(const App& app, std::shared_ptr<Progress> link) const {
  std::vector<Technique> out = app.techniques;
  for (Technique& t : out) {
    if (t.id == "software") t = software_technique();
    t.render = [link, render = std::move(t.render)](const Scene& scene, const Plan& plan, const View& view, Progress&) {
      return render(scene, plan, view, *link);
    };
  }
  return out;
}

void TradeDesk::measure(const App& app, const Knob& knob) {
  stop();
  link_ = std::make_shared<Progress>();
  {
    const std::lock_guard lock(mutex_);
    running_ = &knob;
    entries_[std::string(knob.id)].problem.reset();
  }
  auto task = [this, &knob, link = link_, scene = app.scene, name = name_of(app),
               techniques = own_techniques(app, link_)](Progress& progress) mutable {
    const std::string id(knob.id);
    auto measured = std::make_shared<MeasuredTrade>();
    std::optional<Text> problem;
    try {
      load_meshes(scene);
      measured->trade = run_trade(knob, name, scene, techniques, {}, progress);
      measured->paths = touched_paths(scene, measured->trade.ladder);
      measured->speed = in_panel(speed_plot(measured->trade), knob);
      measured->convergence = in_panel(convergence_plot(measured->trade), knob);
    } catch (const InputError& e) {
      problem = text_of(e);
    } catch (const Cancelled&) {
      measured.reset();
    } catch (const std::bad_alloc&) {
      problem = Text("Not enough memory", "メモリが足りない");
    } catch (const std::exception& e) {
      problem = Text(e.what(), e.what());
    }
    {
      const std::lock_guard lock(mutex_);
      if (link->cancelled) return;  // stop() has cleared the rest
      running_ = nullptr;
      Entry& entry = entries_[id];
      entry.problem = problem;
      if (measured && !problem) entry = {measured, {}, {}, {}};
    }
    wake_();
    if (measured && !problem) draw_pictures(id, measured, techniques, progress);
  };
  worker_.submit(std::move(task), true);
}

void TradeDesk::stop() {
  if (link_) link_->cancelled = true;
  worker_.submit([](Progress&) {}, true);
  const std::lock_guard lock(mutex_);
  running_ = nullptr;
  drawing_.clear();
}

const Knob* TradeDesk::running() const {
  const std::lock_guard lock(mutex_);
  return running_;
}

std::shared_ptr<const MeasuredTrade> TradeDesk::of(const Knob& knob) const {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(std::string(knob.id));
  return found == entries_.end() ? nullptr : found->second.measured;
}

std::optional<Text> TradeDesk::problem(const Knob& knob) const {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(std::string(knob.id));
  return found == entries_.end() ? std::nullopt : found->second.problem;
}

std::optional<std::size_t> TradeDesk::next_picture(const std::string& id, std::size_t count) const {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(id);
  if (found == entries_.end()) return {};
  const auto& there = found->second.pictures;
  if (wanted_ && *wanted_ < count && !there.contains(*wanted_)) return wanted_;
  for (std::size_t i = 0; i < count; ++i)
    if (!there.contains(i)) return i;
  return {};
}

// All of them, that under the mouse first.
void TradeDesk::draw_pictures(const std::string& id, const std::shared_ptr<const MeasuredTrade>& measured,
                              const std::vector<Technique>& techniques, Progress& progress) {
  {
    const std::lock_guard lock(mutex_);
    drawing_ = id;
  }
  const std::size_t count = measured->trade.points.size();
  for (auto next = next_picture(id, count); next && !progress.cancelled; next = next_picture(id, count)) {
    std::shared_ptr<const SettingPicture> picture;
    try {
      picture = draw_picture(id, measured->trade, *next, techniques, progress);
    } catch (const Cancelled&) {
      break;
    } catch (const InputError&) {
      picture = std::make_shared<SettingPicture>();  // its technique went away; the numbers stay
    }
    {
      const std::lock_guard lock(mutex_);
      Entry& entry = entries_[id];
      if (entry.measured != measured) break;
      entry.pictures[*next] = picture;
    }
    wake_();
  }
  const std::lock_guard lock(mutex_);
  if (drawing_ == id) drawing_.clear();
  entries_[id].references.clear();
}

std::shared_ptr<const SettingPicture> TradeDesk::draw_picture(const std::string& id, const Trade& trade,
                                                              std::size_t point,
                                                              const std::vector<Technique>& techniques,
                                                              Progress& progress) {
  const auto draw = [&](Setting setting) {
    load_meshes(setting.scene);
    return trade.knob->draw ? trade.knob->draw(setting, techniques, progress)
                            : draw_setting(setting, techniques, progress);
  };
  const Setting& setting = trade.ladder.settings[point];
  std::shared_ptr<const Frame> reference;
  {
    const std::lock_guard lock(mutex_);
    reference = entries_[id].references[setting.reference];
  }
  if (!reference) {
    reference = std::make_shared<Frame>(draw(trade.ladder.references[setting.reference]));
    const std::lock_guard lock(mutex_);
    entries_[id].references[setting.reference] = reference;
  }
  const Frame frame = draw(setting);
  auto out = std::make_shared<SettingPicture>();
  out->shown = cg::picture(setting.scene.display, frame.colour);
  if (frame.colour.width() == reference->colour.width() && frame.colour.height() == reference->colour.height()) {
    const Difference d =
        cg::difference(frame.colour, reference->colour, frame.covered, reference->covered, setting.scene.display);
    out->gain = round_gain(d.max_error);
    out->difference = absolute_picture(d, out->gain);
  }
  return out;
}

std::shared_ptr<const SettingPicture> TradeDesk::picture(const App& app, const Knob& knob, std::size_t point) {
  const std::string id(knob.id);
  std::shared_ptr<const MeasuredTrade> measured;
  bool begin = false;
  {
    const std::lock_guard lock(mutex_);
    const auto found = entries_.find(id);
    if (found == entries_.end() || !found->second.measured) return nullptr;
    wanted_ = point;
    const auto there = found->second.pictures.find(point);
    if (there != found->second.pictures.end()) return asked_ = there->second;
    measured = found->second.measured;
    begin = !running_ && drawing_ != id;
    if (begin) drawing_ = id;
  }
  asked_ = nullptr;
  if (begin) {
    if (link_) link_->cancelled = true;
    link_ = std::make_shared<Progress>();
    worker_.submit([this, id, measured, techniques = own_techniques(app, link_)](
                       Progress& progress) { draw_pictures(id, measured, techniques, progress); },
                   true);
  }
  return nullptr;
}

void TradeDesk::update(App& app) {
  if (running()) app.next_frame = std::min(app.next_frame, app.now + 0.25);  // the progress bar
  if (!asked_ || asked_ == uploaded_) return;
  uploaded_ = asked_;
  shown_.upload(uploaded_->shown);
  difference_.upload(uploaded_->difference);
}

TradeDesk& trades_of(App& app) {
  if (!app.trades) app.trades = std::make_shared<TradeDesk>(app.wake);
  return *app.trades;
}

void stop_measuring(App& app) {
  if (app.trades) app.trades->stop();
}

namespace {

void show_technique(App& app, const std::string& id) {
  const auto shows = [&](int i) {
    return i >= 0 && i < int(app.techniques.size()) && app.techniques[std::size_t(i)].id == id;
  };
  if (shows(app.left) || shows(app.right)) return;
  for (int i = 0; i < int(app.techniques.size()); ++i)
    if (shows(i) && !app.techniques[std::size_t(i)].unavailable) app.left = i;
}

void take_scene(App& app, Scene scene) {
  app.history.end_gesture();
  app.scene = std::move(scene);
  app.history.change(app.scene);
}

}  // namespace

void take_setting(App& app, const MeasuredTrade& measured, std::size_t point) {
  if (point >= measured.trade.ladder.settings.size()) return;
  const Setting& setting = measured.trade.ladder.settings[point];
  show_technique(app, setting.technique);
  Scene from = setting.scene, next = app.scene;
  try {
    for (const std::string& path : measured.paths)
      assign(find_slot(slots(next), path), slot_tree(find_slot(slots(from), path)));
    take_scene(app, std::move(next));
  } catch (const InputError&) {  // it has other objects or lights: then all of it
    app.errands->run(app, [from]() mutable -> Errands::Done {
      load_meshes(from);
      return [from](App& a) { take_scene(a, from); };
    });
  }
  if (setting.resampling == Resampling::none && setting.view.samples <= 1) return;
  say(app, Text(Words{"The panes draw one sample a pixel: this setting's picture stands below the plot",
                      "左右の絵は 1 画素 1 標本で描かれます。この設定の絵は図の下にあります"}));
}

}  // namespace cg
