#include "tests/scene/reading.h"

namespace cg {
namespace {

Materials read(const std::string& text, std::vector<Text>* notes = nullptr) {
  std::vector<Text> own;
  return read_mtl(text, "test.mtl", notes ? *notes : own);
}

TEST(ReadMtl, ColoursAndExponent) {
  std::vector<Text> notes;
  const Materials all = read(
      "# comment\nnewmtl dark red\n\tKa 0.1 0.2 0.3\n\tKd 0.5\n\tKs 0.25 0.5 1\n\tNs 96.5\n\tKe 2 0 0\n\tNi 1.5\n"
      "\tillum 2\nnewmtl plain\n",
      &notes);
  ASSERT_EQ(all.size(), 2u);
  const Material& red = all.at("dark red");
  EXPECT_EQ(red.k_a, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(red.k_d, glm::dvec3(0.5));
  EXPECT_EQ(red.k_s, glm::dvec3(0.25, 0.5, 1));
  EXPECT_EQ(red.n, 96.5);
  EXPECT_EQ(red.emission, glm::dvec3(2, 0, 0));
  EXPECT_EQ(red.k_r, glm::dvec3(0));
  EXPECT_EQ(red.k_t, glm::dvec3(0));
  EXPECT_EQ(all.at("plain").k_s, glm::dvec3(0));
  EXPECT_TRUE(notes.empty());
}

// The illumination models of the format: 0 constant colour, 1 no highlight, 2 highlight, 3 and more reflection.
TEST(ReadMtl, IlluminationModels) {
  const auto with = [](int illum) {
    return read("newmtl m\nKd 0.6\nKs 0.3\nKa 0.1\nillum " + std::to_string(illum) + "\n").at("m");
  };
  EXPECT_EQ(with(0).emission, glm::dvec3(0.6));
  EXPECT_EQ(with(0).k_d, glm::dvec3(0));
  EXPECT_EQ(read("newmtl m\nKe 1e9\nKd 1\nillum 0\n").at("m").emission, glm::dvec3(1e6));
  EXPECT_EQ(with(1).k_s, glm::dvec3(0));
  EXPECT_EQ(with(1).k_d, glm::dvec3(0.6));
  EXPECT_EQ(with(2).k_s, glm::dvec3(0.3));
  EXPECT_EQ(with(2).k_r, glm::dvec3(0));
  EXPECT_EQ(with(5).k_r, glm::dvec3(0.3));
}

TEST(ReadMtl, TransparencyInEitherForm) {
  EXPECT_EQ(read("newmtl m\nd 0.75\n").at("m").k_t, glm::dvec3(0.25));
  EXPECT_EQ(read("newmtl m\nTr 0.25\n").at("m").k_t, glm::dvec3(0.25));
  EXPECT_EQ(read("newmtl m\nTr 0.5\nTf 1 0.5 0\n").at("m").k_t, glm::dvec3(0.5, 0.25, 0));
}

TEST(ReadMtl, WhatIsLeftOutIsNoted) {
  std::vector<Text> notes;
  const Materials all =
      read("newmtl m\nmap_Kd -s 1 1 1 wood.png\nbump b.png\nPr 0.5\nKd spectral a.rfl\nKd 2 0.5 -1\nNs 1e9\n", &notes);
  EXPECT_EQ(all.at("m").k_d, glm::dvec3(1, 0.5, 0));
  EXPECT_EQ(all.at("m").n, 1e6);
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_EQ(notes[0].en, "test.mtl: 2 texture maps are not read yet (the first, 'map_Kd', in line 2)");
  EXPECT_EQ(notes[1].en, "test.mtl: 2 statements have no counterpart here (the first, 'Pr', in line 4)");
  EXPECT_EQ(notes[2].en, "test.mtl: 3 values were outside their range and are limited to it (the first in line 6)");
}

TEST(ReadMtl, Refused) {
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"Kd 1 1 1\n", "test.mtl:1: 'Kd' before the first newmtl"},
           {"newmtl m\nKd 1 1\n", "test.mtl:2: the line ends where the blue"},
           {"newmtl m\nKd 1 1 1 1\n", "test.mtl:2: '1' is more than"},
           {"newmtl m\nKd 0,5 0 0\n", "test.mtl:2: '0,5' has a comma"},
           {"newmtl m\nNs nan\n", "test.mtl:2: 'nan' is not a finite"},
           {"newmtl m\n\nillum 11\n", "test.mtl:3: '11' is not an illumination model"},
           {"newmtl m\nnewmtl m\n", "test.mtl:2: the material 'm' is there twice"},
           {"\xff\xd8\xff", "test.mtl:1: '\\xff"}}) {
    try {
      read(text);
      ADD_FAILURE() << text;
    } catch (const InputError& e) {
      EXPECT_TRUE(e.message(Language::english).starts_with(message)) << e.message(Language::english);
    }
  }
}

}  // namespace
}  // namespace cg
