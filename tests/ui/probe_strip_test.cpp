// The strip with a probed pixel: whole at every width, in both languages; its words choose vertex and light.
#include "ui/probe_strip.h"
#include "raster/software.h"
#include "tests/ui/imgui_fixture.h"
#include "ui/actions.h"
#include "workbench/open.h"

namespace cg {
namespace {

class ProbeStripTest : public ImGuiTest {
 protected:
  // The pixel in the middle of what the software drew.
  void probe_middle() {
    auto drawing = std::make_shared<Drawing>();
    drawing->view.width = drawing->view.height = 64;
    const Technique software = software_technique();
    app.techniques = {software};
    Progress progress;
    drawing->scene = app.scene;
    drawing->frame = software.render(app.scene, software.plan(app.scene, drawing->view), drawing->view, progress);
    app.probing.at = glm::dvec2(0.5, 0.5);
    auto probed = std::make_shared<Probed>();
    probed->drawing = drawing;
    probed->probe = probe(app.scene, software, drawing->view, drawing->frame, {32, 32}, progress);
    EXPECT_TRUE(probed->probe.covered);
    app.probing.results = {probed, probed};
  }

  // How far to the right and down something was drawn.
  static ImVec2 extent() {
    ImVec2 most{0, 0};
    const ImDrawData* data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i)
      for (const ImDrawVert& v : data->CmdLists[i]->VtxBuffer)
        most = {std::max(most.x, v.pos.x), std::max(most.y, v.pos.y)};
    return most;
  }
};

Scene coloured(ShadingMode mode, int lights) {
  Scene scene = open_scene("icosphere");
  scene.material.k_d = {0.7, 0.45, 0.2};
  scene.shading.mode = mode;
  scene.lights.resize(std::size_t(lights));
  if (lights > 1) scene.lights[1].kind = LightKind::spot;
  return scene;
}

TEST_F(ProbeStripTest, IsNeverCut) {
  ImGui::GetStyle().Colors[ImGuiCol_WindowBg].w = 0;  // only what the strip draws counts
  ImGui::GetStyle().WindowPadding = {16, 10};         // of the strip
  for (const Language language : {Language::english, Language::japanese}) {
    app.settings.language = language;
    for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
      for (const int lights : {1, 2, 5})
        for (const bool grey : {true, false}) {
          app.scene = coloured(mode, lights);
          if (grey) app.scene.material.k_d = glm::dvec3(0.8);
          probe_middle();
          for (const float width : {330.f, 560.f, 588.f, 640.f, 800.f, 1200.f}) {
            ImGui::GetIO().DisplaySize = {width, 400};  // more room below than the strip has
            frame([&] {
              ImGui::SetCursorScreenPos({0, 0});
              ImGui::BeginChild("strip", {width, 200}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
              ImGui::PushClipRect({0, 0}, {9999, 9999}, false);
              draw_strip(app);
              ImGui::PopClipRect();
              ImGui::EndChild();
            });
            EXPECT_LE(extent().x, width - 16 + 4) << width;  // 4: what is lit has an edge
            if (width >= 560) {
              EXPECT_LE(extent().y, 200) << width << ' ' << int(mode) << lights << grey;
            }
          }
        }
  }
}

TEST_F(ProbeStripTest, WordsChooseTheVertex) {
  app.scene = coloured(ShadingMode::gouraud, 1);
  probe_middle();
  const auto draw = [&] { draw_probe_choices(app, *shown_probe(app), 0, 700, 40); };
  frame(draw);
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = {694, 36};  // the last word
  frame(draw);
  io.MouseDown[0] = true;
  frame(draw);
  io.MouseDown[0] = false;
  frame(draw);
  EXPECT_EQ(app.probing.vertex, 2);
}

TEST_F(ProbeStripTest, TheRowsSayWhatTheProbeSays) {
  app.scene = coloured(ShadingMode::phong, 1);
  app.scene.material.k_d = glm::dvec3(0.8);
  probe_middle();
  const Probe& p = *shown_probe(app);
  const ProbeRows rows = number_rows(app, p, 5);
  ASSERT_EQ(rows.wide.size(), 2u);  // factors, and what they come to
  const std::string& diffuse = rows.wide[0].cells[std::size_t(Part::diffuse)];
  EXPECT_TRUE(diffuse.starts_with("1 × 0.8 × ")) << diffuse;
  const double n_dot_l = std::strtod(diffuse.c_str() + std::string("1 × 0.8 × ").size(), nullptr);
  EXPECT_NEAR(n_dot_l, p.here.lights[0].n_dot_l, 0.0006);
  EXPECT_NEAR(std::strtod(rows.wide[1].cells[std::size_t(Part::diffuse)].c_str(), nullptr), 0.8 * n_dot_l, 0.001);
  EXPECT_NEAR(std::strtod(rows.wide[1].cells[std::size_t(Part::sum)].c_str(), nullptr), p.sum.x, 0.0006);
}

TEST_F(ProbeStripTest, FactorsHaveALineOfTheirOwn) {
  for (const int lights : {1, 3})
    for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong}) {
      app.scene = coloured(mode, lights);
      probe_middle();
      const float line = app.look.px(19);
      const auto height = [&](float room) {
        float drawn = 0;
        frame([&] { drawn = draw_probe_results(app, *shown_probe(app), {0, 0}, {700, room}); });
        return drawn;
      };
      EXPECT_EQ(height(3 * line), 2 * line);
      EXPECT_EQ(height(2 * line), 2 * line);
      EXPECT_EQ(height(line), line);
    }
}

TEST_F(ProbeStripTest, EscapeLetsThePixelGo) {
  app.scene = coloured(ShadingMode::phong, 1);
  probe_middle();
  app.help = true;
  const std::vector<KeyPress> escape{{GLFW_KEY_ESCAPE}};
  handle_keys(app, escape);
  EXPECT_TRUE(app.probing.at);
  handle_keys(app, escape);
  EXPECT_FALSE(app.probing.at);
  EXPECT_EQ(shown_probe(app), nullptr);
}

}  // namespace
}  // namespace cg
