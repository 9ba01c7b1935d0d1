#include "workbench/measured_plan.h"

#include <algorithm>
#include <charconv>

namespace cg {

namespace {

const PassRun* find(const std::vector<PassRun>& runs, std::string_view id) {
  const auto found = std::find_if(runs.begin(), runs.end(), [&](const PassRun& r) { return r.id == id; });
  return found == runs.end() ? nullptr : &*found;
}

Text quoted(const std::string& id, std::string_view en, std::string_view ja) {
  return {id + std::string(en), id + std::string(ja)};
}

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  const auto middle = v.begin() + std::ptrdiff_t(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

bool has_code(const std::vector<CodeRun>& ran, const std::string& parts) {
  return std::any_of(ran.begin(), ran.end(), [&](const CodeRun& c) { return c.parts == parts; });
}

}  // namespace

std::size_t MeasuredPlan::held() const {
  std::size_t all = 0;
  for (const MeasuredPass& p : passes) all += p.held;
  return all;
}

std::vector<Text> differences(const Plan& plan, const Frame& frame) {
  std::vector<Text> out;
  for (const PassRun& run : frame.passes)
    if (!plan.runs(run.id)) out.push_back(quoted(run.id, " ran, against the plan", " が計画に反して実行された"));
  for (const Pass& pass : plan.passes) {
    if (!pass.needed) continue;
    const PassRun* run = find(frame.passes, pass.id);
    if (!run)
      out.push_back(quoted(pass.id, " did not run, against the plan", " が計画に反して実行されなかった"));
    else if (!pass.bytes_open && run->bytes != pass.bytes)
      out.push_back(quoted(pass.id, " held " + std::to_string(run->bytes) + " bytes, not " + std::to_string(pass.bytes),
                           " のバイト数は " + std::to_string(pass.bytes) + " でなく " + std::to_string(run->bytes)));
  }
  for (const CodeRun& code : frame.code)
    if (std::find(plan.code.begin(), plan.code.end(), code.parts) == plan.code.end())
      out.push_back(quoted(code.parts, " was compiled, against the plan", " が計画に反してコンパイルされた"));
  for (const std::string& code : plan.code)
    if (!has_code(frame.code, code))
      out.push_back(quoted(code, " was not compiled, against the plan", " が計画に反してコンパイルされなかった"));
  return out;
}

MeasuredPlan measured(const Plan& plan, const Frame& frame) {
  MeasuredPlan m;
  m.plan = plan;
  m.pictures = 1;
  m.code = frame.code;
  m.differences = differences(plan, frame);
  for (const Pass& pass : plan.passes) {
    MeasuredPass& line = m.passes.emplace_back();
    line.planned = pass;
    if (const PassRun* run = find(frame.passes, pass.id)) {
      line.ran = true;
      line.ms = line.first_ms = run->cpu_ms, line.held = run->bytes, line.kept = run->kept;
    }
    m.ms += line.ms;
  }
  return m;
}

MeasuredPlan measure_plan(const Technique& technique, const Scene& scene, const View& view, int repeats,
                          Progress& progress) {
  const Plan plan = technique.plan(scene, view);
  MeasuredPlan m = measured(plan, technique.render(scene, plan, view, progress));
  std::vector<std::vector<double>> times(m.passes.size());
  for (int i = 0; i < repeats; ++i) {
    const Frame frame = technique.render(scene, plan, view, progress);
    if (m.differences.empty()) m.differences = differences(plan, frame);
    for (std::size_t k = 0; k < m.passes.size(); ++k)
      if (const PassRun* run = find(frame.passes, m.passes[k].planned.id)) {
        times[k].push_back(run->cpu_ms);
        m.passes[k].kept = run->kept;
      }
  }
  m.pictures += repeats;
  if (repeats == 0) return m;
  m.ms = 0;
  for (std::size_t k = 0; k < m.passes.size(); ++k) m.ms += m.passes[k].ms = median(times[k]);
  return m;
}

std::string size_text(std::size_t bytes) {
  if (bytes < 1024) return std::to_string(bytes) + " B";
  if (bytes < std::size_t(10) << 20) return std::to_string((bytes + 512) >> 10) + " KiB";
  return std::to_string((bytes + (std::size_t(1) << 19)) >> 20) + " MiB";
}

std::string ms_text(double ms) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, ms, std::chars_format::fixed, ms < 9.9995 ? 3 : 1).ptr;
  return std::string(text, end) + " ms";
}

}  // namespace cg
