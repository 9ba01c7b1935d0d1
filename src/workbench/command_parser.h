// What a person types, taken apart: the commands, their options and their help, in the language of the user.
#pragma once
#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <vector>

#include "params/input_error.h"
#include "workbench/command_line.h"
#include "workbench/commands.h"

namespace cg {

class CommandParser {
 public:
  using Run = RunCommand;

  CommandParser(Language language, std::span<const Technique> techniques, std::span<const CommandOffer> others = {});

  void parse(int argc, char** argv) { app_.parse(argc, argv); }
  // Help or version: printed, and that is all.
  int exit(const CLI::ParseError& e) { return app_.exit(e); }

  // The command that was named; null: none.
  Run run() const;
  // What no option and no argument took. Throws InputError that lists what there is.
  void refuse_unknown() const;
  // The window's own options, which no command takes.
  void refuse_window_options() const;

  Arguments arguments;
  WindowOptions window;
  std::string window_size, window_scale;  // as typed

 private:
  struct Command {
    CLI::App* app;
    Run run;
  };

  // All that is offered, each command in the order of the help: command_offers.cpp.
  void add_all();
  void add_window();
  void add_render();
  void add_compare();
  void add_probe();
  void add_plan();
  void add_export();
  void add_import();
  void add_grade();
  void add_radiosity();
  void add_unwrap();
  void add_other(const CommandOffer& offer);
  // Options of several commands.
  void add_threads(CLI::App& app);
  void add_technique(CLI::App& app);
  void add_set(CLI::App& app);
  void add_set(CLI::App& app, const char* type, Words help);

  std::string say(Words words) const { return std::string(words.in(language_)); }
  std::string options_group() const { return say({"Options", "オプション"}); }
  void set_up(CLI::App& app, const std::string& usage);
  // A command of one file, without the options of what is drawn.
  CLI::App& add_bare_command(const char* name, const char* file, Words help, Run run);
  // `words`: what the usage line shows behind the name.
  CLI::App& add_named(const char* name, const std::string& words, Words help, Run run);
  CLI::App& add_command(const char* name, Words help, Run run);
  void add_picture(CLI::App& app);
  template <class Value>
  CLI::Option* add(CLI::App& app, const char* name, Value& value, const char* type, Words help) {
    return app.add_option(name, value, say(help))->type_name(type)->group(options_group());
  }
  // A short cut for --set PATH=VALUE.
  void add_parameter(CLI::App& app, const char* name, const char* path, const char* type, Words help);
  void add_flag(CLI::App& app, const char* name, bool& value, Words help) {
    app.add_flag(name, value, say(help))->group(options_group());
  }
  std::vector<const CLI::App*> parsed_apps() const;
  InputError unknown(const CLI::App& app, const std::string& word) const;

  const Language language_;
  std::string ids_, window_group_;  // of the techniques; the heading of the window's options
  CLI::App app_;
  std::vector<Command> commands_;
};

}  // namespace cg
