// How near a student's picture comes to a target: one number, and what to look at next.
#pragma once
#include <array>
#include <optional>

#include "scene/technique.h"

namespace cg {

// What a parameter belongs to, as a hint names it.
enum class HintKind { ambient, diffuse, specular, emission, light, object, camera, shading, display };
template <>
inline constexpr std::array<Name, 9> names_of<HintKind>{{{"ambient", {"Ambient term", "環境光の項"}},
                                                         {"diffuse", {"Diffuse term", "拡散反射の項"}},
                                                         {"specular", {"Specular term", "鏡面反射の項"}},
                                                         {"emission", {"Emission", "自己発光"}},
                                                         {"light", {"Light", "光源"}},
                                                         {"object", {"Object", "物体"}},
                                                         {"camera", {"Camera", "カメラ"}},
                                                         {"shading", {"Shading", "シェーディング"}},
                                                         {"display", {"Display", "表示"}}}};

struct Score {
  double rmse = 0;   // of the pictures, 0..1
  double value = 0;  // 0..100
  // What each kind alone does to the target's picture, as an RMSE; 0 where nothing of the kind differs.
  std::array<double, names_of<HintKind>.size()> off{};
  std::optional<HintKind> hint;  // the kind that is furthest off; nothing where the pictures are alike
};

inline constexpr int score_size = 256;      // of the square picture, pixels
inline constexpr double score_zero = 0.25;  // the RMSE that is worth nothing

// 100 (1 - rmse / score_zero), not below 0: each 0.0025 costs a point, a picture a tenth too bright 40.
double score_of_rmse(double rmse);

// The RMSE is taken after the display transform of each scene, over the three channels of the pixels that either
// picture covers (of all, where the backgrounds differ). For the hint, the parameters of one kind are carried from the
// student's scene into the target's, and the pictures compared: of a term of the light model alone, by isolated(); of
// any other kind, whole. Every object's mesh is loaded. The result does not depend on `threads`. Throws InputError
// where the technique cannot draw a scene, and Cancelled.
Score score(const Scene& student, const Scene& target, const Technique& technique, Progress& progress, int threads = 1);

// "Specular term: look at k_s, n and the lights' specular colours."
Text hint_text(HintKind kind);

}  // namespace cg
