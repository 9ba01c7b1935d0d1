#include "ui/verdict_mark.h"

#include <algorithm>

#include "ui/app.h"

namespace cg {

void draw_verdict_mark(const App& app, ImVec2 c, std::optional<Verdict> verdict) {
  const Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float r = look.px(6), thick = std::max(1.0f, look.px(2) * look.stroke);
  if (!verdict) return draw->AddCircle(c, r * 0.6f, look.palette.line, 12, std::max(1.0f, thick * 0.6f));
  switch (*verdict) {
    case Verdict::right: {
      const ImVec2 tick[3] = {
          {c.x - r * 0.8f, c.y}, {c.x - r * 0.2f, c.y + r * 0.6f}, {c.x + r * 0.9f, c.y - r * 0.7f}};
      return draw->AddPolyline(tick, 3, look.of(Quantity::reflection), 0, thick);
    }
    case Verdict::off:  // beside where it should be
      for (const float side : {-0.35f, 0.35f})
        draw->AddLine({c.x - r * 0.8f, c.y + side * r}, {c.x + r * 0.8f, c.y + side * r}, look.palette.error, thick);
      return draw->AddLine({c.x - r * 0.4f, c.y + r * 0.9f}, {c.x + r * 0.4f, c.y - r * 0.9f}, look.palette.error,
                           thick);
    case Verdict::broken:
      draw->AddLine({c.x - r * 0.7f, c.y - r * 0.7f}, {c.x + r * 0.7f, c.y + r * 0.7f}, look.palette.error, thick);
      return draw->AddLine({c.x - r * 0.7f, c.y + r * 0.7f}, {c.x + r * 0.7f, c.y - r * 0.7f}, look.palette.error,
                           thick);
    case Verdict::driver:
      return draw->AddTriangle({c.x, c.y - r * 0.9f}, {c.x + r * 0.95f, c.y + r * 0.7f},
                               {c.x - r * 0.95f, c.y + r * 0.7f}, look.of(Quantity::diffuse), thick * 0.8f);
    case Verdict::not_drawn:
    case Verdict::unavailable:
      return draw->AddLine({c.x - r * 0.7f, c.y}, {c.x + r * 0.7f, c.y}, look.palette.dim, thick);
  }
}

std::optional<Verdict> worst_of(std::span<const ExtremeResult> results) {
  const auto rank = [](Verdict v) {
    constexpr Verdict order[] = {Verdict::unavailable, Verdict::not_drawn, Verdict::right,
                                 Verdict::driver,      Verdict::off,       Verdict::broken};
    return std::find(std::begin(order), std::end(order), v) - std::begin(order);
  };
  std::optional<Verdict> worst;
  for (const ExtremeResult& r : results)
    if (!worst || rank(r.verdict) > rank(*worst)) worst = r.verdict;
  return worst;
}

}  // namespace cg
