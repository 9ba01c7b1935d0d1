// Source: Greg Turk, "The PLY Polygon File Format", 1994.
#include "scene/ply_header.h"

#include <algorithm>
#include <array>

namespace cg {

namespace {

struct TypeName {
  std::string_view name, other;  // Turk's name and the one with the size in it
  std::size_t bytes;
};
constexpr std::array<TypeName, 8> types{{{"char", "int8", 1},
                                         {"uchar", "uint8", 1},
                                         {"short", "int16", 2},
                                         {"ushort", "uint16", 2},
                                         {"int", "int32", 4},
                                         {"uint", "uint32", 4},
                                         {"float", "float32", 4},
                                         {"double", "float64", 8}}};
constexpr std::size_t max_elements = 64, max_properties = 1024;

PlyType read_type(TextScanner& in) {
  const std::string_view word = in.word();
  for (std::size_t i = 0; i < types.size(); ++i)
    if (word == types[i].name || word == types[i].other) return PlyType(i);
  const Text accepted{"char, uchar, short, ushort, int, uint, float or double is expected",
                      "型は char, uchar, short, ushort, int, uint, float, double のどれか"};
  if (word.empty()) in.fail({"a property without a type", "型のないプロパティ"}, accepted);
  in.fail(phrase({"{0} is not a type of PLY", "{0}は PLY の型ではない"}, {in_quotes(word)}), accepted);
}

PlyFormat read_format(TextScanner& in) {
  std::string_view word = "comment";
  while (word == "comment" || word == "obj_info") word = in.next_line() ? in.word() : "";
  const Text accepted{"'format ascii 1.0', 'format binary_little_endian 1.0' or 'format binary_big_endian 1.0'",
                      "format ascii 1.0 か format binary_little_endian 1.0 か format binary_big_endian 1.0"};
  if (word != "format") in.fail({"the format is missing behind 'ply'", "ply の次に format がない"}, accepted);
  const std::string_view name = in.word(), version = in.word();
  constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian", "binary_big_endian"};
  const auto found = std::ranges::find(names, name);
  if (found == names.end() || version != "1.0")
    in.fail(phrase({"the format {0} is not known", "形式{0}は知らない"},
                   {in_quotes(std::string(name) + " " + std::string(version))}),
            accepted);
  in.expect_end(accepted);
  return PlyFormat(found - names.begin());
}

PlyElement read_element(TextScanner& in, const std::vector<PlyElement>& others) {
  PlyElement element{std::string(in.word()), 0, {}, in.line()};
  const Text accepted{"'element NAME COUNT' is expected, such as 'element vertex 8'",
                      "element vertex 8 のように名前と個数を書く"};
  if (element.name.empty()) in.fail({"an element without a name", "名前のない element"}, accepted);
  const std::int64_t count = in.integer({"the count of an element", "要素の個数"});
  if (count < 0)
    in.fail(phrase({"the count {0} of {1}", "{1}の個数が{0}"}, {text_of(count), in_quotes(element.name)}),
            {"a count is 0 or more", "個数は 0 以上"});
  in.expect_end(accepted);
  if (std::ranges::find(others, element.name, &PlyElement::name) != others.end())
    in.fail(phrase({"the element {0} is there twice", "要素{0}が 2 つある"}, {in_quotes(element.name)}));
  if (others.size() == max_elements) in.fail({"more than 64 elements", "要素の種類が 64 を超えている"});
  element.count = std::uint64_t(count);
  return element;
}

PlyProperty read_property(TextScanner& in, const PlyElement& element) {
  PlyProperty property{};
  if (in.peek() == "list") {
    in.word();
    property.count_type = read_type(in);
    if (!is_integer(*property.count_type))
      in.fail({"a list whose length is not of an integer type", "リストの長さが整数の型でない"},
              {"uchar, int and the other integer types are accepted", "uchar や int などの整数型なら読める"});
  }
  property.type = read_type(in);
  property.name = in.word();
  const Text accepted{"'property TYPE NAME' or 'property list TYPE TYPE NAME' is expected",
                      "property 型 名前、または property list 型 型 名前 と書く"};
  if (property.name.empty()) in.fail({"a property without a name", "名前のないプロパティ"}, accepted);
  in.expect_end(accepted);
  if (element.find(property.name))
    in.fail(phrase({"the property {0} is there twice", "プロパティ{0}が 2 つある"}, {in_quotes(property.name)}));
  if (element.properties.size() == max_properties)
    in.fail({"more than 1024 properties", "プロパティが 1024 個を超えている"});
  return property;
}

// Behind end_header comes the line end that the first line has; in a binary body any byte may follow it.
std::size_t body_offset(std::string_view bytes, std::size_t first_line_end, std::size_t line_end) {
  const auto at = [&](std::size_t i) { return i < bytes.size() ? bytes[i] : '\0'; };
  const bool cr_only = at(first_line_end) == '\r' && at(first_line_end + 1) != '\n';
  if (at(line_end) == '\r' && !cr_only) ++line_end;
  return std::min(line_end + 1, bytes.size());
}

// No count is believed that the file has no bytes for.
void check_counts(const PlyHeader& header, std::string_view bytes, const std::string& where) {
  std::uint64_t left = bytes.size() - header.body + 1;  // the last line may lack its line end
  for (const PlyElement& element : header.elements) {
    const std::uint64_t least = element.least_bytes(header.format);
    if (least == 0) continue;
    if (element.count > left / least)
      throw InputError(where,
                       phrase({"{0} {1} are announced, but the file has only {2} bytes for them",
                               "{1}が{0}個あるとされているが、残りは {2} バイトしかない"},
                              {text_of(element.count), in_quotes(element.name), text_of(left - 1)}),
                       {"the file may be cut off: get it again", "ファイルが途中で切れている可能性がある"},
                       element.line);
    left -= element.count * least;
  }
}

}  // namespace

std::size_t size_of(PlyType type) { return types[std::size_t(type)].bytes; }

const PlyProperty* PlyElement::find(std::string_view property) const {
  const auto found = std::ranges::find(properties, property, &PlyProperty::name);
  return found == properties.end() ? nullptr : &*found;
}

std::uint64_t PlyElement::least_bytes(PlyFormat format) const {
  std::uint64_t sum = 0;
  for (const PlyProperty& p : properties)  // as text, a digit and a space each
    sum += format == PlyFormat::ascii ? 2 : size_of(p.count_type.value_or(p.type));
  return sum;
}

PlyHeader read_ply_header(TextScanner& in, std::string_view bytes) {
  if (!in.next_line() || in.rest() != "ply")
    in.fail({"the file does not begin with 'ply'", "ファイルが ply で始まっていない"},
            {"a PLY file does", "PLY ファイルなら始まる"});
  const std::size_t first_line_end = in.line_end();
  PlyHeader header{read_format(in), {}, 0};
  while (in.next_line()) {
    const std::string_view key = in.word();
    if (key == "end_header") {
      in.expect_end({"end_header stands alone", "end_header は単独で書く"});
      header.body = body_offset(bytes, first_line_end, in.line_end());
      check_counts(header, bytes, in.where());
      return header;
    }
    if (key == "comment" || key == "obj_info") continue;
    if (key == "element") {
      header.elements.push_back(read_element(in, header.elements));
    } else if (key == "property") {
      if (header.elements.empty())
        in.fail({"a property before any element", "element より前に property がある"},
                {"'element vertex 8' comes first", "先に element vertex 8 などを書く"});
      header.elements.back().properties.push_back(read_property(in, header.elements.back()));
    } else {
      in.fail(phrase({"{0} is not a word of a PLY header", "{0}は PLY のヘッダーの語ではない"}, {in_quotes(key)}),
              {"element, property, comment, obj_info or end_header is expected",
               "書けるのは element, property, comment, obj_info, end_header"});
    }
  }
  in.fail({"the header ends without end_header", "end_header がないままヘッダーが終わっている"},
          {"the file may be cut off: get it again", "ファイルが途中で切れている可能性がある"});
}

}  // namespace cg
