// Reads Wavefront MTL into materials of the lecture's light model.
// Source: Alias|Wavefront, "MTL material format", Advanced Visualizer Manual, file formats.
#include <algorithm>
#include <glm/common.hpp>

#include "scene/model_file.h"
#include "scene/text_scanner.h"

namespace cg {

namespace {

// What the file says about one material before it is turned into k_a .. k_t.
struct MtlEntry {
  Material material;
  double opacity = 1;                   // d, or 1 - Tr
  glm::dvec3 filter{1};                 // Tf
  std::optional<std::int64_t> illum{};  // the illumination model, 0 .. 10
};

// The description of a field of Material: its range is the one place that says what is accepted.
template <class Value>
const About& about(Value Material::*member) {
  const About* found = nullptr;
  // The type is spelled out: GCC 12 gets decltype(member) wrong inside a lambda inside a lambda.
  const auto look = [&](const auto& one) {
    if constexpr (std::same_as<std::remove_cvref_t<decltype(one)>, Field<Material, Value>>)
      if (one.member == member) found = &one.about;
  };
  std::apply([&](const auto&... f) { (look(f), ...); }, fields_of<Material>);
  return *found;
}

class MtlReader {
 public:
  MtlReader(std::string_view bytes, const std::string& where, std::vector<Text>& notes)
      : in_(bytes, where, {.comment = '#', .joins_lines = true}), notes_(notes) {}

  Materials read() {
    while (in_.next_line()) {
      const std::string_view key = in_.word();
      if (key == "newmtl")
        begin_material();
      else if (!entry_)
        in_.fail(phrase({"{0} before the first newmtl", "最初の newmtl より前に{0}がある"}, {in_quotes(key)}),
                 {"a material file begins with newmtl", "マテリアルファイルは newmtl で始まる"});
      else
        statement(key);
    }
    end_material();
    add_notes();
    return std::move(materials_);
  }

 private:
  void begin_material() {
    end_material();
    name_ = in_.rest();
    if (materials_.contains(name_))
      in_.fail(phrase({"the material {0} is there twice", "素材{0}が 2 つある"}, {in_quotes(name_)}),
               {"each newmtl has a name of its own", "newmtl の名前は 1 つずつ違うもの"});
    entry_.emplace();
    entry_->material.k_s = glm::dvec3(0);  // a highlight only where the file asks for one
  }

  void statement(std::string_view key) {
    Material& m = entry_->material;
    const std::string_view first = in_.peek();
    if (first == "spectral" || first == "xyz" || first == "-halo") return leave_out(key);
    if (key == "Ka") return colour(m.k_a, about(&Material::k_a).range);
    if (key == "Kd") return colour(m.k_d, about(&Material::k_d).range);
    if (key == "Ks") return colour(m.k_s, about(&Material::k_s).range);
    if (key == "Ke") return colour(m.emission, about(&Material::emission).range);
    if (key == "Tf") return colour(entry_->filter, about(&Material::k_t).range);
    if (key == "Ns") return number(m.n, about(&Material::n).range);
    if (key == "d") return number(entry_->opacity, {0, 1});
    if (key == "Tr") {
      number(entry_->opacity, {0, 1});
      entry_->opacity = 1 - entry_->opacity;
    } else if (key == "illum") {
      entry_->illum = in_.integer({"an illumination model from 0 to 10", "0 から 10 の照明モデル"});
      if (entry_->illum < 0 || entry_->illum > 10)
        in_.fail(phrase({"{0} is not an illumination model", "{0}という照明モデルはない"}, {in_quotes(first)}),
                 {"illum is a number from 0 to 10", "illum は 0 から 10"});
    } else if (key != "Ni" && key != "sharpness") {
      leave_out(key);
    }
  }

  void leave_out(std::string_view key) {
    const bool map =
        key.starts_with("map_") || key == "bump" || key == "disp" || key == "decal" || key == "refl" || key == "norm";
    Left& left = map ? maps_ : others_;
    if (left.count++ == 0) left = {1, in_.line(), std::string(key)};
  }

  double limited(double value, const Range& range) {
    if (range.contains(value)) return value;
    if (limited_.count++ == 0) limited_ = {1, in_.line(), ""};
    return std::clamp(value, range.min, range.max);
  }

  void number(double& to, const Range& range) {
    to = limited(in_.number({"a number", "数"}), range);
    in_.expect_end({"one number is expected", "数は 1 つだけ"});
  }

  // r g b, or one number for all three.
  void colour(glm::dvec3& to, const Range& range) {
    to = glm::dvec3(limited(in_.number({"a colour r g b", "色 r g b"}), range));
    if (in_.at_end()) return;
    to.g = limited(in_.number({"the green of a colour", "色の緑"}), range);
    to.b = limited(in_.number({"the blue of a colour", "色の青"}), range);
    in_.expect_end({"a colour has one or three numbers", "色の数は 1 つまたは 3 つ"});
  }

  // Turns the illumination model into k: 0 is the colour K_d without any light, 1 has no highlight, 3 to 9 reflect.
  void end_material() {
    if (!entry_) return;
    Material& m = entry_->material;
    if (entry_->illum == 0) {
      m.emission = glm::min(m.emission + m.k_d, about(&Material::emission).range.max);
      m.k_a = m.k_d = glm::dvec3(0);
    }
    if (entry_->illum == 0 || entry_->illum == 1) m.k_s = glm::dvec3(0);
    if (entry_->illum >= 3 && entry_->illum <= 9) m.k_r = m.k_s;
    m.k_t = (1 - entry_->opacity) * entry_->filter;
    materials_.emplace(std::move(name_), m);
    entry_.reset();
  }

  void add_notes() {
    if (maps_.count > 0)
      notes_.push_back(
          phrase({"{0}: {1} texture maps are not read yet (the first, {2}, in line {3})",
                  "{0}: テクスチャ{1}個はまだ読まない（最初は{3}行目の{2}）"},
                 {{in_.where(), in_.where()}, text_of(maps_.count), in_quotes(maps_.key), text_of(maps_.line)}));
    if (others_.count > 0)
      notes_.push_back(
          phrase({"{0}: {1} statements have no counterpart here (the first, {2}, in line {3})",
                  "{0}: 対応するもののない命令が{1}個ある（最初は{3}行目の{2}）"},
                 {{in_.where(), in_.where()}, text_of(others_.count), in_quotes(others_.key), text_of(others_.line)}));
    if (limited_.count > 0)
      notes_.push_back(phrase({"{0}: {1} values were outside their range and are limited to it (the first in line {2})",
                               "{0}: 範囲の外にある値{1}個を範囲に収めた（最初は{2}行目）"},
                              {{in_.where(), in_.where()}, text_of(limited_.count), text_of(limited_.line)}));
  }

  // What was left out or changed: how often, and where first.
  struct Left {
    std::uint64_t count = 0;
    long line = 0;
    std::string key;
  };

  TextScanner in_;
  std::vector<Text>& notes_;
  Materials materials_;
  std::string name_;
  std::optional<MtlEntry> entry_;  // empty before the first newmtl
  Left maps_, others_, limited_;
};

}  // namespace

Materials read_mtl(std::string_view bytes, const std::string& where, std::vector<Text>& notes) {
  return MtlReader(bytes, where, notes).read();
}

}  // namespace cg
