// What each bundled picture shows at uv, 0..1, as a screen shows it; alpha last.
#pragma once
#include <glm/glm.hpp>
#include <string>

namespace cg {

glm::dvec4 uv_grid(double u, double v);
glm::dvec4 checker(double u, double v);
glm::dvec4 globe(double u, double v);
// (s, t): the place on the cube's face, t = 0 at the top.
glm::dvec4 room(const glm::dvec3& direction, const std::string& sign, double s, double t);

double brick_height(double u, double v);  // 0 in the mortar, up to 1
glm::dvec4 brick_colour(double u, double v);
glm::dvec4 wood(double u, double v);
glm::dvec4 marble(double u, double v);
glm::dvec4 hair_card(double u, double v);
glm::dvec4 torn_cloth(double u, double v);
double rust_mask(double u, double v);  // 1: bare metal
glm::dvec4 sky(double u, double v);    // longitude and latitude

}  // namespace cg
