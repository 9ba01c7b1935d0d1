#include "gl/fixed_player.h"

#include <epoxy/gl.h>

#include <array>
#include <stdexcept>

namespace cg {

namespace {

struct Token {
  std::string_view name;
  GLenum value;
};

// clang-format off
constexpr Token tokens[] = {
    {"GL_TRUE", GL_TRUE}, {"GL_FALSE", GL_FALSE},
    {"GL_DEPTH_TEST", GL_DEPTH_TEST}, {"GL_CULL_FACE", GL_CULL_FACE}, {"GL_LIGHTING", GL_LIGHTING},
    {"GL_NORMALIZE", GL_NORMALIZE}, {"GL_RESCALE_NORMAL", GL_RESCALE_NORMAL}, {"GL_COLOR_MATERIAL", GL_COLOR_MATERIAL},
    {"GL_FLAT", GL_FLAT}, {"GL_SMOOTH", GL_SMOOTH}, {"GL_CW", GL_CW}, {"GL_CCW", GL_CCW},
    {"GL_CLAMP_VERTEX_COLOR", GL_CLAMP_VERTEX_COLOR},
    {"GL_LIGHT_MODEL_AMBIENT", GL_LIGHT_MODEL_AMBIENT}, {"GL_LIGHT_MODEL_LOCAL_VIEWER", GL_LIGHT_MODEL_LOCAL_VIEWER},
    {"GL_LIGHT_MODEL_TWO_SIDE", GL_LIGHT_MODEL_TWO_SIDE},
    {"GL_FRONT", GL_FRONT}, {"GL_BACK", GL_BACK}, {"GL_FRONT_AND_BACK", GL_FRONT_AND_BACK},
    {"GL_AMBIENT", GL_AMBIENT}, {"GL_DIFFUSE", GL_DIFFUSE}, {"GL_AMBIENT_AND_DIFFUSE", GL_AMBIENT_AND_DIFFUSE},
    {"GL_SPECULAR", GL_SPECULAR}, {"GL_EMISSION", GL_EMISSION}, {"GL_SHININESS", GL_SHININESS},
    {"GL_POSITION", GL_POSITION}, {"GL_SPOT_DIRECTION", GL_SPOT_DIRECTION}, {"GL_SPOT_CUTOFF", GL_SPOT_CUTOFF},
    {"GL_SPOT_EXPONENT", GL_SPOT_EXPONENT}, {"GL_CONSTANT_ATTENUATION", GL_CONSTANT_ATTENUATION},
    {"GL_LINEAR_ATTENUATION", GL_LINEAR_ATTENUATION}, {"GL_QUADRATIC_ATTENUATION", GL_QUADRATIC_ATTENUATION},
    {"GL_ALPHA_TEST", GL_ALPHA_TEST}, {"GL_GREATER", GL_GREATER},
    {"GL_TEXTURE_2D", GL_TEXTURE_2D}, {"GL_TEXTURE_WRAP_S", GL_TEXTURE_WRAP_S},
    {"GL_TEXTURE_WRAP_T", GL_TEXTURE_WRAP_T}, {"GL_REPEAT", GL_REPEAT}, {"GL_MIRRORED_REPEAT", GL_MIRRORED_REPEAT},
    {"GL_CLAMP_TO_EDGE", GL_CLAMP_TO_EDGE}, {"GL_CLAMP_TO_BORDER", GL_CLAMP_TO_BORDER},
    {"GL_TEXTURE_MAG_FILTER", GL_TEXTURE_MAG_FILTER}, {"GL_TEXTURE_MIN_FILTER", GL_TEXTURE_MIN_FILTER},
    {"GL_NEAREST", GL_NEAREST}, {"GL_LINEAR", GL_LINEAR}, {"GL_NEAREST_MIPMAP_NEAREST", GL_NEAREST_MIPMAP_NEAREST},
    {"GL_LINEAR_MIPMAP_NEAREST", GL_LINEAR_MIPMAP_NEAREST}, {"GL_NEAREST_MIPMAP_LINEAR", GL_NEAREST_MIPMAP_LINEAR},
    {"GL_LINEAR_MIPMAP_LINEAR", GL_LINEAR_MIPMAP_LINEAR}, {"GL_TEXTURE_LOD_BIAS", GL_TEXTURE_LOD_BIAS},
    {"GL_TEXTURE_MAX_ANISOTROPY_EXT", GL_TEXTURE_MAX_ANISOTROPY_EXT},
    {"GL_TEXTURE_BORDER_COLOR", GL_TEXTURE_BORDER_COLOR}, {"GL_TEXTURE_ENV", GL_TEXTURE_ENV},
    {"GL_TEXTURE_ENV_MODE", GL_TEXTURE_ENV_MODE}, {"GL_TEXTURE_ENV_COLOR", GL_TEXTURE_ENV_COLOR},
    {"GL_REPLACE", GL_REPLACE}, {"GL_MODULATE", GL_MODULATE}, {"GL_DECAL", GL_DECAL}, {"GL_BLEND", GL_BLEND},
    {"GL_ADD", GL_ADD},
    {"GL_TEXTURE0", GL_TEXTURE0}, {"GL_TEXTURE1", GL_TEXTURE1}, {"GL_TEXTURE2", GL_TEXTURE2},
    {"GL_TEXTURE3", GL_TEXTURE3}, {"GL_TEXTURE4", GL_TEXTURE4}, {"GL_TEXTURE5", GL_TEXTURE5},
    {"GL_TEXTURE6", GL_TEXTURE6}, {"GL_TEXTURE7", GL_TEXTURE7},
    {"GL_LIGHT0", GL_LIGHT0}, {"GL_LIGHT1", GL_LIGHT1}, {"GL_LIGHT2", GL_LIGHT2}, {"GL_LIGHT3", GL_LIGHT3},
    {"GL_LIGHT4", GL_LIGHT4}, {"GL_LIGHT5", GL_LIGHT5}, {"GL_LIGHT6", GL_LIGHT6}, {"GL_LIGHT7", GL_LIGHT7},
};
// clang-format on

GLenum token(const GlCall& call, std::size_t i) {
  for (const Token& t : tokens)
    if (t.name == call.tokens.at(i)) return t.value;
  throw std::logic_error("gl-fixed does not know " + call.tokens.at(i));
}

// The numbers as the program's float array holds them.
std::array<GLfloat, 4> floats(const GlCall& call) {
  std::array<GLfloat, 4> out{0, 0, 0, 1};
  for (std::size_t i = 0; i < call.numbers.size() && i < 4; ++i) out[i] = GLfloat(call.numbers[i].value);
  return out;
}

glm::dvec3 vector(const GlCall& call, std::size_t first) {
  return {call.numbers.at(first).value, call.numbers.at(first + 1).value, call.numbers.at(first + 2).value};
}

void reset_lights() {
  constexpr GLfloat black[4] = {0, 0, 0, 1}, white[4] = {1, 1, 1, 1}, from_eye[4] = {0, 0, 1, 0}, ahead[3] = {0, 0, -1};
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  for (int i = 0; i < gl_light_limit; ++i) {
    const auto light = GLenum(GL_LIGHT0 + i);
    glDisable(light);
    glLightfv(light, GL_AMBIENT, black);
    glLightfv(light, GL_DIFFUSE, i == 0 ? white : black);
    glLightfv(light, GL_SPECULAR, i == 0 ? white : black);
    glLightfv(light, GL_POSITION, from_eye);
    glLightfv(light, GL_SPOT_DIRECTION, ahead);
    glLightf(light, GL_SPOT_EXPONENT, 0);
    glLightf(light, GL_SPOT_CUTOFF, 180);
    glLightf(light, GL_CONSTANT_ATTENUATION, 1);
    glLightf(light, GL_LINEAR_ATTENUATION, 0);
    glLightf(light, GL_QUADRATIC_ATTENUATION, 0);
  }
}

void reset_material() {
  constexpr GLfloat ambient[4] = {0.2f, 0.2f, 0.2f, 1}, diffuse[4] = {0.8f, 0.8f, 0.8f, 1}, black[4] = {0, 0, 0, 1};
  glDisable(GL_COLOR_MATERIAL);
  glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, black);
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, black);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 0);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_FALSE);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_FALSE);
}

}  // namespace

void reset_texture_units() {
  constexpr GLfloat black[4] = {0, 0, 0, 0};
  glDisable(GL_ALPHA_TEST);
  glMatrixMode(GL_TEXTURE);
  for (int unit = gl_texture_unit_limit - 1; unit >= 0; --unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glDisable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, black);
    glLoadIdentity();
  }
  glMatrixMode(GL_MODELVIEW);
}

FixedPlayer::FixedPlayer(double aspect) : aspect_(aspect) {
  glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
  glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
  glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
  for (const GLenum what : {GL_LIGHTING, GL_NORMALIZE, GL_RESCALE_NORMAL, GL_CULL_FACE}) glDisable(what);
  // A picture without depth test still needs depths, so that the frame knows what is covered: GL_ALWAYS draws the same.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glFrontFace(GL_CCW);
  glShadeModel(GL_SMOOTH);
  glColor3f(1, 1, 1);
  glNormal3f(0, 0, 1);
  reset_lights();
  reset_material();
  reset_texture_units();
}

void FixedPlayer::play(const GlCall& call) {
  const bool drawn_elsewhere = call.section == GlSection::mesh || call.section == GlSection::draw ||
                               call.function == "glClear" || call.function == "glBindTexture";
  if (call.missing || call.function.empty() || drawn_elsewhere) return;
  if (play_matrix(call) || play_light(call) || play_texture(call) || play_state(call)) return;
  throw std::logic_error("gl-fixed does not know " + std::string(call.function));
}

glm::dmat4& FixedPlayer::matrix() {
  if (mode_ == Mode::texture) return texture_;
  return mode_ == Mode::projection ? projection_ : pushed_.empty() ? view_ : object_;
}

bool FixedPlayer::play_matrix(const GlCall& call) {
  const auto number = [&](std::size_t i) { return call.numbers.at(i).value; };
  if (call.function == "glMatrixMode")
    mode_ = call.tokens.at(0) == "GL_PROJECTION" ? Mode::projection
            : call.tokens.at(0) == "GL_TEXTURE"  ? Mode::texture
                                                 : Mode::modelview;
  else if (call.function == "glLoadIdentity")
    matrix() = glm::dmat4(1);
  else if (call.function == "gluPerspective")
    matrix() = matrix() * perspective(radians(number(0)), number(1) * aspect_, number(2), number(3));
  else if (call.function == "glOrtho")
    matrix() = matrix() * orthographic(number(3) - number(2), aspect_, number(4), number(5));
  else if (call.function == "gluLookAt")
    matrix() = matrix() * look_at(vector(call, 0), vector(call, 3), vector(call, 6));
  else if (call.function == "glPushMatrix")
    pushed_.push_back(object_);
  else if (call.function == "glPopMatrix")
    object_ = pushed_.back(), pushed_.pop_back();
  else if (call.function == "glTranslated")
    matrix() = matrix() * translation(vector(call, 0));
  else if (call.function == "glRotated")
    matrix() = matrix() * rotation(radians(number(0)), vector(call, 1));
  else if (call.function == "glScaled")
    matrix() = matrix() * scaling(vector(call, 0));
  else
    return false;
  if (mode_ == Mode::texture) load_texture_matrix();
  return true;
}

// Into the unit that is active.
void FixedPlayer::load_texture_matrix() const {
  const glm::mat4 texture(texture_);
  glMatrixMode(GL_TEXTURE);
  glLoadMatrixf(&texture[0].x);
}

// glLight multiplies positions and directions by the modelview matrix of this moment.
void FixedPlayer::load_view() const {
  const glm::mat4 view(view_);
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(&view[0].x);
}

bool FixedPlayer::play_light(const GlCall& call) {
  if (call.function == "glLightfv") {
    if (call.tokens.at(1) == "GL_POSITION" || call.tokens.at(1) == "GL_SPOT_DIRECTION") load_view();
    glLightfv(token(call, 0), token(call, 1), floats(call).data());
  } else if (call.function == "glLightf") {
    glLightf(token(call, 0), token(call, 1), floats(call)[0]);
  } else if (call.function == "glLightModelfv") {
    glLightModelfv(token(call, 0), floats(call).data());
  } else if (call.function == "glLightModeli") {
    glLightModeli(token(call, 0), GLint(token(call, 1)));
  } else if (call.function == "glMaterialfv") {
    glMaterialfv(token(call, 0), token(call, 1), floats(call).data());
  } else if (call.function == "glMaterialf") {
    glMaterialf(token(call, 0), token(call, 1), floats(call)[0]);
  } else if (call.function == "glColorMaterial") {
    glColorMaterial(token(call, 0), token(call, 1));
  } else if (call.function == "glColor3d") {
    glColor3fv(floats(call).data());
  } else {
    return false;
  }
  return true;
}

bool FixedPlayer::play_texture(const GlCall& call) {
  if (call.function == "glActiveTexture")
    glActiveTexture(token(call, 0));
  else if (call.function == "glTexParameteri")
    glTexParameteri(token(call, 0), token(call, 1), GLint(token(call, 2)));
  else if (call.function == "glTexParameterf")
    glTexParameterf(token(call, 0), token(call, 1), floats(call)[0]);
  else if (call.function == "glTexParameterfv")
    glTexParameterfv(token(call, 0), token(call, 1), floats(call).data());
  else if (call.function == "glTexEnvi")
    glTexEnvi(token(call, 0), token(call, 1), GLint(token(call, 2)));
  else if (call.function == "glTexEnvfv")
    glTexEnvfv(token(call, 0), token(call, 1), floats(call).data());
  else if (call.function == "glAlphaFunc")
    glAlphaFunc(token(call, 0), floats(call)[0]);
  else
    return false;
  return true;
}

bool FixedPlayer::play_state(const GlCall& call) {
  if (call.function == "glEnable" && call.tokens.at(0) == "GL_DEPTH_TEST")
    glDepthFunc(GL_LESS);
  else if (call.function == "glEnable")
    glEnable(token(call, 0));
  else if (call.function == "glDisable")
    glDisable(token(call, 0));
  else if (call.function == "glShadeModel")
    glShadeModel(token(call, 0));
  else if (call.function == "glFrontFace")
    glFrontFace(token(call, 0));
  else if (call.function == "glClampColor")
    glClampColor(token(call, 0), token(call, 1));
  else if (call.function == "glClearColor")
    clear_colour_ = glm::vec3(vector(call, 0));
  else
    return false;
  return true;
}

MeshBody mesh_body(const std::vector<GlCall>& calls) {
  MeshBody body{.normals = MeshBody::Normals::none};
  for (const GlCall& call : calls) {
    if (call.section != GlSection::mesh || call.missing) continue;
    if (call.function == "glNormal3fv") body.normals = MeshBody::Normals::given;
    if (call.function == "glNormal3f") body.normals = MeshBody::Normals::flipped;
    if (call.function != "glColor3fv") continue;
    const std::string& shade = call.tokens.at(0);
    if (shade == "radiosity") body.radiosity = true;
    if (shade == "radiosity") continue;
    body.by_hand = true;
    body.normals = shade.find("flipped") != shade.npos     ? MeshBody::Normals::flipped
                   : shade.find("no_normal") != shade.npos ? MeshBody::Normals::none
                                                           : MeshBody::Normals::given;
  }
  return body;
}

}  // namespace cg
