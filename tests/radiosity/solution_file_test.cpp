// Solutions read back as they were written, and files that are cut short, altered or of another scene are refused.
#include "radiosity/solution_file.h"

#include <gtest/gtest.h>

#include <random>

#include "params/input_error.h"
#include "radiosity/elements.h"
#include "radiosity/solution_format.h"
#include "scene/model_file.h"
#include "tests/radiosity/scenes.h"
#include "tests/temporary_folder.h"

namespace cg {
namespace {

using namespace testing;

Scene two_rooms() {
  Scene scene = scene_of({object_of(room({1, 1, 1})), shape_object("icosphere", 1)});
  scene.material.k_d = {0.25, 0.5, 0.7};
  scene.objects[1].own_material = true;
  scene.objects[1].material.emission = {1, 0.1, 3};
  scene.objects[1].transform = {.translate = {0.1, 0.2, 1.0 / 3}, .scale = {-0.3, 0.3, 0.3}};
  return scene;
}

// Any light will do: the file does not ask how it was computed.
RadiositySolution made_up(const Scene& scene, int levels) {
  RadiositySolution out;
  out.options = {.patch_size = 0.3, .adaptive_levels = levels, .gradient = 0.05, .solver = RadiositySolver::lu};
  Progress progress;
  Patches p = make_patches(scene, out.options, progress);
  const auto light = [&](std::size_t patch, const glm::dvec3& middle) {
    return p.patches[patch].emission + glm::dvec3(1.0 / 3, 0.1 + middle.y * middle.y, std::abs(middle.x));
  };
  const auto by_element = [&] {
    std::vector<glm::dvec3> values;
    for (std::uint32_t e = 0; e < p.elements.size(); ++e)
      values.push_back(light(p.elements[e].patch, element_as_patch(p, e).centre));
    return values;
  };
  for (int i = 0; i < levels; ++i) refine_elements(p, by_element(), out.options, progress);
  out.element_radiosity = by_element();
  for (std::size_t i = 0; i < p.patches.size(); ++i) out.radiosity.push_back(light(i, p.patches[i].centre));
  out.patches = std::make_shared<Patches>(std::move(p));
  out.geometry = geometry_key(scene, out.options);
  out.figures.residual = 1e-7 / 3, out.figures.error_bound = 2e-7, out.figures.sweeps = 17.5, out.figures.steps = 1234;
  return out;
}

std::string refusal(const std::string& bytes, const Scene& scene, Language language = Language::english) {
  Progress progress;
  try {
    solution_of(bytes, "room.ply", scene, progress);
  } catch (const InputError& e) {
    EXPECT_EQ(e.message(language).find('\n'), std::string::npos);
    return e.message(language);
  }
  return "";
}

TEST(SolutionFile, ReadsBackToTheLastBit) {
  const Scene scene = two_rooms();
  for (const int levels : {0, 3}) {
    const RadiositySolution written = made_up(scene, levels);
    EXPECT_EQ(levels > 0, written.patches->elements.size() > written.patches->patches.size());
    const std::string bytes = solution_bytes(written);
    EXPECT_EQ(solution_bytes(written), bytes);
    Progress progress;
    const SolutionHandle read = solution_of(bytes, "room.ply", scene, progress);
    EXPECT_EQ(read->options, written.options);
    EXPECT_EQ(read->geometry, written.geometry);
    EXPECT_EQ(read->radiosity, written.radiosity);
    EXPECT_EQ(read->element_radiosity, written.element_radiosity);
    EXPECT_EQ(read->figures.residual, written.figures.residual);
    EXPECT_EQ(read->figures.steps, 1234u);
    EXPECT_TRUE(read->notes.empty());
    EXPECT_EQ(read->matrix, nullptr);
    ASSERT_EQ(read->patches->elements.size(), written.patches->elements.size());
    for (std::size_t e = 0; e < read->patches->elements.size(); ++e) {
      EXPECT_EQ(read->patches->elements[e].vertex, written.patches->elements[e].vertex);
      EXPECT_EQ(read->patches->elements[e].level, written.patches->elements[e].level);
    }
    EXPECT_EQ(solution_bytes(*read), bytes);
  }
}

// Any PLY reader sees a mesh of the scene's size.
TEST(SolutionFile, IsAnOrdinaryPly) {
  const Scene scene = two_rooms();
  const RadiositySolution written = made_up(scene, 2);
  const Model model = read_ply(solution_bytes(written), "room.ply");
  ASSERT_EQ(model.parts.size(), 1u);
  const Mesh& mesh = *model.parts[0].mesh;
  EXPECT_EQ(mesh.data().face_count(), written.patches->elements.size());
  EXPECT_EQ(mesh.data().positions.size(), written.patches->vertices.size());
  double area = 0, expected = 0;
  for (const Triangle& t : mesh.triangles()) {
    const auto at = [&](int k) {
      return mesh.data().positions[mesh.data().corners[t.corner[std::size_t(k)]].position];
    };
    area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
  }
  for (const Patch& patch : written.patches->patches) expected += patch.area;
  EXPECT_NEAR(area, expected, 1e-6);
  EXPECT_EQ(model.notes.size(), 2u);  // colours and patches, which are no part of a mesh
}

TEST(SolutionFile, CutShortAnywhere) {
  const Scene scene = two_rooms();
  const std::string bytes = solution_bytes(made_up(scene, 1));
  for (std::size_t n = 0; n < bytes.size(); n += n < 1500 ? 13 : 997) {
    const std::string message = refusal(bytes.substr(0, n), scene);
    const bool begun = n >= bytes.find("version 1\n") + 10;  // before that nothing says what it is
    EXPECT_NE(message.find(begun ? "cut short" : "not a radiosity solution"), std::string::npos) << n << ' ' << message;
  }
  EXPECT_NE(refusal(bytes.substr(0, bytes.size() - 1), scene).find("cut short"), std::string::npos);
  EXPECT_NE(refusal(bytes + "x", scene).find("altered"), std::string::npos);
  EXPECT_NE(refusal(bytes.substr(0, bytes.size() / 2), scene, Language::japanese).find("途中で切れている"),
            std::string::npos);
  EXPECT_NE(refusal("", scene), "");
}

TEST(SolutionFile, AlteredAnywhere) {
  const Scene scene = two_rooms();
  const std::string bytes = solution_bytes(made_up(scene, 1));
  for (std::size_t n = 0; n < bytes.size(); n += n < 1500 ? 7 : 1009)
    for (const char flip : {1, 64}) {
      std::string altered = bytes;
      altered[n] = char(altered[n] ^ flip);
      EXPECT_NE(refusal(altered, scene), "") << n;
    }
  EXPECT_NE(refusal("solid teapot", scene).find("not a radiosity solution"), std::string::npos);
}

TEST(SolutionFile, OfAnotherScene) {
  const Scene scene = two_rooms();
  const std::string bytes = solution_bytes(made_up(scene, 1));
  Scene other = scene;
  other.objects[1].transform.translate.x += 0.01;
  EXPECT_NE(refusal(bytes, other).find("another geometry"), std::string::npos);
  other = scene, other.objects.pop_back();
  EXPECT_NE(refusal(bytes, other).find("another geometry"), std::string::npos);
  // Light and camera do not matter; other materials are told.
  other = scene;
  other.camera.position.x += 1;
  other.material.k_d.x = 0.3;
  Progress progress;
  const SolutionHandle read = solution_of(bytes, "room.ply", other, progress);
  ASSERT_EQ(read->notes.size(), 1u);
  EXPECT_NE(read->notes[0].en.find("96 patches"), std::string::npos) << read->notes[0].en;
  progress.cancelled = true;
  EXPECT_THROW(solution_of(bytes, "room.ply", scene, progress), Cancelled);
}

TEST(SolutionFile, OnDisk) {
  const TemporaryFolder folder;
  const Scene scene = two_rooms();
  const RadiositySolution written = made_up(scene, 1);
  save_solution(written, folder / "room.ply");
  Progress progress;
  EXPECT_EQ(read_solution(folder / "room.ply", scene, progress)->radiosity, written.radiosity);
  EXPECT_THROW(read_solution(folder / "none.ply", scene, progress), InputError);
  EXPECT_THROW(save_solution(written, folder.path() / "no folder" / "room.ply"), InputError);
}

// Altered, and signed anew: refused, or a solution whose lists fit together, whatever was altered.
TEST(SolutionFile, Forged) {
  const Scene scene = two_rooms();
  const std::string bytes = solution_bytes(made_up(scene, 1));
  const std::size_t sum = bytes.find(solution_format::checksum_key) + solution_format::checksum_key.size();
  const std::size_t body = bytes.find(solution_format::end);
  std::mt19937 random(7);
  int refused = 0, taken = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string forged = bytes;
    const std::size_t most = trial % 2 ? bytes.size() : body;
    for (int k = trial % 5; k >= 0; --k) forged[random() % most] = char(random());
    forged.replace(sum, solution_format::digits, solution_format::digits, '0');
    forged.replace(sum, solution_format::digits, solution_format::hexadecimal(solution_format::checksum(forged)));
    Progress progress;
    try {
      const SolutionHandle read = solution_of(forged, "room.ply", scene, progress);
      EXPECT_EQ(read->radiosity.size(), read->patches->patches.size());
      EXPECT_EQ(read->element_radiosity.size(), read->patches->elements.size());
      ++taken;
    } catch (const InputError& e) {
      EXPECT_FALSE(e.message(Language::japanese).empty());
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
  EXPECT_GT(taken, 100);
}

// Levels that no cutting in four gives are refused, whatever the checksum says.
TEST(SolutionFile, LevelsThatCannotBe) {
  const Scene scene = scene_of({object_of({rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})})});
  Progress progress;
  Patches p = make_patches(scene, {.patch_size = 1}, progress);
  const auto cut = [&](std::vector<int> levels) {
    Patches copy = p;
    return cut_to_levels(copy, levels, progress) ? copy.elements.size() : 0;
  };
  EXPECT_EQ(cut({0}), 1u);
  EXPECT_EQ(cut({1, 1, 1, 1}), 4u);
  EXPECT_EQ(cut({1, 2, 2, 2, 2, 1, 1}), 7u);
  for (const std::vector<int>& bad : std::vector<std::vector<int>>{{},
                                                                   {1},
                                                                   {1, 1, 1},
                                                                   {1, 1, 1, 1, 1},
                                                                   {0, 0},
                                                                   {2, 2, 2, 2},
                                                                   {1, 2, 2, 2, 1, 1, 2},
                                                                   {-1},
                                                                   {255},
                                                                   {2, 1, 2, 2, 2, 1, 1}})
    EXPECT_EQ(cut(bad), 0u);
}

}  // namespace
}  // namespace cg
