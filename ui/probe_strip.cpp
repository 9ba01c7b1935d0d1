#include "ui/probe_strip.h"

#include <algorithm>
#include <cmath>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/number.h"
#include "ui/probe_marks.h"
#include "ui/widgets.h"

namespace cg {

namespace {

// With three decimals; what is there but rounds to nothing is told from 0.
std::string digits(double v) {
  if (v == 0) return "0";
  const double size = std::abs(v);
  if (!std::isfinite(v) || size >= 1e5) return number_text(v, 0, 8);
  if (size < 0.0005) return "≈0";
  const double step = size >= 100 ? 1 : size >= 10 ? 10 : 1000;
  const double rounded = std::round(v * (size >= 100 ? 1 : step)) / (size >= 100 ? 1 : step);
  return number_text(rounded, size >= 100 ? 0 : size >= 10 ? 1 : 3, 9);
}

// A parameter: as it was set, at most three decimals.
std::string factor(double v) { return number_text(std::round(v * 1000) / 1000, 0, 9); }

bool grey(const glm::dvec3& c) {
  const double tolerance = 1e-6 * std::max(1.0, std::abs(c.x));
  return std::abs(c.x - c.y) < tolerance && std::abs(c.x - c.z) < tolerance;
}

std::string triple(const glm::dvec3& c) {
  return grey(c) ? digits(c.x) : digits(c.x) + " " + digits(c.y) + " " + digits(c.z);
}

std::optional<Part> part_of(const ProbedTerm& term) {
  switch (term.quantity) {
    case Quantity::emission:
      return Part::emission;
    case Quantity::ambient:
      return Part::ambient;
    case Quantity::diffuse:
      return Part::diffuse;
    case Quantity::specular:
      return Part::specular;
    default:
      return std::nullopt;
  }
}

// The terms of all lights, by part of the equation.
struct Totals {
  std::array<glm::dvec3, parts_with_numbers> of{};
  explicit Totals(const std::vector<ProbedTerm>& terms, const glm::dvec3& sum) {
    of.fill(glm::dvec3(0));
    of[std::size_t(Part::sum)] = sum;
    for (const ProbedTerm& term : terms)
      if (const auto part = part_of(term)) of[std::size_t(*part)] += term.rgb;
  }
  bool all_grey() const {
    return std::all_of(of.begin(), of.end(), [](const glm::dvec3& c) { return grey(c); });
  }
};

NumberRow values(const Totals& totals, int channel, std::string label) {
  NumberRow row;
  row.label = std::move(label);
  for (std::size_t i = 0; i < parts_with_numbers; ++i) row.cells[i] = digits(totals.of[i][channel]);
  return row;
}

// The factors of one light at one point, channel `c`: "1 × 0.8 × 0.731".
NumberRow factors(const Probe& p, const ProbedLight& l, int c, bool with_global) {
  const double faded = l.attenuation * l.spot;
  const std::string fade = faded == 1 ? "" : digits(faded) + " × ";
  NumberRow row;
  row.signs = false;
  if (l.ambient[c] == 0 && with_global && !p.radiosity)
    row.cells[std::size_t(Part::ambient)] = factor(p.global_ambient[c]) + " × " + factor(p.material.k_a[c]);
  row.cells[std::size_t(Part::diffuse)] =
      fade + factor(l.diffuse[c]) + " × " + factor(p.material.k_d[c]) + " × " + digits(l.n_dot_l);
  const std::string power =
      l.n_dot_l > 0 ? digits(l.lobe_cosine) + "^{" + factor(p.material.n) + "}" : std::string("0");
  row.cells[std::size_t(Part::specular)] =
      fade + factor(l.specular[c]) + " × " + factor(p.material.k_s[c]) + " × " + power;
  return row;
}

// Where light was computed, if that is one point: its factors can stand under the terms.
const LitPoint* single_point(const App& app, const Probe& p) {
  if (p.mode == ShadingMode::gouraud && app.probing.vertex < 0) return nullptr;
  return &shown_point(p, app.probing.vertex);
}

// "a = b" in each cell that has both.
NumberRow joined(const NumberRow& factors, NumberRow values) {
  for (std::size_t i = 0; i < parts_with_numbers; ++i)
    if (!factors.cells[i].empty()) values.cells[i] = factors.cells[i] + " = " + values.cells[i];
  return values;
}

std::string vertex_name(const App& app, std::size_t k) {
  return std::string(Words{"vertex ", "頂点 "}.in(app.language())) + std::to_string(k + 1);
}

// A row for each light, and what belongs to none.
ProbeRows light_rows(const App& app, const Probe& p, const LitPoint& point) {
  ProbeRows out;
  const Language language = app.language();
  const auto add = [&](int light, const std::string& label) {
    std::vector<ProbedTerm> terms;
    glm::dvec3 sum(0);
    for (const ProbedTerm& t : point.terms)
      if (t.light == light) terms.push_back(t), sum += t.rgb;
    out.narrow.push_back(values(Totals(terms, sum), 0, label));
    out.wide.push_back(out.narrow.back());
  };
  add(-1, std::string((p.radiosity ? Words{"radiosity", "ラジオシティ"} : Words{"ambient", "環境光"}).in(language)));
  for (const ProbedLight& l : point.lights) {
    add(l.light, std::string(Words{"light ", "光源 "}.in(language)) + std::to_string(l.light));
    out.wide.back() = joined(factors(p, l, 0, false), out.wide.back());
  }
  const NumberRow total = values(Totals(point.terms, point.sum), 0, std::string(Words{"sum", "合計"}.in(language)));
  out.narrow.push_back(total), out.wide.push_back(total);
  return out;
}

// With Gouraud shading and no colours: the three vertices, and what is interpolated from them.
std::vector<NumberRow> vertex_rows(const App& app, const Probe& p) {
  std::vector<NumberRow> rows;
  for (std::size_t k = 0; k < p.vertices.size(); ++k) {
    const LitPoint& v = p.vertices[k];
    rows.push_back(values(Totals(v.terms, v.sum), 0, vertex_name(app, k) + " × " + digits(v.weight)));
  }
  rows.push_back(values(Totals(p.terms, p.sum), 0, std::string(Words{"interpolated", "補間"}.in(app.language()))));
  return rows;
}

}  // namespace

const Probe* shown_probe(const App& app) {
  if (!app.probing.at) return nullptr;
  const auto& results = app.probing.results;
  const std::size_t side = std::size_t(app.probing.side);
  const auto& best = results[side] ? results[side] : results[1 - side];
  return best ? &best->probe : nullptr;
}

ProbeRows number_rows(const App& app, const Probe& p, std::size_t most_rows) {
  ProbeRows out;
  if (!p.covered || p.object < 0) return out;
  const LitPoint* point = single_point(app, p);
  const Totals totals = point ? Totals(point->terms, point->sum) : Totals(p.terms, p.sum);
  const bool one = totals.all_grey();
  if (!point && one) {
    out.wide = out.narrow = vertex_rows(app, p);
    return out;
  }
  if (one && point && point->lights.size() > 1 && point->lights.size() + 2 <= most_rows)
    return light_rows(app, p, *point);
  const ProbedLight* only = point && point->lights.size() == 1 ? &point->lights.front() : nullptr;
  constexpr std::array<const char*, 3> letters{"R", "G", "B"};
  for (int c = 0; c < (one ? 1 : 3); ++c) {
    const NumberRow row = values(totals, c, one ? "" : letters[std::size_t(c)]);
    if (one && only) out.narrow.push_back(factors(p, *only, c, true));
    out.narrow.push_back(row);
    out.wide.push_back(only ? joined(factors(p, *only, c, true), row) : row);
  }
  if (one) out.wide = out.narrow;
  return out;
}

std::string probe_title(const App& app, const Probe& p) {
  const Language l = app.language();
  const auto say = [&](Words words) { return std::string(words.in(l)); };
  std::string title = say({"Pixel (", "画素 ("}) + std::to_string(p.pixel.x) + ", " + std::to_string(p.pixel.y) + ")";
  for (const Technique& t : app.techniques)
    if (t.id == p.technique) title += say({", ", "　"}) + std::string(t.name.in(l));
  if (!p.covered) return title + say({": background", "　背景"});
  title += say({", ", "　"}) + std::string(names_of<ShadingMode>[std::size_t(p.mode)].label.in(l));
  if (app.isolated != Isolated{}) title += say({" (one part alone)", "（一部だけ）"});
  return title;
}

namespace {

struct Item {
  std::string label, value;
  Quantity quantity = Quantity::none;
};

float line_height(const App& app) { return app.look.px(19); }

// Items in at most so many lines; returns the height.
float draw_items(App& app, const std::vector<Item>& items, ImVec2 at, float width, int lines) {
  if (lines < 1 || items.empty()) return 0;
  Look& look = app.look;
  const float gap = look.px(6), between = look.px(18), line = line_height(app);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  float x = at.x, y = at.y;
  for (const Item& item : items) {
    const float label_w = item.label.empty() ? 0 : text_width(look.fonts.small, noted(app, item.label)) + gap;
    const float w = label_w + text_width(look.fonts.small_mono, noted(app, item.value));
    if (x > at.x && x + w > at.x + width) {
      if (--lines < 1) break;
      x = at.x, y += line;
    }
    const bool hovered = ImGui::IsMouseHoveringRect({x, y}, {x + w, y + line}) && ImGui::IsWindowHovered();
    if (hovered && item.quantity != Quantity::none) app.lit_next = item.quantity;
    const bool lit = item.quantity != Quantity::none && app.lit == item.quantity;
    if (lit)
      draw->AddRectFilled({x - look.px(3), y}, {x + w + look.px(3), y + line}, faded(look.of(item.quantity), 0.16f),
                          look.px(4));
    set_text(draw, look.fonts.small, {x, y + look.px(14)}, look.palette.dim, item.label);
    set_text(draw, look.fonts.small_mono, {x + label_w, y + look.px(14)},
             item.quantity == Quantity::none ? look.palette.text : look.of(item.quantity), item.value);
    x += w + between;
  }
  return y + line - at.y;
}

std::vector<Item> result_items(const App& app, const Probe& p) {
  const Language l = app.language();
  const auto say = [&](Words words) { return std::string(words.in(l)); };
  std::vector<Item> items;
  if (p.covered && p.clamps && glm::distance(p.sum, p.clamped) > 5e-4)
    items.push_back({p.mode == ShadingMode::gouraud ? say({"clamped at the vertices", "頂点で制限"})
                                                    : say({"clamped to 0..1", "0..1 に制限"}),
                     triple(p.clamped)});
  const auto& results = app.probing.results;
  const auto shown = [&](std::size_t side) { return triple(results[side]->probe.frame); };
  if (results[0] && results[1] && shown(0) == shown(1)) {
    items.push_back({say({"in both pictures", "両方の画像"}), shown(0)});
    return items;
  }
  constexpr std::array<Words, 2> names{{{"left picture", "左の画像"}, {"right picture", "右の画像"}}};
  for (std::size_t side = 0; side < 2; ++side)
    if (results[side]) items.push_back({say(names[side]), shown(side)});
  return items;
}

std::vector<Item> factor_items(const App& app, const Probe& p) {
  std::vector<Item> items;
  const LitPoint& at = shown_point(p, app.probing.vertex);
  const int chosen = probed_light(app, at);
  for (const ProbedLight& l : at.lights) {
    if (l.light != chosen) continue;
    const Language language = app.language();
    const auto say = [&](Words words) { return std::string(words.in(language)); };
    if (app.scene.lights.size() > 1) items.push_back({"LIGHT" + std::to_string(l.light), ""});
    items.push_back({"N·L", digits(l.cosine), Quantity::diffuse});
    const bool blinn = p.reflection == Reflection::half_vector;
    items.push_back({blinn ? "N·H" : "R·V", l.cosine > 0 ? digits(l.lobe_cosine) : "–", Quantity::specular});
    items.push_back({blinn ? "(N·H)ⁿ" : "(R·V)ⁿ", digits(l.lobe), Quantity::specular});
    items.push_back({say({"attenuation", "減衰"}), digits(l.attenuation)});
    items.push_back({say({"spot", "スポット"}), digits(l.spot)});
    if (l.distance > 0) items.push_back({"r", factor(l.distance) + " m"});
    if (std::abs(at.normal_length - 1) > 5e-4) items.push_back({"|N|", digits(at.normal_length)});
  }
  return items;
}

}  // namespace

float draw_probe_results(App& app, const Probe& p, ImVec2 at, ImVec2 size) {
  const int lines = int((size.y + app.look.px(2)) / line_height(app));
  const bool lit = p.covered && p.object >= 0;
  const float height = draw_items(app, result_items(app, p), at, size.x, std::max(lines - (lit ? 1 : 0), 1));
  if (!lit) return height;
  return height + draw_items(app, factor_items(app, p), {at.x, at.y + height}, size.x,
                             lines - int(height / line_height(app) + 0.5f));
}

namespace {

// One word to choose, in the small face; returns where it ends. `id` is unique in the line.
float word(App& app, const char* id, float x, float baseline, std::string_view text, bool chosen, bool& pressed) {
  Look& look = app.look;
  const float w = text_width(look.fonts.small, noted(app, text)), pad = look.px(5);
  ImGui::SetCursorScreenPos({x, baseline - look.px(15)});
  pressed = ImGui::InvisibleButton(id, {w + 2 * pad, look.px(21)});
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const bool hovered = ImGui::IsItemHovered();
  if (chosen) draw->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), look.palette.raised, look.px(4));
  set_text(draw, look.fonts.small, {x + pad, baseline}, chosen || hovered ? look.palette.text : look.palette.dim, text);
  return x + w + 2 * pad + look.px(1);
}

struct Choices {
  std::vector<std::string> words;
  int chosen = 0;
};

float width_of(App& app, const Choices& choices) {
  float w = 0;
  for (const std::string& text : choices.words)
    w += text_width(app.look.fonts.small, noted(app, text)) + app.look.px(11);
  return w;
}

// Draws the words and returns the one that is chosen afterwards.
int choose_word(App& app, const char* id, const Choices& choices, float x, float baseline) {
  int chosen = choices.chosen;
  ImGui::PushID(id);
  for (int i = 0; i < int(choices.words.size()); ++i) {
    ImGui::PushID(i);
    bool pressed = false;
    x = word(app, "word", x, baseline, choices.words[std::size_t(i)], i == choices.chosen, pressed);
    if (pressed) chosen = i;
    ImGui::PopID();
  }
  ImGui::PopID();
  return chosen;
}

}  // namespace

void draw_probe_choices(App& app, const Probe& p, float left, float right, float baseline) {
  const Language l = app.language();
  const auto say = [&](Words words) { return std::string(words.in(l)); };
  float x = right;
  if (const int count = int(app.scene.lights.size()); count > 1) {
    Choices lights{{say({"all lights", "全光源"})}, app.isolated.light + 1};
    for (int i = 0; i < std::min(count, 8); ++i) lights.words.push_back(std::to_string(i));
    x -= width_of(app, lights);
    if (x < left) return;
    const int chosen = choose_word(app, "lights", lights, x, baseline) - 1;
    if (chosen != app.isolated.light && chosen >= 0) app.light = chosen;
    app.isolated.light = chosen;
    x -= app.look.px(14);
  }
  if (p.vertices.size() != 3) return;
  const Choices vertices{{say({"interpolated", "補間"}), vertex_name(app, 0), "2", "3"},
                         std::clamp(app.probing.vertex, -1, 2) + 1};
  x -= width_of(app, vertices);
  if (x >= left) app.probing.vertex = choose_word(app, "vertices", vertices, x, baseline) - 1;
}

}  // namespace cg
