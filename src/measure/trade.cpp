// Runs a knob's ladder: references and errors first, then the timed rounds, each in an order of its own so that what
// else the machine does meets all settings alike.
#include "measure/trade.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <set>

#include "measure/verdict.h"
#include "params/input_error.h"
#include "workbench/model_library.h"
#include "workbench/technique_list.h"

namespace cg {

namespace {

class Runner {
 public:
  Runner(const Knob& knob, std::span<const Technique> techniques, const TradeOptions& options, Progress& progress)
      : knob_(knob),
        techniques_(techniques),
        repeats_(std::max(options.repeats, 1)),
        seconds_(options.seconds),
        progress_(progress) {}

  void run(Trade& trade) {
    Ladder& ladder = trade.ladder;
    untimed_ = ladder.references.size() + ladder.settings.size();
    timed_ = ladder.settings.size() * std::size_t(repeats_);
    for (Setting& s : ladder.settings) load_meshes(s.scene);
    trade.points.resize(ladder.settings.size());
    find_errors(trade);
    find_times(trade);
  }

 private:
  Frame draw(const Setting& setting) {
    if (progress_.cancelled) throw Cancelled{};
    Progress untold;
    Frame frame = knob_.draw ? knob_.draw(setting, techniques_, untold) : draw_setting(setting, techniques_, untold);
    ++done_;
    tell();
    return frame;
  }

  // The timed rounds are done when both their number and their seconds are reached.
  void tell() {
    const double rounds = done_ > untimed_ ? double(done_ - untimed_) : 0;
    const double clock = seconds_ > 0 && rounds > 0 ? since_begin() / seconds_ : 1;
    const double share = std::min({rounds / double(timed_), clock, 1.0});
    progress_.fraction =
        float((double(std::min(done_, untimed_)) + share * double(timed_)) / double(untimed_ + timed_));
  }

  double since_begin() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

  // One reference at a time: theirs are the largest meshes and pictures.
  void find_errors(Trade& trade) {
    Ladder& ladder = trade.ladder;
    const auto errors = knob_.errors ? knob_.errors : colour_errors;
    for (std::size_t r = 0; r < ladder.references.size(); ++r) {
      Setting& reference = ladder.references[r];
      load_meshes(reference.scene);
      const Frame exact = draw(reference);
      trade.reference_ms.push_back({exact.cpu_ms, exact.cpu_ms, exact.cpu_ms});
      for (std::size_t i = 0; i < ladder.settings.size(); ++i)
        if (ladder.settings[i].reference == r)
          trade.points[i].errors = errors(ladder.settings[i], draw(ladder.settings[i]), reference, exact);
      for (Object& object : reference.scene.objects) object.mesh.reset();
    }
  }

  void find_times(Trade& trade) {
    const std::size_t n = trade.points.size();
    std::vector<std::vector<double>> ms(n);
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    begin_ = std::chrono::steady_clock::now();
    for (int round = 0; round < repeats_ || since_begin() < seconds_; ++round) {
      shuffle(order);
      for (const std::size_t i : order) ms[i].push_back(draw(trade.ladder.settings[i]).cpu_ms);
      trade.repeats = round + 1;
    }
    for (std::size_t i = 0; i < n; ++i) trade.points[i].ms = spread_of(std::move(ms[i]));
  }

  // Fisher and Yates, the same in every run.
  void shuffle(std::vector<std::size_t>& order) {
    for (std::size_t i = order.size(); i > 1; --i) {
      random_ = random_ * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX
      std::swap(order[i - 1], order[std::size_t(random_ >> 33) % i]);
    }
  }

  const Knob& knob_;
  std::span<const Technique> techniques_;
  const int repeats_;
  const double seconds_;
  Progress& progress_;
  std::size_t done_ = 0, untimed_ = 0, timed_ = 1;
  std::chrono::steady_clock::time_point begin_{};
  std::uint64_t random_ = 1;
};

void mark_front(Trade& trade) {
  std::vector<double> ms, errors;
  for (const TradePoint& p : trade.points) {
    ms.push_back(p.ms.median);
    errors.push_back(error_of(p.errors, trade.knob->plotted));
  }
  const std::vector<bool> front = pareto_front(ms, errors);
  for (std::size_t i = 0; i < front.size(); ++i) trade.points[i].on_front = front[i];
}

Machine machine_of(const Ladder& ladder, std::span<const Technique> techniques) {
  Machine machine{cpu_name(), {}};
  std::set<std::string> used;
  for (const Setting& s : ladder.settings) used.insert(s.technique);
  for (const Setting& s : ladder.references) used.insert(s.technique);
  for (const Technique& t : techniques)
    if (used.contains(t.id) && t.device && machine.renderer.empty()) machine.renderer = t.device();
  return machine;
}

void set_size(Trade& trade) {
  if (trade.ladder.settings.empty()) return;
  const Setting& s = trade.ladder.settings.front();
  const bool larger = s.resampling == Resampling::nearest;
  trade.width = larger ? s.view.width * s.factor : s.view.width / s.factor;
  trade.height = larger ? s.view.height * s.factor : s.view.height / s.factor;
}

void let_meshes_go(Ladder& ladder) {
  for (std::vector<Setting>* list : {&ladder.settings, &ladder.references})
    for (Setting& s : *list)
      for (Object& object : s.scene.objects) object.mesh.reset();
}

}  // namespace

double error_of(const Errors& errors, ErrorKind kind) { return kind == ErrorKind::max ? errors.max : errors.rmse; }

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return {values.front(), (values[(n - 1) / 2] + values[n / 2]) / 2, values.back()};
}

std::vector<bool> pareto_front(std::span<const double> ms, std::span<const double> errors) {
  std::vector<std::size_t> order(std::min(ms.size(), errors.size()));
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return ms[a] != ms[b] ? ms[a] < ms[b] : errors[a] < errors[b];
  });
  std::vector<bool> front(order.size(), false);
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order)
    if (errors[i] < least) {
      least = errors[i];
      front[i] = true;
    }
  return front;
}

Trade run_trade(const Knob& knob, const std::string& scene_name, const Scene& scene,
                std::span<const Technique> techniques, const TradeOptions& options, Progress& progress) {
  Trade trade;
  trade.knob = &knob;
  trade.scene = scene_name;
  trade.ladder = knob.ladder({scene, techniques, options.technique, options.width, options.height, options.threads});
  set_size(trade);
  Runner(knob, techniques, options, progress).run(trade);
  trade.machine = machine_of(trade.ladder, techniques);
  mark_front(trade);
  for (std::size_t i = 0; i < knob.predictions.size(); ++i) trade.checks.push_back(check_prediction(trade, i));
  trade.notes = trade.ladder.notes;
  let_meshes_go(trade.ladder);
  return trade;
}

}  // namespace cg
