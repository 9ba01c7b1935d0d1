// Values as a user gives them: options and presets out of range, JSON that other readers choke on, numbers as text.
#include <locale.h>

#include <bit>
#include <cstdio>
#include <limits>

#include "measure/extreme_tables.h"
#include "params/input_error.h"
#include "params/numbers.h"
#include "params/slots.h"
#include "scene/scene.h"
#include "workbench/open.h"
#include "workbench/preset.h"

namespace cg {

namespace {

Text message_of(const InputError& e) { return {e.message(Language::english), e.message(Language::japanese)}; }

ExtremeCase value_case(std::string id, Words name, std::string parameter, std::string value, Text right,
                       std::string text, std::function<ExtremeError()> take) {
  ExtremeCase c;
  c.id = "value-" + std::move(id), c.group = "values", c.name = name;
  c.parameter = std::move(parameter), c.value = std::move(value), c.right = std::move(right);
  c.input = ExtremeInput{std::move(text), std::move(take)};
  return c;
}

// An InputError that says `found` somewhere in its English, and what would work where `advice` is asked for.
template <class Take>
ExtremeError refusal(Take take, const std::string& found, bool advice) {
  try {
    take();
    return {1, Words{"it was taken, without an error", "エラーにならず受け取られた"}};
  } catch (const InputError& e) {
    const Text said = message_of(e);
    const bool told = said.en.find(found) != said.en.npos && said.en.find('\n') == said.en.npos;
    const bool advised = !e.accepted.en.empty() && !e.accepted.ja.empty();
    return {told && (advised || !advice) ? 0.0 : 1.0, said};
  }
}

void add_options(ExtremeTable& all) {
  constexpr std::pair<const char*, const char*> given[] = {
      {"material.k_a", "-0.1"},    {"material.k_d", "1.001"},   {"material.k_s", "nan"},
      {"material.n", "-1"},        {"material.n", "1000001"},   {"lights.0.k_0", "-1"},
      {"lights.0.k_1", "-1e-9"},   {"lights.0.k_2", "-1"},      {"lights.0.cutoff", "90.001"},
      {"lights.0.cutoff", "120"},  {"lights.0.cutoff", "-1"},   {"lights.0.exponent", "129"},
      {"lights.0.exponent", "-1"}, {"lights.0.diffuse", "nan"}, {"lights.0.position", "inf"},
      {"camera.fov", "0"},         {"camera.fov", "180"},       {"camera.near", "0"},
      {"camera.far", "inf"},       {"camera.height", "0"},      {"material.k_d", "0,5"},
  };
  for (const auto& [path, value] : given) {
    const std::string option = std::string(path) + "=" + value;
    all.push_back(
        value_case(option, {"An option out of its range", "範囲外のオプション"}, path, value,
                   Words{"An error that names the parameter and says what is accepted; the scene is unchanged.",
                         "パラメータと許される値を示すエラー。シーンは変わらない。"},
                   "--set " + option, [option, path = std::string(path)] {
                     Scene scene;
                     ExtremeError e = refusal([&] { set_parameter(scene, option); }, path, true);
                     if (scene != Scene{}) e.error = 1;
                     return e;
                   }));
  }
}

void add_presets(ExtremeTable& all) {
  const auto add = [&](std::string id, Words name, std::string value, std::string text, std::string found) {
    all.push_back(value_case("preset-" + std::move(id), name, "preset", std::move(value),
                             Words{"An error that names the key or the line.", "キーか行を示すエラーになる。"},
                             text.size() > 120 ? text.substr(0, 120) + "..." : text, [=] {
                               return refusal([&] { scene_of(parse_json(text, "a.json"), "a.json"); }, found, false);
                             }));
  };
  const auto material = [](const std::string& m) {
    return R"({"schema": 1, "model": "cube", "material": {)" + m + "}}";
  };
  const Words json{"JSON that is none", "正しくない JSON"}, range{"A value out of its range", "範囲外の値"};
  add("n", range, "n: 1e7", material("\"n\": 1e7"), "material.n");
  add("key", {"A key that is not known", "知らないキー"}, "shinyness", material("\"shinyness\": 5"),
      "material.shinyness");
  add("type", {"A value of another type", "型の違う値"}, "n: \"5\"", material("\"n\": \"5\""), "material.n");
  add("nan", json, "NaN", material("\"n\": NaN"), "a.json:1");
  add("1e400", {"A number beyond double", "double を超える数"}, "1e400", material("\"n\": 1e400"), "a.json:1");
  add("comma", json, "{\"n\": 5,}", material("\"n\": 5,"), "a.json:1");
  add("twice", {"A key that is there twice", "二重のキー"}, "n, n", material("\"n\": 5, \"n\": 6"), "a.json:1");
  add("depth", {"JSON 1000 levels deep", "1000 段の入れ子"}, "1000", std::string(1000, '[') + std::string(1000, ']'),
      "a.json");
  add("cut", {"JSON that ends early", "途中で終わる JSON"}, "{\"schema\": 1", "{\"schema\": 1,\n\"mod", "a.json:2");
  add("schema", {"A preset of a newer program", "新しい版のプリセット"}, "schema: 99", R"({"schema": 99})", "schema");
  add("light-70", {"More lights than there may be", "多すぎる光源"}, "lights.70",
      R"({"schema": 1, "model": "cube", "lights": {"70": {}}})", "lights.70");
  add("tessellation", {"A shape cut too finely", "細かすぎる分割"}, "100000",
      R"({"schema": 1, "model": "uv-sphere", "objects": {"0": {"tessellation": 100000}}})", "objects.0.tessellation");
  add("model", {"A model that is not there", "存在しないモデル"}, "no-such.obj",
      R"({"schema": 1, "model": "no-such.obj"})", "no-such.obj");
}

// How many of a row of numbers come back from their text as other bits.
ExtremeError lost_bits(const std::function<std::string(double)>& text) {
  std::uint64_t state = 1;
  int lost = 0;
  std::string first;
  for (int i = 0; i < 10000; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double v = std::bit_cast<double>((state & 0x800fffffffffffffu) | ((state >> 54) + 512) << 52);
    const std::string written = text(v);
    const auto back = parse_number(written);
    if (back && std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(v)) continue;
    if (lost++ == 0) first = written;
  }
  const std::string n = std::to_string(lost);
  return {double(lost),
          {n + " of 10000 numbers lost bits" + (first.empty() ? "" : ": " + first),
           "10000 個中 " + n + " 個でビットが失われた" + (first.empty() ? "" : "：" + first)}};
}

void add_number_text(ExtremeTable& all) {
  const Text right = Words{"The same bits come back from the text.", "文字から同じビットが戻る。"};
  all.push_back(value_case("number-text", {"Numbers as text", "数の文字表記"}, "preset, number", "10 000 doubles",
                           right, "0.1", [] { return lost_bits(number_text); }));
  all.push_back(value_case("c-literal", {"Numbers as C", "C のソースの数"}, "C export", "10 000 doubles", right, "0.1",
                           [] { return lost_bits(c_literal); }));
  all.push_back(value_case("c-literal-whole", {"A whole number as C", "C のソースの整数"}, "C export", "1",
                           Words{"1.0: it stays a double in C.", "1.0。C でも double のまま。"}, "1",
                           []() -> ExtremeError {
                             const std::string text = c_literal(1);
                             return {text == "1.0" ? 0.0 : 1.0, {text, text}};
                           }));
  for (const double v : {5e-324, std::numeric_limits<double>::max(), -0.0}) {
    const std::string text = number_text(v);
    all.push_back(value_case("number-" + text, {"A number at the end of double", "double の端の数"}, "preset, number",
                             text, right, text, [v]() -> ExtremeError {
                               const std::string written = number_text(v);
                               const auto back = parse_number(written);
                               const bool same =
                                   back && std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(v);
                               return {same ? 0.0 : 1.0, {written, written}};
                             }));
  }
}

// A thread whose C library writes a decimal comma, while this lives. Throws InputError where there is no such locale.
class DecimalComma {
 public:
  DecimalComma() {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE", "fr_FR"})
      if (!locale_) locale_ = ::newlocale(LC_ALL_MASK, name, nullptr);
    if (!locale_)
      throw InputError("locale", {"none with a decimal comma is installed", "小数点がコンマのロケールがない"});
    before_ = ::uselocale(locale_);
  }
  ~DecimalComma() { ::uselocale(before_), ::freelocale(locale_); }
  DecimalComma(const DecimalComma&) = delete;
  DecimalComma& operator=(const DecimalComma&) = delete;

 private:
  locale_t locale_ = nullptr, before_ = nullptr;
};

void add_locale(ExtremeTable& all) {
  all.push_back(value_case("decimal-comma", {"A locale with a decimal comma", "小数点がコンマのロケール"}, "LC_NUMERIC",
                           "de_DE",
                           Words{"Files keep the point: 0.5 is written and read as 0.5.",
                                 "ファイルでは点のまま。0.5 は 0.5 と書き、0.5 と読む。"},
                           "{\"n\": 0.5}", []() -> ExtremeError {
                             const DecimalComma comma;
                             const std::string text = to_json(parse_json("{\"n\": 0.5}", "a.json"), 0) + " " +
                                                      c_literal(0.5) + " " + number_text(0.5);
                             return {text == "{\"n\":0.5} 0.5 0.5" ? 0.0 : 1.0, {text, text}};
                           }));
}

}  // namespace

void add_value_extremes(ExtremeTable& all) {
  add_options(all);
  add_presets(all);
  add_number_text(all);
  add_locale(all);
}

}  // namespace cg
