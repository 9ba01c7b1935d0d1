#include "workbench/command_line.h"

#include <csignal>
#include <cstdlib>
#include <new>

#include "params/numbers.h"
#include "scene/shape.h"
#include "workbench/command_parser.h"
#include "workbench/environment.h"

namespace cg {

namespace {

bool has_display() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"})
    if (const char* value = std::getenv(name); value && *value) return true;
  return false;
}

// "1280x720" and a scale as typed.
void read_window_options(CommandParser& p) {
  const std::string& size = p.window_size;
  const std::size_t x = size.find('x');
  const auto number = [](const std::string& text, double least, double most) {
    const auto v = parse_number(text);
    return v && *v >= least && *v <= most ? *v : 0;
  };
  if (!size.empty()) {
    p.window.width = int(number(size.substr(0, x), 1, 16384));
    p.window.height = x == size.npos ? 0 : int(number(size.substr(x + 1), 1, 16384));
    if (p.window.width == 0 || p.window.height == 0)
      throw InputError("--size", {"\"" + size + "\" is not possible", "「" + size + "」は使えません"},
                       {"give width x height: 1280x720", "幅x高さを 1280x720 のように指定してください"});
  }
  if (!p.window_scale.empty() && (p.window.scale = number(p.window_scale, 0.25, 8)) == 0)
    throw InputError("--scale",
                     {"\"" + p.window_scale + "\" is not possible", "「" + p.window_scale + "」は使えません"},
                     {"give a number from 0.25 to 8", "0.25 から 8 の数を指定してください"});
}

int run(CommandParser& parser, std::span<const Technique> techniques, const OpenWindow& open_window,
        Language language) {
  parser.refuse_unknown();
  if (const CommandParser::Run command = parser.run()) {
    parser.refuse_window_options();
    if (parser.arguments.scene.empty()) parser.arguments.scene = parser.window.scene;
    return command(parser.arguments, techniques, language);
  }
  read_window_options(parser);
  if (has_display() && open_window) return open_window(parser.window);
  parser.arguments.scene = parser.window.scene.empty() ? std::string(shapes()[0].id) : parser.window.scene;
  return run_without_display(parser.arguments, techniques, language);
}

// CLI11's own complaints: an option without its value, or with one too many.
InputError parse_problem(const CLI::ParseError& e) {
  return InputError("shadebench", {e.what(), std::string("引数が正しくありません：") + e.what()},
                    {"see --help", "--help を見てください"});
}

int complain(const std::string& message) {
  std::fprintf(stderr, "shadebench: %s\n", message.c_str());
  return 2;
}

}  // namespace

int run_command_line(int argc, char** argv, const std::vector<Technique>& techniques, const OpenWindow& open_window,
                     const std::vector<CommandOffer>& others, const MakeDrawItems& draw_items) {
  const Language language = language_of_environment();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of that file, not the program's end
  try {
    CommandParser parser(language, techniques, others);
    parser.arguments.draw_items = parser.window.draw_items = draw_items;
    try {
      parser.parse(argc, argv);
    } catch (const CLI::Success& e) {
      return parser.exit(e);
    } catch (const CLI::ParseError& e) {
      throw parse_problem(e);
    }
    const int status = run(parser, techniques, open_window, language);
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      return complain(std::string(Words{"stdout cannot be written", "標準出力に書けません"}.in(language)));
    return status;
  } catch (const InputError& e) {
    return complain(e.message(language));
  } catch (const std::bad_alloc&) {
    return complain(std::string(Words{"not enough memory; a smaller --size or model may do",
                                      "メモリが足りません。--size かモデルを小さくしてください"}
                                    .in(language)));
  } catch (const std::exception& e) {  // a file system's, mostly: what none of ours foresaw
    return complain(e.what());
  }
}

}  // namespace cg
