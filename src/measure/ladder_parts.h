// What the ladders of several knobs are made with.
#pragma once
#include "measure/knob.h"

namespace cg {

// The picture that is compared: what the request asks for, or `own` pixels a side.
View view_of(const TradeRequest& request, int own);

// The technique that the request names, or the knob's own. Throws InputError where there is none of that id or it
// cannot draw the scene.
std::string technique_of(const TradeRequest& request, std::string_view own);

// A reference by the software technique in double: on all processors, as its time is not measured.
Setting reference_of(Scene scene, View view);

// Every material that a visible object has.
template <class Change>
void change_materials(Scene& scene, const Change& change) {
  change(scene.material);
  for (Object& object : scene.objects) change(object.material);
}

// A setting or a reference that is drawn `factor` times larger than `picture` and filtered down.
void oversample(Setting& setting, const View& picture, int factor, Resampling filter);

// The distance along the view, metres, that a window depth 0..1 stands for: the inverse of the projection.
double eye_depth(double window_depth, const Camera& camera);

// The distance from the eye, along the view, of the nearest visible thing: of the corners of its box. Throws InputError
// where it is not in front of the eye.
double nearest_depth(const Scene& scene);

}  // namespace cg
