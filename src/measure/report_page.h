// The report that a lecturer runs on the lecture room's machine the day before, as a page for a browser: what was
// drawn, what was measured, what holds. No script, no network; a page a language, each linked to the other.
#pragma once
#include "measure/html.h"
#include "measure/lesson_results.h"

namespace cg {

// A line of the table that says where and when.
struct ReportFact {
  Words name;
  Text value;
};

// A part of the report behind the lessons: the trades, the extremes.
struct ReportPart {
  std::string_view id;  // of its element: "trades"
  Words title;
  Text about;                         // in the list at the top
  std::size_t compared = 0, off = 0;  // what was compared with what is expected, and does not hold
  Html body[2];                       // by Language
};

struct Report {
  std::vector<ReportFact> facts;
  std::vector<LessonResult> lessons;
  std::vector<ReportPart> parts;

  std::size_t compared() const, off() const;
};

// The file of a language beside the other's: "index.html", "index.ja.html".
std::string_view page_file(Language language);

// The whole page, XML as well as HTML.
std::string report_page(const Report& report, Language language);

}  // namespace cg
