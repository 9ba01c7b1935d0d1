#include "workbench/command_parser.h"

#include "scene/shape.h"

namespace cg {

namespace {

// Help with a usage line of our own: CLI11's would be half English.
class Help : public CLI::Formatter {
 public:
  explicit Help(std::string usage) : usage_(std::move(usage)) {}
  std::string make_usage(const CLI::App*, std::string) const override { return usage_ + "\n"; }

 private:
  std::string usage_;
};

std::string shape_ids() {
  std::string ids;
  for (const Shape& shape : shapes()) ids += (ids.empty() ? "" : ", ") + std::string(shape.id);
  return ids;
}

}  // namespace

CommandParser::CommandParser(Language language, std::span<const Technique> techniques,
                             std::span<const CommandOffer> others)
    : language_(language) {
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
  add_all();
  for (const CommandOffer& offer : others) add_other(offer);
}

CommandParser::Run CommandParser::run() const {
  for (const Command& command : commands_)
    if (command.app->parsed()) return command.run;
  return nullptr;
}

void CommandParser::refuse_unknown() const {
  for (const CLI::App* app : parsed_apps())
    for (const std::string& word : app->remaining()) throw unknown(*app, word);
}

void CommandParser::refuse_window_options() const {
  for (const CLI::Option* option : app_.get_options())
    if (option->count() > 0 && option->get_group() == window_group_)
      throw InputError(option->get_name(), {"only the window has this option here", "ここではウィンドウだけの指定です"},
                       {"write it behind the command", "コマンドの後ろに書いてください"});
}

void CommandParser::set_up(CLI::App& app, const std::string& usage) {
  app.allow_extras();
  app.set_help_flag("-h,--help", say({"Show this help", "この説明を表示する"}));
  auto help = std::make_shared<Help>(say({"Usage: ", "使い方："}) + usage);
  help->column_width(34);
  app.formatter(help);
  for (CLI::Option* option : app.get_options()) option->group(options_group());
}

CLI::App& CommandParser::add_named(const char* name, const std::string& words, Words help, Run run) {
  CLI::App* app = app_.add_subcommand(name, say(help));
  app->group(say({"Commands", "コマンド"}));
  set_up(*app, "shadebench " + std::string(name) + words + say({" [OPTIONS]", " [オプション]"}));
  commands_.push_back({app, run});
  return *app;
}

CLI::App& CommandParser::add_bare_command(const char* name, const char* file, Words help, Run run) {
  CLI::App& app = add_named(name, " " + std::string(file), help, run);
  app.add_option(file, arguments.scene)->type_name("")->group("");
  return app;
}

CLI::App& CommandParser::add_command(const char* name, Words help, Run run) {
  CLI::App& app = add_bare_command(name, "SCENE", help, run);
  add_picture(app);
  return app;
}

void CommandParser::add_picture(CLI::App& app) {
  add_set(app);
  add(app, "--size", arguments.size, "WxH", {"The picture's size, 512x512", "画像の大きさ。既定は 512x512"});
}

std::vector<const CLI::App*> CommandParser::parsed_apps() const {
  std::vector<const CLI::App*> apps;
  for (const Command& command : commands_)
    if (command.app->parsed()) apps.push_back(command.app);
  apps.push_back(&app_);
  return apps;
}

InputError CommandParser::unknown(const CLI::App& app, const std::string& word) const {
  std::string known;
  const auto list = [&](const std::string& name) { known += (known.empty() ? "" : ", ") + name; };
  if (word.starts_with("-")) {
    for (const CLI::Option* option : app.get_options())
      if (!option->get_positional()) list(option->get_name());
    return InputError(word, {"there is no such option", "そのようなオプションはありません"},
                      {"known are: " + known, "あるのは " + known + " です"});
  }
  for (const Command& command : commands_) list(command.app->get_name());
  return InputError(word, {"one word too many", "余分な引数です"},
                    {"the commands are: " + known + "; one scene each", "コマンドは " + known + "、シーンは一つです"});
}

}  // namespace cg
