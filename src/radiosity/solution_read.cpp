#include <algorithm>
#include <charconv>
#include <optional>

#include "params/file.h"
#include "params/slots.h"
#include "radiosity/elements.h"
#include "radiosity/solution_file.h"
#include "radiosity/solution_format.h"
#include "scene/ply_body.h"

namespace cg {

namespace {

namespace format = solution_format;

const Text solve_again{"compute it again: shadebench radiosity SCENE -o FILE",
                       "もう一度計算する: shadebench radiosity シーン -o ファイル"};

[[noreturn]] void refuse(const std::string& where, Text found) {
  throw InputError(where, std::move(found), solve_again);
}

Text cut_short(std::uint64_t has, const std::string& of) {
  return phrase({"the solution is cut short: {0} bytes{1}", "解が途中で切れている: {0} バイト{1}"},
                {text_of(has), of.empty() ? Text("", "") : Text(" of " + of, "（全 " + of + " バイト）")});
}

// What stands in the header behind a key, up to the line's end.
std::optional<std::string_view> comment(std::string_view header, std::string_view key) {
  const std::size_t at = header.find("\n" + std::string(key));
  if (at == header.npos) return std::nullopt;
  const std::string_view rest = header.substr(at + 1 + key.size());
  return rest.substr(0, rest.find('\n'));
}

std::optional<std::uint64_t> hexadecimal(std::optional<std::string_view> text) {
  std::uint64_t value = 0;
  if (!text || text->size() != format::digits) return std::nullopt;
  const auto [stop, error] = std::from_chars(text->data(), text->data() + text->size(), value, 16);
  if (error != std::errc() || stop != text->data() + text->size()) return std::nullopt;
  return value;
}

// The header, when the file is one of ours and all of it is there as it was written.
std::string_view checked_header(std::string_view bytes, const std::string& where) {
  if (!bytes.starts_with("ply\n") || bytes.substr(0, 256).find(format::title) == bytes.npos)
    throw InputError(
        where, {"this is not a radiosity solution", "ラジオシティの解のファイルではない"},
        {"a PLY file that shadebench radiosity wrote is expected", "shadebench radiosity が書いた PLY ファイルが必要"});
  const std::size_t end = bytes.find("\n" + std::string(format::end));
  if (end == bytes.npos) refuse(where, cut_short(bytes.size(), ""));
  const std::string_view header = bytes.substr(0, end + 1 + format::end.size());
  const auto size = hexadecimal(comment(header, format::size_key));
  const auto sum = hexadecimal(comment(header, format::checksum_key));
  if (size && bytes.size() < *size) refuse(where, cut_short(bytes.size(), std::to_string(*size)));
  std::string zeroed(bytes);
  if (sum) {
    const std::size_t at = std::size_t(comment(header, format::checksum_key)->data() - bytes.data());
    zeroed.replace(at, format::digits, format::digits, '0');
  }
  if (!size || !sum || bytes.size() != *size || format::checksum(zeroed) != *sum)
    refuse(where,
           {"the solution was altered: its checksum does not fit", "解が書き換えられている: チェックサムが合わない"});
  return header;
}

Radiosity parameters_of(std::string_view header, const std::string& where) {
  Radiosity options;
  const Tree values = parse_json(comment(header, format::parameters_key).value_or("{}"), where);
  for (const Slot& slot : slots(options))
    if (const Tree* value = values.find(slot.path)) assign(slot, *value);
  return options;
}

RadiosityFigures figures_of(std::string_view header, const std::string& where) {
  RadiosityFigures out;
  const Tree values = parse_json(comment(header, format::figures_key).value_or("{}"), where);
  const auto number = [&](const char* key) {
    const Tree* value = values.find(key);
    return value && value->number() ? *value->number() : 0.0;
  };
  out.residual = number("residual"), out.error_bound = number("error_bound"), out.sweeps = number("sweeps");
  out.steps = std::size_t(std::clamp(number("steps"), 0.0, 1e15));
  return out;
}

// Goes through the elements of the file.
class SolutionBody {
 public:
  SolutionBody(std::string_view bytes, const PlyHeader& header, const std::string& where)
      : header_(header), body_(bytes, header, where) {}

  void skip_vertices() {
    const PlyElement& element = header_.elements[0];
    for (std::uint64_t i = 0; i < element.count; ++i) {
      body_.begin(element, i);
      for (const PlyProperty& p : element.properties) body_.skip(p.type);
    }
  }

  // Levels and radiosity of the elements.
  void read_faces(std::vector<int>& levels, std::vector<glm::dvec3>& radiosity) {
    const PlyElement& element = header_.elements[1];
    for (std::uint64_t i = 0; i < element.count; ++i) {
      body_.begin(element, i);
      const std::int64_t corners = body_.integer(PlyType::uint8, {"the length of a list", "リストの長さ"});
      for (std::int64_t k = 0; k < corners; ++k) body_.skip(PlyType::uint32);
      body_.skip(PlyType::uint32);  // the patch: elements stand by patch, in the order in which they were cut
      levels.push_back(int(body_.integer(PlyType::uint8, {"a level", "分割回数"})));
      radiosity.push_back(rgb());
    }
  }

  // Returns how many patches have another material now.
  std::size_t read_patches(const Patches& patches, std::vector<glm::dvec3>& radiosity) {
    std::size_t others = 0;
    for (std::uint64_t i = 0; i < header_.elements[2].count; ++i) {
      body_.begin(header_.elements[2], i);
      body_.skip(PlyType::uint32), body_.skip(PlyType::uint32), body_.skip(PlyType::float64);
      const glm::dvec3 reflectance = rgb(), emission = rgb();
      others += reflectance != patches.patches[i].reflectance || emission != patches.patches[i].emission;
      radiosity.push_back(rgb());
    }
    body_.expect_end();
    return others;
  }

 private:
  glm::dvec3 rgb() {
    glm::dvec3 v;
    for (int i = 0; i < 3; ++i) v[i] = body_.number(PlyType::float64, {"radiosity", "ラジオシティ"});
    return v;
  }

  const PlyHeader& header_;
  PlyBytes body_;
};

}  // namespace

SolutionHandle solution_of(std::string_view bytes, const std::string& where, const Scene& scene, Progress& progress) {
  const std::string_view header_text = checked_header(bytes, where);
  auto out = std::make_shared<RadiositySolution>();
  out->options = parameters_of(header_text, where);
  out->figures = figures_of(header_text, where);
  out->geometry = geometry_key(scene, out->options);
  const Text other_geometry{"the solution is of another geometry: objects were moved, changed, shown or hidden since",
                            "この解は別の形状のもの: 計算の後で物体が動いたか、変わったか、表示が切り替わった"};
  if (hexadecimal(comment(header_text, format::geometry_key)) != out->geometry) refuse(where, other_geometry);

  TextScanner in(bytes, where, {});
  const PlyHeader header = read_ply_header(in, bytes);
  const auto count = [&](std::size_t i) { return i < header.elements.size() ? header.elements[i].count : 0; };
  const std::string layout = "\n" + format::layout(count(0), count(1), count(2)) + std::string(format::end);
  if (header.elements.size() != 3 || header.format != PlyFormat::binary_little_endian || !header_text.ends_with(layout))
    refuse(where, {"its elements are not those of a solution", "要素が解のファイルのものではない"});

  // Counted first: a file's patch size is not believed to the extent of making millions of patches.
  if (count_patches(scene, out->options, progress) != count(2)) refuse(where, other_geometry);
  auto patches = std::make_shared<Patches>(make_patches(scene, out->options, progress));
  SolutionBody body(bytes, header, where);
  body.skip_vertices();
  std::vector<int> levels;
  body.read_faces(levels, out->element_radiosity);
  if (!cut_to_levels(*patches, levels, progress)) refuse(where, other_geometry);
  if (const std::size_t others = body.read_patches(*patches, out->radiosity); others > 0)
    out->notes.push_back(phrase({"{0} patches have other materials now than when this was computed: compute it again",
                                 "計算した後でパッチ{0}個の素材が変わった: もう一度計算が必要"},
                                {text_of(others)}));
  out->patches = std::move(patches);
  return out;
}

SolutionHandle read_solution(const std::filesystem::path& file, const Scene& scene, Progress& progress) {
  return solution_of(read_file(file), file.filename().string(), scene, progress);
}

}  // namespace cg
