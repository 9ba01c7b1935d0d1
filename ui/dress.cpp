#include "ui/dress.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <chrono>

#include "ui/app.h"
#include "ui/texts.h"

namespace cg {
namespace {

float scale_of(const App& app) {
  const double monitor = app.presenter.on ? app.presenter.scale : app.content_scale;
  return float(std::clamp(monitor * app.settings.zoom, 0.4, 8.0));
}

}  // namespace

Dress::Dress(App& app) : finding_(std::async(std::launch::async, find_fonts).share()) {
  note_all_texts(app.look.glyphs, language_ = app.language());
  start(app, scale_of(app));
}

Dress::~Dress() {
  if (pending_.valid()) pending_.wait();
}

void Dress::start(App& app, float scale) {
  app.look.glyphs.changed = false;
  pending_ =
      std::async(std::launch::async, [scale, wanted = app.look.glyphs.wanted, files = finding_, wake = app.wake] {
        auto built = build_fonts(scale, wanted, *files.get());
        if (wake) wake();
        return built;
      });
}

void Dress::fit(App& app) {
  Look& look = app.look;
  if (language_ != app.language()) note_all_texts(look.glyphs, language_ = app.language());
  const bool first = !fonts_;
  if (pending_.valid() && (first || pending_.wait_for(std::chrono::seconds(0)) == std::future_status::ready))
    adopt(app);
  look.stroke = app.presenter.on ? 1.5f : 1.0f;
  const float scale = scale_of(app);
  if (!pending_.valid() && (scale != fonts_->scale || look.glyphs.changed)) {
    start(app, scale);
    if (first) adopt(app);
  }
  if (theme_ != app.settings.theme || first) {
    look.palette = palette_of(theme_ = app.settings.theme);
    apply_style(look);
  }
}

void Dress::adopt(App& app) {
  fonts_ = pending_.get();
  app.look.fonts = fonts_->fonts;
  app.look.scale = fonts_->scale;
  apply_style(app.look);
  ImGui::GetIO().Fonts = fonts_->atlas.get();
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

}  // namespace cg
