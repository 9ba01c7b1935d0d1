#include "measure/lesson_report.h"

#include <sys/utsname.h>

#include <chrono>
#include <ctime>
#include <thread>

#include "measure/report_parts.h"
#include "params/file.h"
#include "params/input_error.h"
#include "workbench/progress_line.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

// ISO 8601 with the machine's own offset from UTC: "2026-10-01 09:15 +0900".
std::string date_text() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char buffer[64];
  return {buffer, std::strftime(buffer, sizeof buffer, "%Y-%m-%d %H:%M %z", &local)};
}

// What the system calls itself (os-release(5)), and its kernel.
std::string system_name() {
  std::string name;
  try {
    const std::string release = read_file("/etc/os-release");
    constexpr std::string_view key = "PRETTY_NAME=\"";
    const std::size_t at = release.find(key);
    if (at != release.npos)
      name = release.substr(at + key.size(), release.find('"', at + key.size()) - at - key.size());
  } catch (const InputError&) {
  }
  utsname kernel{};
  if (::uname(&kernel) != 0) return name;
  return name + (name.empty() ? "" : ", ") + kernel.sysname + " " + kernel.release + ", " + kernel.nodename;
}

// OpenGL's renderer and version, or why there is none.
Text device_text(const Technique& technique) {
  const std::string device = technique.device();
  if (!device.empty()) return {device, device};
  const auto reason = technique.unsupported(Scene{});
  return reason ? *reason : Text{"not known", "不明"};
}

std::vector<ReportFact> facts_of(std::span<const Technique> techniques, const ResultOptions& options) {
  const auto same = [](const std::string& s) { return Text{s, s}; };
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
  std::vector<ReportFact> out{{{"Date", "日時"}, same(date_text())},
                              {{"System", "システム"}, same(system_name())},
                              {{"Processor", "プロセッサ"}, same(cpu_name() + " ×" + std::to_string(processors))}};
  for (const Technique& t : techniques)
    if (t.device) out.push_back({t.name, device_text(t)});
  const std::string size = std::to_string(options.timed) + "×" + std::to_string(options.timed);
  const std::string threads = std::to_string(options.threads);
  out.push_back({{"Frame times", "描画時間"},
                 {"median, least and greatest of frames of " + size + " on the clock, read back; software on " +
                      threads + " threads. CPU: processor time of all threads",
                  size + " 画素の 1 フレームを描き、読み戻すまでの実時間。中央値と、最小・最大。ソフトウェアは " +
                      threads + " スレッド。CPU は全スレッドの合計"}});
  out.push_back(
      {{"Differences", "差"},
       {"in false colours: dark blue where the pictures are equal, over violet and orange to yellow for 1 / the "
        "factor beside it",
        "擬似カラーで示す。濃い青が差 0、紫・橙を経て、黄が（1 ÷ 添えた倍率）"}});
  return out;
}

}  // namespace

WrittenReport write_lesson_report(const std::vector<fs::path>& folders,
                                  std::vector<std::vector<LessonFinding>> findings, const fs::path& into,
                                  std::span<const Technique> techniques, bool quick, Language language) {
  ResultOptions options;
  options.threads = int(std::max(1u, std::thread::hardware_concurrency()));
  Report report;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    Progress progress;
    const ProgressLine line(progress, folders[i].filename().string());
    report.lessons.push_back(lesson_result(folders[i], std::move(findings[i]), into, techniques, options, progress));
  }
  if (!quick) report.parts = {trades_part(techniques, options.threads, language), extremes_part(techniques, language)};
  report.facts = facts_of(techniques, options);
  if (quick)
    report.facts.push_back(
        {{"Left out", "省略"}, {"trades and extremes (--quick)", "速さと正確さ、極端な値（--quick）"}});
  for (const Language page : {Language::english, Language::japanese})
    save_file(into / page_file(page), report_page(report, page));
  return {report.off() == 0, into / page_file(language)};
}

}  // namespace cg
