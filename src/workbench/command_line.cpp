#include "workbench/command_line.h"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdlib>
#include <new>

#include "params/input_error.h"
#include "params/numbers.h"
#include "scene/shape.h"
#include "workbench/commands.h"
#include "workbench/environment.h"
#include "workbench/export_command.h"
#include "workbench/import_command.h"
#include "workbench/lesson_check.h"

namespace cg {

namespace {

using Run = int (*)(const Arguments&, std::span<const Technique>, Language);

struct Command {
  CLI::App* app;
  Run run;
};

// Help with a usage line of our own: CLI11's would be half English.
class Help : public CLI::Formatter {
 public:
  explicit Help(std::string usage) : usage_(std::move(usage)) {}
  std::string make_usage(const CLI::App*, std::string) const override { return usage_ + "\n"; }

 private:
  std::string usage_;
};

// What was typed, and the parser that fills it in.
class Parser {
 public:
  Parser(Language language, std::span<const Technique> techniques) : language_(language) {
    for (const Technique& technique : techniques) ids_ += (ids_.empty() ? "" : ", ") + technique.id;
    app_.name("shadebench");
    app_.description(say({"A teaching workbench for shading: one scene drawn by OpenGL beside a software reference.",
                          "シェーディングの教材：同じシーンを OpenGL とソフトウェアで並べて描き、差を見せる。"}));
    app_.footer(say({"SCENE is a model file (obj, ply, off, stl), a preset (json), a lesson's step (03-shading:2), or "
                     "a shape: ",
                     "SCENE "
                     "はモデルのファイル（obj、ply、off、stl）、プリセット（json）、レッスンのステップ（03-shading:"
                     "2）、または形："}) +
                shape_ids());
    app_.set_version_flag("--version", "shadebench " SHADEBENCH_VERSION, say({"Show the version", "版を表示する"}));
    app_.require_subcommand(0, 1);
    const std::string options = say({" [OPTIONS]", " [オプション]"});
    set_up(app_, "shadebench [SCENE]" + options + "\n" + say({"       ", "        "}) + "shadebench " +
                     say({"COMMAND SCENE", "コマンド SCENE"}) + options);
    add_window();
    add_render();
    add_compare();
    add_probe();
    add_plan();
    add_export();
    add_import();
    add_lessons();
  }

  void parse(int argc, char** argv) { app_.parse(argc, argv); }
  // Help or version: printed, and that is all.
  int exit(const CLI::ParseError& e) { return app_.exit(e); }

  // The command that was named; null: none.
  Run run() const {
    for (const Command& command : commands_)
      if (command.app->parsed()) return command.run;
    return nullptr;
  }

  // What no option and no argument took. Throws InputError that lists what there is.
  void refuse_unknown() const {
    for (const CLI::App* app : parsed_apps())
      for (const std::string& word : app->remaining()) throw unknown(*app, word);
  }

  // The window's own options, which no command takes.
  void refuse_window_options() const {
    for (const CLI::Option* option : app_.get_options())
      if (option->count() > 0 && option->get_group() == window_group_)
        throw InputError(option->get_name(),
                         {"only the window has this option here", "ここではウィンドウだけの指定です"},
                         {"write it behind the command", "コマンドの後ろに書いてください"});
  }

  Arguments arguments;
  WindowOptions window;
  std::string window_size, window_scale;

 private:
  std::string say(Words words) const { return std::string(words.in(language_)); }

  static std::string shape_ids() {
    std::string ids;
    for (const Shape& shape : shapes()) ids += (ids.empty() ? "" : ", ") + std::string(shape.id);
    return ids;
  }

  void set_up(CLI::App& app, const std::string& usage) {
    app.allow_extras();
    app.set_help_flag("-h,--help", say({"Show this help", "この説明を表示する"}));
    auto help = std::make_shared<Help>(say({"Usage: ", "使い方："}) + usage);
    help->column_width(34);
    app.formatter(help);
    for (CLI::Option* option : app.get_options()) option->group(options_group());
  }
  std::string options_group() const { return say({"Options", "オプション"}); }

  template <class Value>
  CLI::Option* add(CLI::App& app, const char* name, Value& value, const char* type, Words help) {
    return app.add_option(name, value, say(help))->type_name(type)->group(options_group());
  }
  void add_flag(CLI::App& app, const char* name, bool& value, Words help) {
    app.add_flag(name, value, say(help))->group(options_group());
  }

  // A command of one file, without the options of what is drawn.
  CLI::App& add_bare_command(const char* name, const char* file, Words help, Run run) {
    CLI::App* app = app_.add_subcommand(name, say(help));
    app->group(say({"Commands", "コマンド"}));
    set_up(*app, "shadebench " + std::string(name) + " " + file + say({" [OPTIONS]", " [オプション]"}));
    app->add_option(file, arguments.scene)->type_name("")->group("");
    commands_.push_back({app, run});
    return *app;
  }

  CLI::App& add_command(const char* name, Words help, Run run) {
    CLI::App& app = add_bare_command(name, "SCENE", help, run);
    add_set(app);
    add(app, "--size", arguments.size, "WxH", {"The picture's size, 512x512", "画像の大きさ。既定は 512x512"});
    return app;
  }

  void add_set(CLI::App& app) {
    add(app, "--set", arguments.set, "PATH=VALUE",
        {"Set a parameter: material.k_d=0.5", "値を変える：material.k_d=0.5"})
        ->allow_extra_args(false);
  }

  void add_window() {
    app_.add_option("SCENE", window.scene, say({"Opened in the window", "ウィンドウで開くもの"}))
        ->type_name("")
        ->group("");
    window_group_ = say({"Options of the window", "ウィンドウのオプション"});
    const auto in_group = [&](CLI::Option* option) { return option->group(window_group_); };
    in_group(add(app_, "--size", window_size, "WxH", {"The window's size in pixels", "ウィンドウの大きさ（画素）"}));
    in_group(
        add(app_, "--scale", window_scale, "S", {"The size of all type, 1 is usual", "文字などの拡大率。標準は 1"}));
    in_group(add(app_, "--set", window.set, "NAME=VALUE",
                 {"Set a setting of the window: language=ja", "ウィンドウの設定を変える：language=ja"}))
        ->allow_extra_args(false);
    in_group(add(app_, "--screenshot", window.screenshot, "FILE",
                 {"Save a picture of the window, then close it", "ウィンドウの画像を保存して閉じる"}));
    in_group(app_.add_flag_callback(
        "--no-session", [this] { window.keep_session = false; },
        say({"Neither restore nor save the session", "前回の状態を使わず、保存もしない"})));
    in_group(app_.add_flag("--times", window.times,
                           say({"Print what the start and the frames take", "起動と描画の時間を表示する"})));
    add(app_, "--measure-window", window.measure, "SECONDS",
        {"Drag a slider by script and print how far the pictures are behind",
         "スライダを自動で動かし、画像の遅れを表示する"})
        ->group("");  // for who works on the program
  }

  void add_threads(CLI::App& app) {
    add(app, "--threads", arguments.threads, "N",
        {"Threads of the software reference; the picture is the same", "ソフトウェアのスレッド数。結果は変わらない"});
  }

  void add_render() {
    CLI::App& app = add_command("render", {"Draw a scene into a file", "シーンを画像ファイルに描く"}, run_render);
    add(app, "-o,--output", arguments.output, "FILE", {"png, jpg, exr or hdr", "png、jpg、exr、hdr のどれか"});
    add_technique(app);
    add_threads(app);
  }

  void add_compare() {
    CLI::App& app =
        add_command("compare", {"Compare two techniques in numbers", "二つの手法の差を数値で示す"}, run_compare);
    add(app, "--left", arguments.left, "T",
        {"A technique; gl-fixed, or gl where that cannot draw the scene", "手法。既定は gl-fixed、描けないときは gl"});
    add(app, "--right", arguments.right, "T", {"A technique; software", "手法。既定は software"});
    add(app, "-o,--output", arguments.output, "FILE", {"The difference as a picture", "差の画像"});
    add(app, "--gain", arguments.gain, "G",
        {"The difference in a png or jpg is multiplied by this, 32", "png、jpg に書く差の倍率。既定は 32"});
    add(app, "--max-error", arguments.max_error, "E",
        {"Exit with 1 where the largest error is over E: 2/255", "最大誤差が E を超えたら終了状態を 1 にする：2/255"});
    add_flag(app, "--json", arguments.json, {"One JSON object on stdout", "JSON で出力する"});
    add_threads(app);
  }

  void add_probe() {
    CLI::App& app = add_command(
        "probe", {"What the colour of one pixel is made of", "一つの画素の色を、式の各項の数値で示す"}, run_probe);
    add(app, "--pixel", arguments.pixel, "X,Y", {"The pixel; 0,0 is the top-left one", "画素。左上が 0,0"});
    add_technique(app);
    add_flag(app, "--json", arguments.json, {"One JSON object on stdout", "JSON で出力する"});
    add_threads(app);
  }

  void add_plan() {
    CLI::App& app = add_command(
        "plan",
        {"What a technique runs for a scene, and what it leaves out", "手法が行う処理と、省く処理とその理由を示す"},
        run_plan);
    add_technique(app);
    add_flag(app, "--json", arguments.json, {"One JSON object on stdout", "JSON で出力する"});
  }

  void add_export() {
    CLI::App& app = add_bare_command("export", "SCENE",
                                     {"Write a scene as a preset, C, a GLUT program or OBJ",
                                      "シーンをプリセット、C、GLUT プログラム、OBJ に書き出す"},
                                     run_export);
    add_set(app);
    add(app, "--as", arguments.format, "FORMAT",
        {"json, c, glut or obj; else by FILE's ending", "json、c、glut、obj のどれか。省くと FILE の末尾で決める"});
    add(app, "-o,--output", arguments.output, "FILE",
        {"The file; of a GLUT program .c, its meshes beside it", "書き出すファイル。glut では .c、メッシュは隣に置く"});
  }

  void add_import() {
    CLI::App& app = add_bare_command(
        "import", "FILE.c",
        {"Read the C of a student's program into a preset", "学生の C プログラムを読み、プリセットにする"}, run_import);
    add(app, "-o,--output", arguments.output, "FILE", {"The preset, json", "プリセット（json）"});
  }

  void add_lessons() {
    CLI::App& app =
        add_bare_command("lessons", "LESSON", {"List the lessons, or check them", "レッスンの一覧と検査"}, run_lessons);
    add_flag(app, "--check", arguments.check,
             {"Compute every number and task; exit with 1 where one is off",
              "数と課題をすべて計算し、合わなければ終了状態を 1 にする"});
    add_flag(app, "--json", arguments.json, {"One JSON object on stdout", "JSON で出力する"});
  }

  void add_technique(CLI::App& app) {
    add(app, "--technique", arguments.technique, "T", {"How it is drawn; software", "描く手法。既定は software"})
        ->description(say({"How it is drawn: ", "描く手法："}) + ids_);
  }

  std::vector<const CLI::App*> parsed_apps() const {
    std::vector<const CLI::App*> apps;
    for (const Command& command : commands_)
      if (command.app->parsed()) apps.push_back(command.app);
    apps.push_back(&app_);
    return apps;
  }

  InputError unknown(const CLI::App& app, const std::string& word) const {
    std::string known;
    const auto list = [&](const std::string& name) { known += (known.empty() ? "" : ", ") + name; };
    if (word.starts_with("-")) {
      for (const CLI::Option* option : app.get_options())
        if (!option->get_positional()) list(option->get_name());
      return InputError(word, {"there is no such option", "そのようなオプションはありません"},
                        {"known are: " + known, "あるのは " + known + " です"});
    }
    for (const Command& command : commands_) list(command.app->get_name());
    return InputError(
        word, {"one word too many", "余分な引数です"},
        {"the commands are: " + known + "; one scene each", "コマンドは " + known + "、シーンは一つです"});
  }

  const Language language_;
  std::string ids_, window_group_;
  CLI::App app_;
  std::vector<Command> commands_;
};

bool has_display() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"})
    if (const char* value = std::getenv(name); value && *value) return true;
  return false;
}

// "1280x720" and a scale as typed.
void read_window_options(Parser& p) {
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

int run(Parser& parser, std::span<const Technique> techniques, const OpenWindow& open_window, Language language) {
  parser.refuse_unknown();
  if (const Run command = parser.run()) {
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

int run_command_line(int argc, char** argv, const std::vector<Technique>& techniques, const OpenWindow& open_window) {
  const Language language = language_of_environment();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of that file, not the program's end
  try {
    Parser parser(language, techniques);
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
