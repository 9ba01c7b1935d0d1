// Plans, line by line, with what they have in common in all techniques: the surfaces, the parts of the light model,
// what a user should know.
#pragma once
#include "scene/plan.h"
#include "scene/scene.h"
#include "shading/ambient_term.h"
#include "shading/light_parts.h"
#include "shading/surface.h"

namespace cg {

// What is drawn, counted.
struct DrawnCounts {
  std::size_t objects = 0, vertices = 0, triangles = 0;  // of every object
  std::size_t bad_normals = 0;
  std::size_t unplaced = 0;              // objects that are left out: their matrices are not finite in float
  std::vector<const Surface*> surfaces;  // each once
  LightParts parts;
  std::size_t lit_vertices = 0;  // of the surfaces, those that bring light of a radiosity solution

  void add(const SurfaceHandle& surface);
  // Of the surfaces, each once.
  std::size_t surface_vertices() const;
  std::size_t surface_triangles() const;
};

class PlanMaker {
 public:
  // `draws`: there is something to draw; else every line but `always` is left out for that reason.
  PlanMaker(Plan& plan, bool draws) : plan_(plan), draws_(draws) {}

  struct Line {
    const char* id;
    Words name;
    PassKind kind = PassKind::pass;
    bool always = false;
  };
  // `why` where it is needed, `why_not` where it is not.
  Pass& add(const Line& line, bool needed, Text why, Text why_not = {}, std::size_t bytes = 0);
  // Once, whoever says it.
  void note(Text text);
  bool draws() const { return draws_; }

 private:
  Plan& plan_;
  const bool draws_;
};

Text counted(std::size_t n, std::string_view en, std::string_view ja);  // "12 objects ..."
Text asked_for(bool wanted);

// The surfaces: made from the meshes once for each rule for normals.
void add_surfaces(const DrawnCounts& n, PlanMaker& p);
// Each term of the light model and each thing that costs more where it is used. `a_lit_vertex`: the bytes that a vertex
// with light of a radiosity solution takes.
void add_light_parts(const Scene& scene, const DrawnCounts& n, const AmbientReason& ambient, PlanMaker& p,
                     std::size_t a_lit_vertex = sizeof(glm::vec3));
// The ids of those lines, for a technique to record what it really uses.
std::vector<const char*> part_ids(const LightParts& parts, bool local_viewer, bool two_sided, bool clamp);
// What every technique that does not follow rays has to say.
void add_general_notes(const Scene& scene, const DrawnCounts& n, const AmbientReason& ambient, PlanMaker& p);

}  // namespace cg
