// The tables of extreme cases, a group each.
#pragma once
#include "measure/extreme.h"

namespace cg {

using ExtremeTable = std::vector<ExtremeCase>;

void add_light_extremes(ExtremeTable& all);
void add_attenuation_extremes(ExtremeTable& all);
void add_spot_extremes(ExtremeTable& all);
void add_material_extremes(ExtremeTable& all);
void add_normal_extremes(ExtremeTable& all);
void add_mesh_extremes(ExtremeTable& all);
void add_place_extremes(ExtremeTable& all);
void add_camera_extremes(ExtremeTable& all);
void add_picture_extremes(ExtremeTable& all);
void add_file_extremes(ExtremeTable& all);
void add_value_extremes(ExtremeTable& all);
void add_shading_arithmetic(ExtremeTable& all);
void add_geometry_arithmetic(ExtremeTable& all);
void add_number_arithmetic(ExtremeTable& all);
void add_radiosity_extremes(ExtremeTable& all);
void add_radiosity_arithmetic(ExtremeTable& all);

}  // namespace cg
