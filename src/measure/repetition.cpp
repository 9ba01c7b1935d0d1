#include "measure/repetition.h"

#include "measure/verdict.h"
#include "params/input_error.h"
#include "params/numbers.h"

namespace cg {

namespace {

const Text what_works{"a file that `shadebench trade -o DIR` wrote works",
                      "`shadebench trade -o DIR` の保存した json が使える"};

const Tree& member(const Tree& tree, const char* key, const std::string& file) {
  const Tree* found = tree.find(key);
  if (!found)
    throw InputError(file,
                     {"it holds no trade: `" + std::string(key) + "` is missing",
                      "測定結果でない（`" + std::string(key) + "` がない）"},
                     what_works);
  return *found;
}

double number(const Tree& tree, const char* key, const std::string& file) {
  const double* v = member(tree, key, file).number();
  if (!v)
    throw InputError(file, {"`" + std::string(key) + "` is no number", "`" + std::string(key) + "` が数でない"},
                     what_works);
  return *v;
}

std::string words(const Tree& tree, const char* key, const std::string& file) {
  const std::string* v = member(tree, key, file).string();
  if (!v)
    throw InputError(file, {"`" + std::string(key) + "` is no text", "`" + std::string(key) + "` が文字列でない"},
                     what_works);
  return *v;
}

const Tree::List& settings_of(const Tree& earlier, const std::string& file) {
  const Tree::List* list = member(earlier, "settings", file).list();
  if (!list) throw InputError(file, {"`settings` is no list", "`settings` がリストでない"}, what_works);
  return *list;
}

// An error that is no number is written as null: equal to another that is none.
bool same(const Tree& setting, const char* key, double now, const std::string& file) {
  return member(setting, key, file) == parse_json(to_json(Tree(now)), file);
}

}  // namespace

void check_same_trade(const Tree& earlier, const Knob& knob, const std::string& scene, const std::string& file) {
  const std::string id = words(member(earlier, "knob", file), "id", file), of = words(earlier, "scene", file);
  settings_of(earlier, file);
  if (id == knob.id && of == scene) return;
  throw InputError(file, {"it holds the trade of " + id + " with " + of, id + "、" + of + " の測定結果"},
                   {"give the file of " + std::string(knob.id) + " with " + scene,
                    std::string(knob.id) + "、" + scene + " の結果を指定すること"});
}

Repetition hold_against(const Trade& now, const Tree& earlier, const std::string& file) {
  const Tree::List& settings = settings_of(earlier, file);
  bool same_ladder = settings.size() == now.points.size() && number(earlier, "width", file) == now.width &&
                     number(earlier, "height", file) == now.height;
  for (std::size_t i = 0; same_ladder && i < settings.size(); ++i)
    same_ladder = words(settings[i], "id", file) == now.ladder.settings[i].id;
  if (!same_ladder)
    throw InputError(
        file, {"its settings or size are others", "設定または画像の大きさが異なる"},
        {"measure with the same --size, --technique and --set", "--size、--technique、--set を揃えること"});
  Repetition out;
  out.settings = settings.size();
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Tree& s = settings[i];
    const TradePoint& p = now.points[i];
    const std::string& id = now.ladder.settings[i].id;
    if (same(s, "rmse", p.errors.rmse, file) && same(s, "max", p.errors.max, file))
      ++out.same_errors;
    else
      out.other.push_back(id);
    const Spread then{number(s, "ms_low", file), number(s, "ms", file), number(s, "ms_high", file)};
    if (!(p.ms.median >= then.low && p.ms.median <= then.high)) out.outliers.push_back({id, p.ms.median, then});
  }
  return out;
}

Tree json_of(const Repetition& r) {
  Tree::List other, outliers;
  for (const std::string& id : r.other) other.push_back(id);
  for (const Repetition::Outlier& o : r.outliers)
    outliers.push_back(Tree::Members{{"id", o.id},
                                     {"ms", o.ms},
                                     {"earlier_ms", o.earlier.median},
                                     {"earlier_ms_low", o.earlier.low},
                                     {"earlier_ms_high", o.earlier.high}});
  return Tree::Members{{"settings", r.settings},
                       {"same_errors", r.same_errors},
                       {"times_within", r.settings - r.outliers.size()},
                       {"other_errors", std::move(other)},
                       {"times_outside", std::move(outliers)}};
}

std::string text_of(const Repetition& r, Language language) {
  const auto of = [&](std::size_t n) { return std::to_string(n) + "/" + std::to_string(r.settings); };
  std::string out =
      Text("errors the same bits: " + of(r.same_errors), "誤差が同じビット：" + of(r.same_errors)).in(language);
  const std::string within = of(r.settings - r.outliers.size());
  out += Text("; times within the earlier spread: " + within, "、時間が前回の幅の中：" + within).in(language) + "\n";
  for (const std::string& id : r.other)
    out += "  " + id + Text(": another error", "：誤差が異なる").in(language) + "\n";
  for (const Repetition::Outlier& o : r.outliers)
    out += "  " + o.id + ": " + short_number(o.ms) + " ms, " + Text("earlier ", "前回 ").in(language) +
           short_number(o.earlier.median) + " (" + short_number(o.earlier.low) + "–" + short_number(o.earlier.high) +
           ")\n";
  return out;
}

}  // namespace cg
