#include "workbench/export_functions.h"

#include <algorithm>

namespace cg {

CFunction& CFunction::declare(const std::string& line) {
  declarations_ += "    " + line + "\n";
  return *this;
}

CFunction& CFunction::say(const std::string& line) {
  statements_ += "    " + line + "\n";
  return *this;
}

CFunction& CFunction::gap() {
  if (!statements_.empty() && !statements_.ends_with("\n\n")) statements_ += "\n";
  return *this;
}

void CFunction::say_notes(const GlCall& call) {
  for (const ListingLine& line : comments(call, language_)) say(line.text);
}

CFunction& CFunction::say(const GlCall& call) {
  say_notes(call);
  if (call.function.empty() || call.missing) return *this;
  if (!call.variable.empty()) declare(declaration(call).text);
  return say(statement(call).text);
}

CFunction& CFunction::say(const GlCall& call, std::string_view function) {
  GlCall other = call;
  other.function = function;
  return say(other);
}

std::string CFunction::text() const {
  const std::string comment = comment_.empty() ? "" : "/* " + comment_ + " */\n";
  const std::string gap = declarations_.empty() ? "" : "\n";
  return "\n" + comment + head_ + "\n{\n" + declarations_ + gap + statements_ + "}\n";
}

namespace {

Scene without_solution(Scene scene) {
  scene.radiosity_field = nullptr;
  return scene;
}

}  // namespace

CParts::CParts(const Scene& scene, Language language)
    : scene_(scene), language_(language), calls_(gl_calls(without_solution(scene))) {}

std::vector<GlCall> CParts::calls(GlSection section) const {
  std::vector<GlCall> out;
  std::copy_if(calls_.begin(), calls_.end(), std::back_inserter(out),
               [&](const GlCall& call) { return call.section == section; });
  return out;
}

std::string CParts::state_and_lights() const {
  CFunction state("void set_state( void )", {"Once, when there is a window", "ウィンドウを作ってから一度だけ呼ぶ"},
                  language_);
  for (const GlCall& call : calls(GlSection::state)) state.say(call);
  CFunction lights("void set_lights( void )",
                   {"For every picture, after the view: OpenGL multiplies positions by the matrix of that moment",
                    "描くたびに、視野変換の後で呼ぶ：光源の位置にはその時点の行列が掛かる"},
                   language_);
  for (const GlCall& call : calls(GlSection::light_model)) lights.say(call);
  int light = -1;
  for (const GlCall& call : calls(GlSection::lights)) {
    if (call.light != light) lights.gap();
    lights.say(call);
    light = call.light;
  }
  return state.text() + lights.text();
}

std::string CParts::materials() const {
  std::string out;
  const std::vector<GlCall> all = calls(GlSection::material);
  for (std::size_t i = 0; i < all.size();) {
    const int object = all[i].object;
    CFunction function("void " + material_function(object) + "( void )", {}, language_);
    for (; i < all.size() && all[i].object == object; ++i) function.say(all[i]);
    if (const std::string text = function.text(); out.find(text) == out.npos) out += text;
  }
  return out;
}

std::vector<int> CParts::drawn() const {
  std::vector<int> objects;
  for (const GlCall& call : calls(GlSection::draw)) objects.push_back(call.object);
  return objects;
}

bool CParts::lights_come_first() const {
  const auto is = [](GlSection section) { return [section](const GlCall& call) { return call.section == section; }; };
  const auto lights = std::find_if(calls_.begin(), calls_.end(), is(GlSection::lights));
  const auto look_at =
      std::find_if(calls_.begin(), calls_.end(), [](const GlCall& call) { return call.function == "gluLookAt"; });
  return lights < look_at;
}

std::string CParts::prototypes() const {
  for (const GlCall& call : calls_)
    if (call.function == "glClampColor")
      return "#define GL_GLEXT_PROTOTYPES /* " +
             std::string(Words{"glClampColor is of OpenGL 3.0", "glClampColor は OpenGL 3.0 の関数"}.in(language_)) +
             " */\n";
  return "";
}

std::string CParts::left_out_comments() const {
  const auto comment = [&](bool wanted, const Words& text) {
    return wanted ? "/* " + std::string(text.in(language_)) + " */\n" : "";
  };
  return comment(scene_.shading.ambient_source == AmbientSource::radiosity,
                 {"The scene's ambient term is a radiosity solution; here it is the constant I_a k_a.",
                  "シーンの環境光項はラジオシティの解だが、ここでは一定の I_a k_a になる。"}) +
         comment(scene_.display.transform == DisplayTransform::photographic,
                 {"The scene is displayed as sRGB with an exposure; here a colour is shown as it is computed.",
                  "シーンは露出と sRGB で表示されるが、ここでは計算した色をそのまま表示する。"});
}

std::string in_comment(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\')
      out += '_';
    else if (!out.empty() && ((out.back() == '*' && c == '/') || (out.back() == '/' && c == '*')))
      out += '_';
    else
      out += c;
  }
  return out;
}

std::string in_string(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {  // three octal digits always: a digit may follow
      out += {'\\', char('0' + byte / 64), char('0' + byte / 8 % 8), char('0' + byte % 8)};
    } else {
      if (c == '"' || c == '\\' || c == '?') out += '\\';  // "??/" would be a backslash
      out += c;
    }
  }
  return out;
}

}  // namespace cg
