// Solution files whose checksum fits and whose contents do not: what somebody who signs a file anew can ask of the
// reader. Each is refused with one line, or read to a solution that fits together.
#include <gtest/gtest.h>

#include "params/file.h"
#include "params/input_error.h"
#include "params/slots.h"
#include "radiosity/solution_file.h"
#include "tests/fuzz/solution_forgery.h"

namespace cg {
namespace {

using namespace testing;
using std::string;

RadiositySolution solved(Radiosity options) {
  Progress progress;
  options.form_factors = FormFactors::closed_form;
  return *solve_radiosity(forged_scene(), options, nullptr, progress);
}

// The message, in both languages one line that begins with the file or a parameter; "" where it was read.
string refusal(const string& bytes) {
  Progress progress;
  const Scene scene = forged_scene();
  try {
    const SolutionHandle s = solution_of(bytes, "forged.ply", scene, progress);
    EXPECT_EQ(s->radiosity.size(), s->patches->patches.size());
    EXPECT_EQ(s->element_radiosity.size(), s->patches->elements.size());
    EXPECT_EQ(drawable(scene, *s)->objects.size(), 2u);
  } catch (const InputError& e) {
    for (const Language l : {Language::english, Language::japanese}) {
      EXPECT_EQ(e.message(l).find('\n'), string::npos);
      EXPECT_TRUE(e.message(l).starts_with(e.where));
      EXPECT_LT(e.message(l).size(), 1000u);
    }
    return e.message(Language::english);
  }
  return "";
}

string replaced(string text, const string& old, const string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, string::npos) << old;
  return at == string::npos ? text : text.replace(at, old.size(), now);
}

class ForgedSolution : public ::testing::Test {
 protected:
  string good = solution_bytes(solved({.patch_size = 0.5}));
  std::size_t body = good.find(solution_format::end) + solution_format::end.size();

  void expect_refused(const string& old, const string& now) {
    EXPECT_NE(refusal(signed_anew(replaced(good, old, now))), "") << old << " -> " << now;
  }
};

TEST_F(ForgedSolution, TheGoodOneIsRead) {
  EXPECT_EQ(refusal(good), "");
  EXPECT_EQ(signed_anew(good), good);
}

TEST_F(ForgedSolution, Headers) {
  const std::pair<const char*, const char*> wrong[] = {
      {"ply\n", "PLY\n"},
      {"little", "big"},
      {"binary_little_endian", "ascii"},
      {"1.0\n", "2.0\n"},
      {"solution, version 1", "solution, version 2"},
      {"comment geometry ", "comment geometri "},
      {"comment geometry ", "comment geometry f"},
      {"\"patch_size\":0.5", "\"patch_size\":0.25"},
      {"\"patch_size\":0.5", "\"patch_size\":\"0.5\""},
      {"\"patch_size\":0.5", "\"patch_size\":1e-300"},
      {"\"patch_size\":0.5", "\"patch_size\":nan"},
      {"\"patch_size\":0.5", "\"patch_size\":{"},
      {"\"normalise\":\"rows\"", "\"normalise\":7"},
      {"element vertex ", "element vertex 4"},
      {"element vertex ", "element vertex -"},
      {"element vertex ", "element vertex 9223372036854775807"},
      {"element vertex ", "element vertex 99999999999999999999"},
      {"element face ", "element face 1"},
      {"element face ", "element face 4000000000000"},
      {"element face ", "element faces "},
      {"element patch ", "element patch 1"},
      {"element patch ", "element patch 18446744073709551615"},
      {"element patch ", "element hatch "},
      {"property float x", "property double x"},
      {"property float x", "property float w"},
      {"property uchar level", "property int level"},
      {"property list uchar uint", "property list uint uint"},
      {"property double area\n", ""},
      {"end_header\n", "element more 0\nproperty uchar a\nend_header\n"},
      {"end_header\n", "property double more\nend_header\n"},
      {"end_header\n", "end_headers\n"},
  };
  for (const auto& [old, now] : wrong) expect_refused(old, now);
}

TEST_F(ForgedSolution, Bodies) {
  const auto put = [&](std::size_t at, const string& bytes) {
    string out = good;
    return signed_anew(out.replace(at, bytes.size(), bytes));
  };
  const std::size_t patch = good.size() - 88;  // the last one's
  const string nan("\0\0\0\0\0\0\xf8\x7f", 8), infinite("\0\0\0\0\0\0\xf0\x7f", 8);
  for (const string& value : {nan, infinite}) EXPECT_NE(refusal(put(patch + 88 - 8, value)), "");
  EXPECT_NE(refusal(signed_anew(good.substr(0, good.size() - 1))), "");
  EXPECT_NE(refusal(signed_anew(good.substr(0, body))), "");
  EXPECT_NE(refusal(signed_anew(good + string(88, '\0'))), "");
  // The largest light that is a number is drawn as it is.
  EXPECT_EQ(refusal(put(patch + 88 - 8, string("\xff\xff\xff\xff\xff\xff\xef\x7f", 8))), "");
  // A face's first byte is the length of its list; the level stands behind patch and list.
  const Patches patches = *solved({.patch_size = 0.5}).patches;
  const std::size_t face = body + 27 * patches.vertices.size();
  ASSERT_EQ(int(good[face]), 4);
  for (const char length : {'\0', '\3', '\5', '\xff'}) EXPECT_NE(refusal(put(face, string(1, length))), "");
  for (const char level : {'\1', '\xff'}) EXPECT_NE(refusal(put(face + 1 + 16 + 4, string(1, level))), "");
}

// A file of a few patches whose parameters ask for millions of this scene costs nothing.
TEST_F(ForgedSolution, PatchesBeyondTheFile) {
  for (const double size : {1e-3, 1e-6}) {
    RadiositySolution s = solved({.patch_size = 0.5});
    s.options.patch_size = size;
    s.geometry = geometry_key(forged_scene(), s.options);
    EXPECT_NE(refusal(solution_bytes(s)), "");
  }
}

// Every byte of the header and of the body, wrong in two ways: without a fitting checksum it is always refused.
TEST_F(ForgedSolution, EachByte) {
  std::size_t read = 0;
  for (std::size_t n = 0; n < good.size(); ++n)
    for (const char flip : {'\1', '\x80'}) {
      string altered = good;
      altered[n] = char(altered[n] ^ flip);
      ASSERT_NE(refusal(altered), "") << n;
      if (refusal(signed_anew(altered)).empty()) ++read;
    }
  EXPECT_GT(read, good.size() / 4);  // numbers that stay numbers
  for (std::size_t n = 0; n < good.size(); ++n) ASSERT_NE(refusal(good.substr(0, n)), "") << n;
  for (std::size_t n = 0; n < good.size(); n += 3) ASSERT_NE(refusal(signed_anew(good.substr(0, n))), "") << n;
}

// What the fuzzer starts from is of this scene and this version.
TEST(ForgedSolutionCorpus, IsRead) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SHADEBENCH_SOURCE_DIR "/tests/fuzz/corpus/solution")) {
    EXPECT_EQ(refusal(read_file(entry.path())), "") << entry.path();
    ++files;
  }
  EXPECT_GE(files, 3u);
}

}  // namespace
}  // namespace cg
