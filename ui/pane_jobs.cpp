#include "ui/pane_jobs.h"

#include <algorithm>

#include "shading/ambient_term.h"
#include "workbench/model_library.h"

namespace cg {

namespace {

constexpr std::size_t times_kept = 9;
constexpr std::chrono::milliseconds patience{150};

bool same(const Request& a, const Request& b) {
  return a.view == b.view && a.mark_clamped == b.mark_clamped && a.scene == b.scene;
}

bool is_difference(ViewMode view) { return view == ViewMode::difference || view == ViewMode::false_colour; }

std::shared_ptr<const Compared> comparison_of(const DrawingHandle& left, const DrawingHandle& right, ViewMode view,
                                              double gain, const std::shared_ptr<const Compared>& before) {
  auto out = std::make_shared<Compared>();
  out->left = left, out->right = right, out->view = view, out->gain = gain;
  const Frame &a = left->frame, &b = right->frame;
  if (before && before->left == left && before->right == right)
    out->difference = before->difference;  // only how it is shown has changed
  else
    out->difference = difference(a.colour, b.colour, a.covered, b.covered, left->scene.display);
  if (view == ViewMode::difference) out->picture = absolute_picture(out->difference, gain);
  if (view == ViewMode::false_colour) out->picture = false_colour(out->difference, gain);
  return out;
}

}  // namespace

PaneJobs::PaneJobs(std::vector<Technique> techniques, std::function<void()> wake)
    : techniques_(std::move(techniques)), wake_(std::move(wake)), runners_(techniques_.size()) {}

PaneJobs::Runner& PaneJobs::runner(int technique) {
  std::unique_ptr<Runner>& r = runners_[std::size_t(technique)];
  if (!r) {
    r = std::make_unique<Runner>();
    Job::Hooks hooks;
    hooks.prepare = [](Scene& scene) { load_meshes(scene); };
    hooks.wake = wake_;
    r->job = std::make_unique<Job>(techniques_[std::size_t(technique)], std::move(hooks));
  }
  return *r;
}

void PaneJobs::time(Runner& runner, const DrawingHandle& drawing, PaneState& pane) {
  if (drawing && drawing->coarseness == 1 && !drawing->partly && drawing->serial != runner.timed) {
    runner.timed = drawing->serial;
    runner.times.push_back(drawing->wall_ms);
    if (runner.times.size() > times_kept) runner.times.pop_front();
  }
  if (runner.times.empty()) return;
  std::vector<double> sorted(runner.times.begin(), runner.times.end());
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end());
  pane.ms = sorted[sorted.size() / 2];
}

bool PaneJobs::still_drawing(int left, int right) {
  return Clock::now() - submitted_at_ < patience && (runner(left).job->poll().busy || runner(right).job->poll().busy);
}

void PaneJobs::update(const Request& wanted, int left, int right, bool together) {
  if (std::min(left, right) < 0 || std::max(left, right) >= int(techniques_.size())) return;
  const bool later = together && still_drawing(left, right);
  for (int side = 0; side < 2; ++side) {
    const int technique = side == 0 ? left : right;
    Runner& r = runner(technique);
    if (!later && (r.serial == 0 || !same(r.request, wanted))) {
      r.request = wanted;
      r.serial = r.job->submit(wanted);
      submitted_at_ = Clock::now();
    }
    PaneState& pane = panes_[std::size_t(side)];
    if (pane.technique != technique) pane = {}, pane.technique = technique;
    Job::State state = r.job->poll();
    pane.drawing = std::move(state.drawing);
    pane.message = std::move(state.message);
    pane.busy = state.busy, pane.fraction = state.fraction;
    time(r, pane.drawing, pane);
  }
}

std::uint64_t PaneJobs::submitted(int side) const {
  const int technique = pane(side).technique;
  return technique < 0 ? 0 : runners_[std::size_t(technique)]->serial;
}

bool PaneJobs::pictures_match() const {
  const DrawingHandle &a = panes_[0].drawing, &b = panes_[1].drawing;
  return a && b && !panes_[0].message && !panes_[1].message && a->coarseness == 1 && b->coarseness == 1 &&
         a->view == b->view && a->scene == b->scene;
}

bool PaneJobs::busy() const { return panes_[0].busy || panes_[1].busy || comparer_.busy() || outliner_.busy(); }

void PaneJobs::compare(ViewMode view, double gain) {
  compared_ = compared_mail_.take();
  if (!pictures_match()) return;
  // While the scene still moves only a picture of the difference is worth the time that the techniques need too.
  if (!is_difference(view)) {
    if (panes_[0].busy || panes_[1].busy) return;
    view = ViewMode::two, gain = 0;
  }
  const Comparison wanted{panes_[0].drawing, panes_[1].drawing, view, gain};
  if (wanted == comparison_) return;
  comparison_ = wanted;
  comparer_.submit([this, wanted](Progress&) {
    compared_mail_.put(comparison_of(wanted.left, wanted.right, wanted.view, wanted.gain, compared_mail_.take()));
    wake_();
  });
}

void PaneJobs::outline(const Scene& drawn, const OverlayChoice& choice) {
  overlay_ = overlay_mail_.take();
  const bool wanted = choice.edges || choice.face_normals || choice.vertex_normals;
  Outline outline{wanted ? with_drawn_meshes(drawn).objects : std::vector<Object>{}, drawn.shading, choice};
  // What does not move a line must not have them all made again.
  for (Object& object : outline.objects) object.material = {}, object.own_material = false;
  const Shading lines_of = drawn.shading;
  outline.shading = {};
  if (choice.vertex_normals) {
    outline.shading.mode = lines_of.mode;
    outline.shading.normals = lines_of.normals, outline.shading.crease_angle = lines_of.crease_angle;
  }
  if (outline == outline_) return;
  outline_ = outline;
  outliner_.submit([this, outline = std::move(outline)](Progress&) {
    Scene scene;
    scene.objects = outline.objects, scene.shading = outline.shading;
    overlay_mail_.put(std::make_shared<const MeshOverlay>(mesh_overlay(scene, outline.choice)));
    wake_();
  });
}

}  // namespace cg
