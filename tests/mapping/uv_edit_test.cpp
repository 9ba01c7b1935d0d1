// Editing a layout: what moves, what tears, what joins; and how a moved vertex stretches the texture.
#include "mapping/uv_edit.h"

#include <gtest/gtest.h>

#include "mapping/layout_drawing.h"
#include "mapping/mesh_union.h"
#include "mapping/unwrap.h"
#include "scene/shape.h"

namespace cg {
namespace {

// Two squares side by side, joined, each a quarter of the texture.
UvLayout two_squares() {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  const Corner left[] = {{0}, {1}, {2}, {3}}, right[] = {{1}, {4}, {5}, {2}};
  data.add_face(left, left + 4), data.add_face(right, right + 4);
  return make_layout(Mesh::make(data), {{0, 0}, {.5, 0}, {.5, .5}, {0, .5}, {.5, 0}, {1, 0}, {1, .5}, {.5, .5}});
}

TEST(UvEdit, SelectsByFaceChartPlaceAndVertex) {
  const UvLayout layout = two_squares();
  EXPECT_EQ(layout.charts, 1u);
  EXPECT_EQ(corners_of_face(layout, 1), (Corners{4, 5, 6, 7}));
  EXPECT_EQ(corners_of_chart(layout, 0).size(), 8u);
  EXPECT_EQ(corners_within(layout, {.4, -.1}, {.6, .1}), (Corners{1, 4}));
  EXPECT_EQ(whole_vertices(layout, {1}), (Corners{1, 4}));
  EXPECT_EQ(whole_vertices(layout, {0}), (Corners{0}));
  EXPECT_EQ(face_at(layout, {.25, .25}), 0u);
  EXPECT_EQ(face_at(layout, {.75, .25}), 1u);
  EXPECT_FALSE(face_at(layout, {.75, .75}));
  EXPECT_EQ(corner_near(layout, {.98, .49}, .1), 6u);
  EXPECT_FALSE(corner_near(layout, {.25, .25}, .1));
}

TEST(UvEdit, WholeVerticesMoveTogetherCornersTear) {
  const UvLayout layout = two_squares();
  UvTransform how;
  how.offset = {0, .1};
  const UvLayout together = transformed(layout, whole_vertices(layout, {1}), how);
  EXPECT_EQ(together.charts, 1u);
  EXPECT_EQ(together.uv[1], together.uv[4]);
  const UvLayout torn = transformed(layout, {1, 2}, how);
  EXPECT_EQ(torn.charts, 2u);
  EXPECT_EQ(seams_of(torn), (std::vector<SeamEdge>{{1, 2}}));
  EXPECT_EQ(welded(torn, {1, 2, 4, 7}).charts, 1u);
}

TEST(UvEdit, TurningAndScalingAreExact) {
  const UvLayout layout = two_squares();
  UvTransform how;
  how.centre = {.5, .25}, how.degrees = 90, how.scale = {2, .5}, how.offset = {.25, 0};
  const UvLayout out = transformed(layout, corners_of_chart(layout, 0), how);
  // (1, .5) - centre = (.5, .25) -> (1, .125) -> (-.125, 1)
  EXPECT_LT(glm::length(out.uv[6] - glm::dvec2(.625, 1.25)), 1e-15);
  how.scale = {1e308, 1e308}, how.offset = {1e308, 0};
  for (const glm::dvec2& p : transformed(out, corners_of_chart(out, 0), how).uv)
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
}

TEST(UvEdit, SplitAndStitchUndoEachOther) {
  const UvLayout layout = two_squares();
  const UvLayout apart = split_off(layout, {1}, 0.05);
  EXPECT_EQ(apart.charts, 2u);
  EXPECT_EQ(apart.uv[0], layout.uv[0]);
  EXPECT_NEAR(glm::length(apart.uv[4] - layout.uv[4]), 0.05, 1e-12);
  EXPECT_EQ(apart.uv[5], layout.uv[5]);  // no other face has it
  UvTransform away;
  away.offset = {.3, .4}, away.degrees = 77, away.scale = {.5, .5};
  const UvLayout far = transformed(apart, corners_of_face(apart, 1), away);
  const UvLayout back = stitched(far, {2, 1});
  EXPECT_EQ(back.charts, 1u);
  EXPECT_EQ(back.uv[1], back.uv[4]);
  EXPECT_EQ(back.uv[2], back.uv[7]);
  EXPECT_EQ(stitched(layout, {1, 2}), layout);  // one chart already
  EXPECT_EQ(stitched(layout, {0, 5}), layout);  // no edge
}

TEST(UvEdit, SplitFacesStayTogether) {
  const MeshHandle plane = make_shape(*find_shape("plane"), 4);
  const UvLayout layout = make_layout(plane, corner_uv(plane->data()));
  ASSERT_EQ(layout.charts, 1u);
  const UvLayout out = split_off(layout, {5, 6}, 0.01);
  EXPECT_EQ(out.charts, 2u);
  EXPECT_EQ(corners_of_chart(out, out.chart[5]).size(), 8u);
  EXPECT_EQ(split_off(layout, {}, 0.01), layout);
}

TEST(UvEdit, AMovedVertexStretches) {
  const UvLayout layout = two_squares();
  for (const Stretch& s : stretches_of(layout)) EXPECT_NEAR(s.quasi_conformal(), 1, 1e-12);
  // The right side twice as far: its triangles are stretched to the double, the left square's are not.
  MeshHandle mesh = with_vertex_at(*layout.mesh, 4, {3, 0, 0});
  mesh = with_vertex_at(*mesh, 5, {3, 1, 0});
  const UvLayout after = on_mesh(layout, mesh);
  EXPECT_EQ(after.uv, layout.uv);
  const std::vector<Stretch> stretches = stretches_of(after);
  for (std::size_t t = 0; t < stretches.size(); ++t)
    EXPECT_NEAR(stretches[t].quasi_conformal(), mesh->triangles()[t].face == 0 ? 1 : 2, 1e-12);
  EXPECT_EQ(seams_of(after), seams_of(layout));
}

TEST(UvEdit, PackingAgainKeepsTheCharts) {
  const UvLayout layout = unwrap(make_shape(*find_shape("cylinder")), {});
  UvTransform how;
  how.scale = {.3, .3}, how.offset = {2, 5};
  const UvLayout away = transformed(layout, corners_of_chart(layout, 0), how);
  const UvLayout back = pack_again(away, {});
  EXPECT_EQ(back.chart, layout.chart);
  const LayoutFigures f = figures_of(back, 1024);
  EXPECT_EQ(f.overlapping_pixels, 0u);
  EXPECT_NEAR(f.distortion.area_distortion(), 1, 1e-6);
}

TEST(LayoutDrawing, DrawsEachEdgeOnceAndSeamsTwice) {
  const MeshHandle cube = make_shape(*find_shape("cube"));
  const UvLayout layout = unwrap(cube, {});
  const auto lines = layout_lines(layout);
  const auto seams = seams_of(layout);
  EXPECT_EQ(lines.size(), 12 + seams.size());
  std::size_t borders = 0;
  for (const LayoutLine& line : lines) borders += line.border;
  EXPECT_EQ(borders, 2 * seams.size());
  const std::string svg = layout_svg(layout, 512);
  EXPECT_EQ(svg.find("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"512\" height=\"512\""), 0u);
  EXPECT_EQ(svg.find("nan"), svg.npos);
  // One square in the lower left quarter: v goes up, the SVG's y down.
  const std::string one = layout_svg(two_squares(), 100);
  EXPECT_NE(one.find("M0 100L50 100"), one.npos) << one;
}

TEST(LayoutDrawing, PictureIsTheSameAsPixels) {
  const Picture p = layout_picture(two_squares(), 64);
  EXPECT_EQ(p.at(10, 10), glm::u8vec4(255, 255, 255, 255));  // v > 1/2: nothing
  EXPECT_EQ(p.at(10, 50), glm::u8vec4(255, 255, 255, 255));  // inside a face
  EXPECT_LT(p.at(10, 63).x, 80);                             // the lower border
  // The edge between the squares, half a pixel wide and half grey, half a pixel from two columns of centres.
  EXPECT_EQ(p.at(32, 50).x, 223);
  EXPECT_EQ(p.at(31, 50).x, 223);
}

TEST(MeshUnion, PartsGetTheirOwnUvBack) {
  const std::vector<MeshHandle> parts{make_shape(*find_shape("cube")), make_shape(*find_shape("plane"), 2)};
  const MeshHandle all = joined_meshes(parts);
  EXPECT_EQ(all->data().face_count(), 6u + 4u);
  const UvLayout layout = unwrap(all, {});
  EXPECT_EQ(figures_of(layout, 512).overlapping_pixels, 0u);
  const std::vector<MeshData> out = parted_uv(parts, layout.uv);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[1].positions, parts[1]->data().positions);
  EXPECT_EQ(out[1].normals, parts[1]->data().normals);
  EXPECT_EQ(corner_uv(out[1])[0], layout.uv[24]);
}

}  // namespace
}  // namespace cg
