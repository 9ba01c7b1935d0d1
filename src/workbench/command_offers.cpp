// What the program offers on the command line: each command with its options, and the window's.
#include "workbench/command_parser.h"
#include "workbench/export_command.h"
#include "workbench/grade_command.h"
#include "workbench/import_command.h"
#include "workbench/radiosity_command.h"
#include "workbench/unwrap_command.h"

namespace cg {

void CommandParser::add_all() {
  add_window();
  add_render();
  add_compare();
  add_probe();
  add_plan();
  add_export();
  add_import();
  add_grade();
  add_radiosity();
  add_unwrap();
}

void CommandParser::add_window() {
  app_.add_option("SCENE", window.scene, say({"Opened in the window", "ウィンドウで開くもの"}))
      ->type_name("")
      ->group("");
  window_group_ = say({"Options of the window", "ウィンドウのオプション"});
  const auto in_group = [&](CLI::Option* option) { return option->group(window_group_); };
  in_group(add(app_, "--size", window_size, "WxH", {"The window's size in pixels", "ウィンドウの大きさ（画素）"}));
  in_group(add(app_, "--scale", window_scale, "S", {"The size of all type, 1 is usual", "文字などの拡大率。標準は 1"}));
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
  add(app_, "--state", window.state, "FILE",
      {"Keep what the window shows in a file, for a test", "ウィンドウの状態をファイルに書く（テスト用）"})
      ->group("");
  add(app_, "--measure-window", window.measure, "SECONDS",
      {"Drag a slider by script and print how far the pictures are behind",
       "スライダを自動で動かし、画像の遅れを表示する"})
      ->group("");  // for who works on the program
}

void CommandParser::add_render() {
  CLI::App& app = add_command("render", {"Draw a scene into a file", "シーンを画像ファイルに描く"}, run_render);
  add(app, "-o,--output", arguments.output, "FILE", {"png, jpg, exr or hdr", "png、jpg、exr、hdr のどれか"});
  add_technique(app);
  add_threads(app);
}

void CommandParser::add_compare() {
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

void CommandParser::add_probe() {
  CLI::App& app = add_command(
      "probe", {"What the colour of one pixel is made of", "一つの画素の色を、式の各項の数値で示す"}, run_probe);
  add(app, "--pixel", arguments.pixel, "X,Y", {"The pixel; 0,0 is the top-left one", "画素。左上が 0,0"});
  add_technique(app);
  add_flag(app, "--json", arguments.json, {"One JSON object on stdout", "JSON で出力する"});
  add_threads(app);
}

void CommandParser::add_plan() {
  CLI::App& app = add_command(
      "plan",
      {"What a technique runs for a scene, and what it leaves out", "手法が行う処理と、省く処理とその理由を示す"},
      run_plan);
  add_technique(app);
  add(app, "--repeats", arguments.repeats, "N",
      {"Pictures that are measured after the first, 5; 0 draws none",
       "最初の 1 枚のあとに測る枚数。既定は 5、0 なら描画しない"});
  add_flag(app, "--json", arguments.json, {"One JSON object on stdout", "JSON で出力する"});
}

void CommandParser::add_export() {
  CLI::App& app = add_bare_command(
      "export", "SCENE",
      {"Write a scene as a preset, C, a GLUT program or OBJ", "シーンをプリセット、C、GLUT プログラム、OBJ に書き出す"},
      run_export);
  add_set(app);
  add(app, "--as", arguments.format, "FORMAT",
      {"json, c, glut or obj; else by FILE's ending", "json、c、glut、obj のどれか。省くと FILE の末尾で決める"});
  add(app, "-o,--output", arguments.output, "FILE",
      {"The file; of a GLUT program .c, its meshes beside it", "書き出すファイル。glut では .c、メッシュは隣に置く"});
}

void CommandParser::add_import() {
  CLI::App& app = add_bare_command(
      "import", "FILE.c",
      {"Read the C of a student's program into a preset", "学生の C プログラムを読み、プリセットにする"}, run_import);
  add(app, "-o,--output", arguments.output, "FILE", {"The preset, json", "プリセット（json）"});
}

void CommandParser::add_grade() {
  CLI::App& app = add_bare_command(
      "grade", "STUDENT",
      {"Score a student's preset or C against a target", "学生のプリセットや C を目標と比べて採点する"}, run_grade);
  add(app, "--target", arguments.target, "SCENE", {"The scene to be matched", "目標のシーン"});
  add(app, "--pass", arguments.pass, "SCORE",
      {"Exit with 1 where the score is below this, 0 to 100", "点数がこれより低ければ終了状態を 1 にする（0〜100）"});
  add_flag(app, "--json", arguments.json, {"One JSON object on stdout", "JSON で出力する"});
}

void CommandParser::add_radiosity() {
  CLI::App& app =
      add_bare_command("radiosity", "SCENE",
                       {"Solve a scene's light by radiosity", "シーンの光をラジオシティ法で求める"}, run_radiosity);
  add_set(app);
  add_parameter(
      app, "--form-factors", "radiosity.form_factors", "METHOD",
      {"closed-form, nusselt, hemicube or monte-carlo", "closed-form、nusselt、hemicube、monte-carlo のどれか"});
  add_parameter(app, "--resolution", "radiosity.resolution", "R",
                {"Pixels a side of the hemicube's top, 16 to 1024", "ヘミキューブ上面の一辺の画素数。16 から 1024"});
  add_parameter(app, "--samples", "radiosity.samples", "S",
                {"S x S positions a patch, 1 to 16", "パッチごとに S×S 個の位置。1 から 16"});
  add_parameter(app, "--patch-size", "radiosity.patch_size", "P",
                {"No side of a patch is longer, metres", "パッチの辺の上限（m）"});
  add_parameter(app, "--solver", "radiosity.solver", "S",
                {"jacobi, gauss-seidel, southwell, progressive or lu",
                 "jacobi、gauss-seidel、southwell、progressive、lu のどれか"});
  add_parameter(
      app, "--residual", "radiosity.residual", "E",
      {"Stop where B is no further off than this, of the brightest", "B の誤差が最大値のこの割合以下になれば止める"});
  add(app, "--form-factor", arguments.form_factor, "A,B",
      {"Print the form factor from object A to object B", "物体 A から B への形態係数を表示する"});
  add_flag(app, "--weights", arguments.weights,
           {"With --form-factor: by each weight of a pixel, the wrong ones too, beside closed forms",
            "--form-factor を画素の重みごとに（誤った重みも）求め、閉じた式と並べる"});
  add(app, "--against", arguments.against, "METHOD",
      {"Solve with these form factors too and compare each object's mean: monte-carlo",
       "別の方法の形態係数でも解き、物体ごとの平均を比べる：monte-carlo"});
  add(app, "-o,--output", arguments.output, "SOLUTION",
      {"The solution, a PLY with the light of each vertex", "解（頂点ごとの光を持つ PLY）の保存先"});
  add_flag(app, "--json", arguments.json, {"One JSON object on stdout", "JSON で出力する"});
  add_threads(app);
}

void CommandParser::add_unwrap() {
  CLI::App& app = add_bare_command(
      "unwrap", "MODEL", {"Cut a model into charts and lay it flat: its uv", "モデルを切り開いて uv を求める"},
      run_unwrap);
  add_parameter(app, "--method", "method", "METHOD",
                {"lscm, spectral, mean-value or free-boundary", "lscm、spectral、mean-value、free-boundary のどれか"});
  add_set(app, "NAME=VALUE", {"Set a parameter of the unwrap: margin=8", "展開のパラメータを変える：margin=8"});
  add(app, "-o,--output", arguments.output, "FILE",
      {"OUT.obj: the model with its uv; OUT.svg, OUT.png: the layout",
       "OUT.obj は uv 付きのモデル、OUT.svg と OUT.png は展開図"});
  add(app, "--size", arguments.size, "N", {"Pixels a side of the layout, 1024", "展開図の一辺の画素数。既定は 1024"});
  add_flag(app, "--json", arguments.json, {"One JSON object on stdout", "JSON で出力する"});
}

void CommandParser::add_parameter(CLI::App& app, const char* name, const char* path, const char* type, Words help) {
  app.add_option_function<std::string>(
         name, [this, path](const std::string& v) { arguments.set.push_back(std::string(path) + "=" + v); }, say(help))
      ->type_name(type)
      ->group(options_group());
}

void CommandParser::add_other(const CommandOffer& offer) {
  std::string words;
  for (const CommandOffer::Word& word : offer.words) words += " " + std::string(word.name);
  CLI::App& app = add_named(offer.name, words, offer.help, offer.run);
  for (const CommandOffer::Word& word : offer.words)
    app.add_option(word.name, arguments.*word.value)->type_name("")->group("");
  for (const CommandOffer::Option& option : offer.options)
    if (option.flag)
      add_flag(app, option.names, arguments.*option.flag, option.help);
    else
      add(app, option.names, arguments.*option.value, option.type, option.help);
  if (!offer.draws) return;
  add_picture(app);
  add_threads(app);
}

void CommandParser::add_threads(CLI::App& app) {
  add(app, "--threads", arguments.threads, "N",
      {"Threads of the software reference; the picture is the same", "ソフトウェアのスレッド数。結果は変わらない"});
}

void CommandParser::add_technique(CLI::App& app) {
  add(app, "--technique", arguments.technique, "T", {"How it is drawn; software", "描く手法。既定は software"})
      ->description(say({"How it is drawn: ", "描く手法："}) + ids_);
}

void CommandParser::add_set(CLI::App& app) {
  add_set(app, "PATH=VALUE", {"Set a parameter: material.k_d=0.5", "値を変える：material.k_d=0.5"});
}

void CommandParser::add_set(CLI::App& app, const char* type, Words help) {
  // Appended, as the short cuts of add_parameter() are: an option bound to the list would replace what they gave.
  app.add_option_function<std::vector<std::string>>(
         "--set",
         [this](const std::vector<std::string>& values) {
           arguments.set.insert(arguments.set.end(), values.begin(), values.end());
         },
         say(help))
      ->type_name(type)
      ->group(options_group())
      ->allow_extra_args(false);
}

}  // namespace cg
