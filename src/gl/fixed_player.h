// Plays the list of OpenGL calls (shading/gl_calls.h) on the current legacy context, as the program of the student
// would. Matrices are kept in double and rounded when they are loaded, so that vertices stand where the other
// techniques put them (shading/clip_position.h); a light's position is multiplied by OpenGL itself.
#pragma once
#include "shading/gl_calls.h"

namespace cg {

class FixedPlayer {
 public:
  // OpenGL's initial state, but that no colour is clamped outside the light model; `aspect` is width / height.
  explicit FixedPlayer(double aspect);

  // Throws std::logic_error for a call that it does not know. Of glClear, glBindTexture, draw_mesh and the body of
  // draw_mesh (GlSection::mesh) it plays nothing: what is cleared, read and drawn belongs to the renderer.
  void play(const GlCall& call);

  const glm::dmat4& projection() const { return projection_; }
  const glm::dmat4& view() const { return view_; }
  // What was multiplied since the first glPushMatrix.
  const glm::dmat4& object() const { return object_; }
  const glm::vec3& clear_colour() const { return clear_colour_; }

 private:
  bool play_matrix(const GlCall& call);
  bool play_light(const GlCall& call);
  bool play_state(const GlCall& call);
  bool play_texture(const GlCall& call);
  glm::dmat4& matrix();
  void load_view() const;
  void load_texture_matrix() const;

  double aspect_;
  enum class Mode { modelview, projection, texture } mode_ = Mode::modelview;
  glm::dmat4 projection_{1}, view_{1}, object_{1}, texture_{1};
  std::vector<glm::dmat4> pushed_;
  glm::vec3 clear_colour_{0};
};

// No unit has a texture, and each is as OpenGL begins.
void reset_texture_units();

// What the body of draw_mesh gives OpenGL at each corner.
struct MeshBody {
  enum class Normals { given, flipped, none } normals = Normals::given;
  bool by_hand = false;    // colours of the program's own light model instead of normals
  bool radiosity = false;  // colours of a radiosity solution as well
};
MeshBody mesh_body(const std::vector<GlCall>& calls);

}  // namespace cg
