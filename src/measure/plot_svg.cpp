// A trade's plots as SVG (W3C, Scalable Vector Graphics 1.1, 2011), for a page or a paper.
#include <cmath>

#include "measure/plot.h"
#include "params/numbers.h"

namespace cg {

namespace {

// Series in Okabe and Ito's colours (Color Universal Design, 2002), those that print well on white.
constexpr std::string_view colour_of(PlotInk ink) {
  switch (ink) {
    case PlotInk::text:
      return "#1b1e24";
    case PlotInk::dim:
      return "#626a77";
    case PlotInk::grid:
      return "#e3e6eb";
    case PlotInk::front:
      return "#1b1e24";
    case PlotInk::series0:
      return "#0072b2";
    case PlotInk::series1:
      return "#d55e00";
    case PlotInk::series2:
      return "#009e73";
    case PlotInk::series4:
      return "#a07d00";
    default:
      return "#b0568a";
  }
}

std::string number(float v) { return number_text(std::round(double(v) * 100) / 100 + 0.0); }

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}
std::string attribute(std::string_view name, float value) { return attribute(name, number(value)); }

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

bool in_exponent(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '/'; }

// "h^-0.5" and "N^(-3/4)" with a raised exponent; a hyphen there is a minus.
std::string typeset(const std::string& text, float size) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '^' || i + 1 == text.size()) {
      const std::size_t next = std::min(text.find('^', i + 1), text.size());
      out += escaped(std::string_view(text).substr(i, next - i));
      i = next;
      continue;
    }
    const bool bracket = text[i + 1] == '(';
    const std::size_t begin = i + (bracket ? 2 : 1);
    std::size_t end = begin;
    while (end < text.size() && (bracket ? text[end] != ')' : in_exponent(text[end]))) ++end;
    if (!bracket && end > begin && text[end - 1] == '.') --end;  // a sentence's full stop
    std::string exponent;
    for (const char c : text.substr(begin, end - begin)) exponent += c == '-' ? "−" : std::string(1, c);
    const std::string rise = number(0.35f * size);
    out += "<tspan dy=\"-" + rise + "\" font-size=\"" + number(0.75f * size) + "\">" + escaped(exponent) + "</tspan>" +
           "<tspan dy=\"" + rise + "\">";
    i = end + (bracket && end < text.size() ? 1 : 0);
    const std::size_t next = std::min(text.find('^', i), text.size());
    out += escaped(std::string_view(text).substr(i, next - i)) + "</tspan>";
    i = next;
  }
  return out;
}

std::string text_element(const PlotMark& m) {
  std::string out = "<text" + attribute("fill", colour_of(m.ink)) + attribute("font-size", m.size);
  if (m.upright)
    out += attribute("transform", "translate(" + number(m.places[0].x) + " " + number(m.places[0].y) + ") rotate(-90)");
  else
    out += attribute("x", m.places[0].x) + attribute("y", m.places[0].y);
  return out + ">" + typeset(m.text, m.size) + "</text>\n";
}

std::string element(const PlotMark& m) {
  if (m.kind == PlotMark::Kind::text) return text_element(m);
  if (m.kind == PlotMark::Kind::line) {
    std::string points;
    for (const PlotPlace& p : m.places) points += (points.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
    return "<polyline" + attribute("points", points) + attribute("fill", "none") +
           attribute("stroke", colour_of(m.ink)) + attribute("stroke-width", m.size) +
           (m.dashed ? attribute("stroke-dasharray", "5 4") : "") + "/>\n";
  }
  const bool open = m.kind == PlotMark::Kind::circle;
  return "<circle" + attribute("cx", m.places[0].x) + attribute("cy", m.places[0].y) + attribute("r", m.size) +
         attribute("fill", open ? "#ffffff" : colour_of(m.ink)) +
         (open ? attribute("stroke", colour_of(m.ink)) + attribute("stroke-width", 1.4f) : "") + "/>\n";
}

std::string group(const PlotLayout& layout, float x, float y) {
  std::string out = "<g" + attribute("transform", "translate(" + number(x) + " " + number(y) + ")") + ">\n";
  for (const PlotMark& m : layout.marks) out += element(m);
  return out + "</g>\n";
}

}  // namespace

std::string svg_of(const Trade& trade, Language language) {
  constexpr float width = 640, height = 480, letters = 15, head = 64;
  const bool japanese = language == Language::japanese;
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1280\" height=\"544\" viewBox=\"0 0 1280 544\"" +
                    attribute("xml:lang", japanese ? "ja" : "en") +
                    attribute("font-family", "Inter, 'IPAexGothic', 'Noto Sans CJK JP', 'DejaVu Sans', sans-serif") +
                    ">\n<rect width=\"1280\" height=\"544\" fill=\"#ffffff\"/>\n";
  const std::string title = std::string(trade.knob->name.in(language)) + (japanese ? "：" : ": ") + trade.scene + ", " +
                            std::to_string(trade.width) + "×" + std::to_string(trade.height);
  std::string machine = trade.machine.cpu + (trade.machine.renderer.empty() ? "" : "; " + trade.machine.renderer);
  const auto line = [&](const std::string& text, float y, float size, PlotInk ink) {
    out += text_element({.kind = PlotMark::Kind::text, .ink = ink, .places = {{24, y}}, .size = size, .text = text});
  };
  line(title, 30, 20, PlotInk::text);
  const std::string repeats = std::to_string(trade.repeats);
  machine += japanese ? "。時間は " + repeats + " 回の中央値、横棒は最小から最大まで"
                      : "; times are medians of " + repeats + ", bars from the least to the greatest";
  line(machine, 52, 13, PlotInk::dim);
  out += group(lay_out(speed_plot(trade), width, height, letters, language), 0, head);
  out += group(lay_out(convergence_plot(trade), width, height, letters, language), width, head);
  return out + "</svg>\n";
}

}  // namespace cg
