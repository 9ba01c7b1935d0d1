#include "ui/texts.h"

#include "measure/extreme.h"
#include "measure/knob.h"
#include "params/slots.h"
#include "scene/scene.h"
#include "ui/actions.h"

namespace cg {
namespace {

template <Described T>
void note_slots(Glyphs& glyphs, Language language, T value) {
  for (const Slot& slot : slots(value)) {
    glyphs.note(slot.about->label.in(language));
    glyphs.note(slot.about->help.in(language));
    if (const Choice* c = std::get_if<Choice>(&slot.value))
      for (const Name& n : c->names) glyphs.note(n.label.in(language));
  }
}

}  // namespace

void note_all_texts(Glyphs& glyphs, Language language) {
  Scene scene;
  scene.objects.emplace_back();
  note_slots(glyphs, language, scene);
  note_slots(glyphs, language, Settings{});
  for (const Action& a : actions()) {
    glyphs.note(a.label.in(language));
    glyphs.note(a.keys);
  }
  for (const Knob& knob : knobs()) {
    for (const Words& words : {knob.name, knob.help, knob.abscissa.name, knob.error}) glyphs.note(words.in(language));
    for (const Series& series : knob.series) glyphs.note(series.name.in(language));
    for (const Prediction& p : knob.predictions)
      for (const std::string_view text : {p.law, p.why.in(language), p.source}) glyphs.note(text);
  }
  for (const ExtremeCase& c : extreme_cases()) glyphs.note(c.name.in(language)), glyphs.note(c.right.in(language));
  // Of messages that come later, so that they seldom cost a new atlas.
  glyphs.note("日本語…–−×·°²ΣαθπΔ≤≥→“”’");
  if (language == Language::japanese)
    for (ImWchar c = 0x3041; c <= 0x30fe; ++c) glyphs.wanted.insert(c);
}

}  // namespace cg
