#include "workbench/import.h"

#include <algorithm>
#include <cctype>

#include "params/file.h"
#include "params/input_error.h"
#include "scene/text_scanner.h"
#include "workbench/import_comment.h"
#include "workbench/import_scene.h"
#include "workbench/model_library.h"

namespace cg {

namespace {

// The comment at the head of exported functions says how a program calls them: as statements.
class Usage {
 public:
  explicit Usage(const std::vector<CComment>& comments) {
    for (const CComment& comment : comments)
      if (comment.text.find("Shadebench") != comment.text.npos && comment.text.find("display()") != comment.text.npos) {
        write(comment.text);
        Complaints unheard;
        tokens_ = c_tokens(code_, unheard);
        program_ = parse_c(tokens_, unheard);
        return;
      }
  }
  Usage(const Usage&) = delete;
  Usage& operator=(const Usage&) = delete;
  // Null where there is none.
  const CRoutine* routine() const { return program_.routines.empty() ? nullptr : &program_.routines[0]; }

 private:
  void write(std::string_view text) {
    code_ = "void usage(void) {\n";
    for (std::size_t at = text.find('\n'); at != text.npos;) {
      const std::size_t end = text.find('\n', at + 1);
      std::string_view line = text.substr(at + 1, end == text.npos ? end : end - at - 1);
      line.remove_prefix(std::min(line.find_first_not_of(" *\t\r"), line.size()));
      code_ += line.starts_with("...") ? "glCallList(1);\n" : std::string(line) + "\n";
      at = end;
    }
    code_ += "}\n";
  }

  std::string code_;
  CTokens tokens_;
  CProgram program_;
};

// A trial: functions are answered as in earnest, and nothing comes of it.
class Rehearsal : public CHost {
 public:
  explicit Rehearsal(GlMachine machine) : machine_(std::move(machine)) {}
  std::optional<CValue> constant(std::string_view name) override { return machine_.constant(name); }
  CValue call(CRun& run, std::string_view function, const std::vector<CValue>& arguments, long line) override {
    return machine_.call(run, function, arguments, line);
  }
  bool plays(CRun& run, const CRoutine& routine, const std::vector<CValue>& arguments, long line) override {
    return machine_.plays(run, routine, arguments, line);
  }
  bool only_reads(std::string_view function) const override { return machine_.only_reads(function); }

 private:
  GlMachine machine_;
};

class Importer {
 public:
  Importer(const CProgram& program, const Usage& usage, Complaints& complaints)
      : program_(program), usage_(usage), complaints_(complaints), run_(program, machine_, complaints) {
    machine_.state.own.used = has_own_matrices(program);
  }

  bool is_whole() const { return run_.function("main") != nullptr; }

  Scene run() {
    run_.top();
    const CRoutine* main = run_.function("main");
    if (main) {
      run_.call(*main, {c_integer(1)}, main->line);
      run_.go_on();
      pictures();
    } else {
      parts();
    }
    return scene_of_state(machine_.state, main != nullptr, complaints_);
  }

  const GlState& state() const { return machine_.state; }

 private:
  const CRoutine* callback(std::string_view function) const {
    const auto at = machine_.state.callbacks.find(function);
    return at == machine_.state.callbacks.end() ? nullptr : run_.function(at->second);
  }

  // The first picture after glutMainLoop.
  void pictures() {
    const CRoutine *reshape = callback("glutReshapeFunc"), *display = callback("glutDisplayFunc");
    for (const auto& [function, name] : machine_.state.callbacks)
      if (function != "glutReshapeFunc" && function != "glutDisplayFunc")
        if (const CRoutine* routine = run_.function(name)) changes_in(*routine);
    show(reshape, display);
  }

  void show(const CRoutine* reshape, const CRoutine* display) {
    const std::vector<CValue> size{c_integer(machine_.state.width), c_integer(machine_.state.height)};
    if (reshape) call(*reshape, size);
    if (!display) return;
    changes_between_pictures(*display);
    call(*display, {});
  }

  void call(const CRoutine& routine, const std::vector<CValue>& arguments) {
    run_.call(routine, arguments, routine.line);
    run_.go_on();
  }

  static Text changes(std::string_view name) {
    return phrase({"{0} changes while the program runs", "{0}は実行中に変わる"}, {in_quotes(name)});
  }

  // What keys, the mouse and the clock change.
  void changes_in(const CRoutine& routine) {
    for (const std::string_view name : effects_of(routine, program_, machine_).assigned)
      if (const int variable = run_.memory.find_global(name); variable >= 0)
        run_.memory.change_later(variable, changes(name));
  }

  // What display() itself changes: two pictures are tried, and what differs after them changes.
  void changes_between_pictures(const CRoutine& display) {
    Complaints unheard;
    Rehearsal host(machine_);
    CRun trial = run_.trial(host, unheard);
    std::vector<std::vector<CValue>> after[2];
    for (auto& cells : after) {
      trial.call(display, {}, display.line);
      trial.go_on();
      for (int i = 0; i < trial.memory.size(); ++i) cells.push_back(trial.memory.variable(i).cells);
    }
    const auto changed = [&](int i) {
      const auto &a = after[0][std::size_t(i)], &b = after[1][std::size_t(i)];
      return !std::equal(a.begin(), a.end(), b.begin(), b.end(), alike);
    };
    const int before = run_.memory.size();
    for (int i = 0; i < before; ++i)
      if (changed(i)) run_.memory.change_later(i, changes(run_.memory.variable(i).name));
    for (const auto& [declaration, i] : trial.statics())
      if (i >= before && i < int(after[0].size()) && changed(i))
        run_.change_later(*declaration, changes(declaration->name));
  }

  static bool alike(const CValue& a, const CValue& b) {
    return a.state == b.state && a.number == b.number && a.address.variable == b.address.variable &&
           a.address.offset == b.address.offset;
  }

  // ---- a part of a program ----

  static void calls(const CExpression& e, std::set<std::string_view>& names) {
    if (e.kind == CExpression::call) names.insert(e.operands[0].name);
    for (const CExpression& o : e.operands) calls(o, names);
  }
  static void calls(const CStatement& s, std::set<std::string_view>& names) {
    for (const CExpression& e : s.expressions) calls(e, names);
    for (const CDeclaration& d : s.declarations)
      for (const CExpression& e : d.initial) calls(e, names);
    for (const CStatement& b : s.body) calls(b, names);
  }

  // Which functions run first: by the names that a course gives them, then the camera. Those for keys, the mouse and
  // the clock do not run.
  enum Rank { init, reshape, view, other, display, event };
  static Rank rank(const CRoutine& f) {
    std::string name(f.name);
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    const auto named = [&](std::initializer_list<std::string_view> words) {
      return std::any_of(words.begin(), words.end(), [&](auto word) { return name.find(word) != name.npos; });
    };
    if (named({"idle", "timer", "key", "mouse", "motion", "special", "menu", "animate", "update"})) return event;
    if (named({"init"})) return init;
    if (named({"reshape", "resize"})) return reshape;
    if (named({"display", "draw", "render"})) return display;
    std::set<std::string_view> names;
    calls(f.body, names);
    return names.contains("gluLookAt") ? view : other;
  }

  void parts() {
    std::set<std::string_view> called;
    for (const CRoutine& f : program_.routines) calls(f.body, called);
    if (usage_.routine()) calls(usage_.routine()->body, called);
    std::vector<std::pair<Rank, const CRoutine*>> roots;
    for (const CRoutine& f : program_.routines)
      if (!called.contains(f.name)) roots.emplace_back(rank(f), &f);
    std::stable_sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::vector<CValue> size{c_integer(machine_.state.width), c_integer(machine_.state.height)};
    for (const auto& [rank, f] : roots)
      if (rank == event) changes_in(*f);
    for (const auto& [rank, f] : roots) {
      if (rank == event) continue;
      if (rank == display) changes_between_pictures(*f);
      call(*f, rank == reshape ? size : std::vector<CValue>{});
    }
    if (usage_.routine()) call(*usage_.routine(), {});
  }

  const CProgram& program_;
  const Usage& usage_;
  Complaints& complaints_;
  GlMachine machine_;
  CRun run_;
};

}  // namespace

namespace {

// What `text` says in its calls and its comment; objects of the program's own meshes have no model yet.
struct Reading {
  Scene by_calls, scene;
  std::vector<long> lines;  // where each object is drawn; 0: nowhere
  bool whole = false;
};

Reading read(std::string_view text, const std::string& where, Complaints& complaints) {
  if (text.size() > largest_c_file)
    throw InputError(where, {"the file is larger than 256 KiB", "ファイルが 256 KiB より大きい"},
                     {"a program of a course is read", "授業で書く程度のプログラムなら読める"});
  const CTokens tokens = c_tokens(text, complaints);
  const CProgram program = parse_c(tokens, complaints);
  const Usage usage(tokens.comments);
  Importer importer(program, usage, complaints);
  Reading reading;
  reading.by_calls = importer.run();
  if (!importer.state().any_call)
    throw InputError(where, {"no call of OpenGL was found", "OpenGL の呼び出しが見つからない"},
                     {"name a C program that calls glLightfv, glMaterialfv and the like",
                      "glLightfv や glMaterialfv などを呼ぶ C のプログラムを指定すること"});
  for (const GlDraw& draw : importer.state().drawn) reading.lines.push_back(draw.line);
  reading.whole = importer.is_whole();
  reading.scene = reading.by_calls;
  apply_comment(reading.scene, tokens.comments, complaints);
  return reading;
}

std::string name_of(const Object& object) { return std::filesystem::path(object.model).stem().string(); }

// A model for what has none: a mesh of the program's own, or nothing that is drawn at all.
void give_models(Reading& reading, Complaints& complaints) {
  for (std::size_t i = 0; i < reading.scene.objects.size(); ++i) {
    Object& object = reading.scene.objects[i];
    if (object.model.empty()) {
      object.model = "teapot";
      if (i < reading.lines.size())
        complaints.add(reading.lines[i], {"the program draws a mesh of its own: a teapot stands in its place",
                                          "プログラム独自の形を描いている：代わりにティーポットを置く"});
      else if (reading.whole)
        complaints.add(0, {"nothing that is drawn was found: a teapot stands in its place",
                           "描かれる形が見つからない：代わりにティーポットを置く"});
    }
    if (object.name.empty()) object.name = name_of(object);
  }
}

}  // namespace

ImportReport import_c(std::string_view text, const std::string& where) {
  Complaints complaints;
  Reading reading = read(text, where, complaints);
  give_models(reading, complaints);
  return {std::move(reading.scene), complaints.take()};
}

std::string import_comment(const Scene& scene, std::string_view text) {
  if (text.size() > largest_c_file) return "";  // it could not be read back
  Complaints unheard;
  Scene before = read(text, "", unheard).by_calls;
  // A name that follows from the model's need not be said.
  for (std::size_t i = 0; i < std::min(before.objects.size(), scene.objects.size()); ++i)
    if (const Object& o = scene.objects[i]; before.objects[i].name.empty() && o.name == name_of(o))
      before.objects[i].name = o.name;
  return comment_between(before, scene);
}

ImportReport import_file(const std::filesystem::path& file) {
  ImportReport report = import_c(read_file(file, largest_c_file), file.string());
  for (Object& object : report.scene.objects) try {
      object.model = find_model(object.model, file.parent_path());
    } catch (const InputError& e) {
      report.complaints.push_back({0, {e.message(Language::english), e.message(Language::japanese)}});
      object.model = "teapot", object.part.clear();
    }
  return report;
}

}  // namespace cg
