// shadebench plan: what a technique runs for a scene, what it leaves out and why, and what each costs.
#include <algorithm>

#include "params/tree.h"
#include "workbench/command_parts.h"
#include "workbench/measured_plan.h"
#include "workbench/progress_line.h"

namespace cg {

namespace {

constexpr int usual_repeats = 5, most_repeats = 1000;

const char* name_of(PassKind kind) {
  switch (kind) {
    case PassKind::pass:
      return "pass";
    case PassKind::part:
      return "part";
    case PassKind::resource:
      return "resource";
  }
  return "";
}

Tree json_of(const MeasuredPass& p, bool measured) {
  const Pass& pass = p.planned;
  Tree::Members m{
      {"id", pass.id},         {"name", pass.name.en},     {"kind", name_of(pass.kind)},
      {"needed", pass.needed}, {"reason", pass.reason.en}, {"bytes", pass.bytes_open ? Tree() : Tree(pass.bytes)}};
  if (measured) {
    m.emplace_back("ran", p.ran);
    m.emplace_back("held_bytes", p.held);
    m.emplace_back("ms", p.ms);
    m.emplace_back("first_ms", p.first_ms);
    m.emplace_back("kept", p.kept);
  }
  return m;
}

Tree json_of(const MeasuredPlan& m, const Arguments& a, const View& view) {
  Tree::List passes, notes, code, differing;
  for (const MeasuredPass& p : m.passes) passes.push_back(json_of(p, m.pictures > 0));
  for (const Text& note : m.plan.notes) notes.emplace_back(note.en);
  for (const CodeRun& c : m.code)
    code.push_back(Tree::Members{{"parts", c.parts}, {"compile_ms", c.compile_ms}, {"kept", c.kept}});
  for (const Text& d : m.differences) differing.emplace_back(d.en);
  Tree::Members out{{"scene", a.scene},         {"technique", m.plan.technique}, {"width", view.width},
                    {"height", view.height},    {"threads", view.threads},       {"passes", std::move(passes)},
                    {"notes", std::move(notes)}};
  if (m.pictures == 0) return out;
  out.emplace_back("code", std::move(code));
  out.emplace_back("pictures", m.pictures);
  out.emplace_back("ms", m.ms);
  out.emplace_back("agrees", m.differences.empty());
  out.emplace_back("differences", std::move(differing));
  return out;
}

std::string right(std::string text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

// "  + 12.300 ms  31%   120 KiB  Transform: 3241 vertices to window coordinates".
std::string line_of(const MeasuredPass& p, const MeasuredPlan& m, Language l) {
  const Pass& pass = p.planned;
  const std::string reason = std::string(pass.name.in(l)) + (l == Language::japanese ? "：" : ": ") + pass.reason.in(l);
  if (!pass.needed) return "  - " + reason + "\n";
  std::string out = "  + ";
  if (m.pictures > 0) {
    const bool work = pass.kind == PassKind::pass;
    const int share = m.ms > 0 ? int(p.ms / m.ms * 100 + 0.5) : 0;
    const std::string kept(Words{"kept", "再利用"}.in(l));
    out += p.kept ? std::string(5, ' ') + kept + std::string(l == Language::japanese ? 5 : 7, ' ')
           : work ? right(ms_text(p.ms), 10) + right(std::to_string(share), 4) + "%"
                  : std::string(15, ' ') + " ";
  }
  const std::size_t bytes = m.pictures > 0 ? p.held : pass.bytes;
  out += right(bytes > 0 ? size_text(bytes) : "", 10);
  return out + "  " + reason + "\n";
}

std::string text_of(const MeasuredPlan& m, const std::string& scene, const View& view, Language l) {
  std::string out =
      m.plan.technique + ": " + scene + ", " + std::to_string(view.width) + "×" + std::to_string(view.height);
  if (m.pictures > 1) {
    const std::string n = std::to_string(m.pictures - 1);
    out += ", " + Text("CPU time, median of " + n, "CPU 時間、" + n + " 回の中央値").in(l);
  }
  out += "\n";
  std::size_t bytes = 0;
  for (const MeasuredPass& p : m.passes) bytes += m.pictures > 0 ? p.held : p.planned.bytes;
  for (const bool needed : {true, false}) {
    out += std::string((needed ? Words{"Runs", "必要なもの"} : Words{"Left out", "省いたもの"}).in(l)) + "\n";
    for (const MeasuredPass& p : m.passes)
      if (p.planned.needed == needed) out += line_of(p, m, l);
    if (needed && m.pictures > 0)
      out += "  = " + right(ms_text(m.ms), 10) + right(size_text(bytes), 15) + "\n";
    else if (needed)
      out += "  = " + size_text(bytes) + "\n";
  }
  for (const CodeRun& c : m.code) out += "  # " + c.parts + " (" + ms_text(c.compile_ms) + ")\n";
  for (const Text& note : m.plan.notes) out += "  ! " + note.in(l) + "\n";
  for (const Text& d : m.differences) out += "  ? " + d.in(l) + "\n";
  return out;
}

}  // namespace

int run_plan(const Arguments& a, std::span<const Technique> techniques, Language language) {
  const View view = view_of(a);
  const auto repeats = a.repeats.empty() ? usual_repeats : whole_number(a.repeats, 0, most_repeats);
  if (!repeats)
    throw bad_option("--repeats", a.repeats,
                     {"give a whole number from 0, which draws nothing, to 1000",
                      "0（描画しない）から 1000 の整数を指定してください"});
  Scene scene = scene_for(a, language);
  solve_for_command(scene, view, a, language);
  const Technique& technique = technique_for(a.technique, {"software"}, techniques, scene);
  MeasuredPlan m;
  if (*repeats == 0) {
    m.plan = technique.plan(scene, view);
    for (const Pass& pass : m.plan.passes) m.passes.emplace_back().planned = pass;
  } else {
    Progress progress;
    const ProgressLine line(progress, label_of(technique, language));
    m = measure_plan(technique, scene, view, *repeats, progress);
  }
  print(a.json ? to_json(json_of(m, a, view)) + "\n" : text_of(m, a.scene, view, language));
  return m.differences.empty() ? 0 : 1;
}

}  // namespace cg
