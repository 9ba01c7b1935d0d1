// The listing's lines for a known scene, the place of each number in them, and the way of a number back into the scene.
#include "workbench/listing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "params/input_error.h"
#include "params/numbers.h"
#include "params/slots.h"
#include "tests/workbench/random_scene.h"

namespace cg {
namespace {

Scene one_object() {
  Scene scene;
  scene.objects.resize(1);
  return scene;
}

std::string text_of(const Listing& listing) {
  std::string out;
  for (const ListingLine& line : listing.lines) out += line.text + "\n";
  return out;
}

const ListingLine& line_with(const Listing& listing, const std::string& text) {
  for (const ListingLine& line : listing.lines)
    if (line.text.find(text) != line.text.npos) return line;
  throw std::out_of_range(text);
}

TEST(Listing, OfTheDefaultsIsAsTheCourseWritesIt) {
  EXPECT_EQ(text_of(listing(one_object())), R"(/* init() */
glClearColor( 0.0, 0.0, 0.0, 1.0 );
glEnable( GL_DEPTH_TEST );
glShadeModel( GL_SMOOTH );
glEnable( GL_NORMALIZE );

glEnable( GL_LIGHTING );
float light_model_ambient[] = { 0.2, 0.2, 0.2, 1.0 };
glLightModelfv( GL_LIGHT_MODEL_AMBIENT, light_model_ambient );

/* reshape() */
glMatrixMode( GL_PROJECTION );
glLoadIdentity();
gluPerspective( 40.0, aspect, 0.1, 100.0 );

/* display() */
glClear( GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT );
glMatrixMode( GL_MODELVIEW );
glLoadIdentity();
gluLookAt( 0.0, 1.0, 3.4, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 );

float light0_position[] = { 10.0, 10.0, 10.0, 1.0 };
glLightfv( GL_LIGHT0, GL_POSITION, light0_position );
float light0_ambient[] = { 0.0, 0.0, 0.0, 1.0 };
glLightfv( GL_LIGHT0, GL_AMBIENT, light0_ambient );
float light0_diffuse[] = { 1.0, 1.0, 1.0, 1.0 };
glLightfv( GL_LIGHT0, GL_DIFFUSE, light0_diffuse );
float light0_specular[] = { 1.0, 1.0, 1.0, 1.0 };
glLightfv( GL_LIGHT0, GL_SPECULAR, light0_specular );
glEnable( GL_LIGHT0 );

glPushMatrix();
float material_ambient[] = { 0.2, 0.2, 0.2, 1.0 };
glMaterialfv( GL_FRONT_AND_BACK, GL_AMBIENT, material_ambient );
float material_diffuse[] = { 0.8, 0.8, 0.8, 1.0 };
glMaterialfv( GL_FRONT_AND_BACK, GL_DIFFUSE, material_diffuse );
float material_specular[] = { 0.5, 0.5, 0.5, 1.0 };
glMaterialfv( GL_FRONT_AND_BACK, GL_SPECULAR, material_specular );
glMaterialf( GL_FRONT_AND_BACK, GL_SHININESS, 32.0 );
draw_mesh( mesh0 );
glPopMatrix();

/* draw_mesh() */
glBegin( GL_TRIANGLES );
glNormal3fv( normal );
glVertex3fv( vertex );
glEnd();
)");
}

TEST(Listing, ALineKnowsWhatItIsAbout) {
  const Listing all = listing(one_object());
  const ListingLine& position = line_with(all, "float light0_position");
  EXPECT_EQ(position.light, 0);
  ASSERT_EQ(position.numbers.size(), 4u);
  EXPECT_EQ(position.numbers[1], (ListingNumber{34, 38, "lights.0.position", 1, 10, 1}));
  EXPECT_EQ(position.numbers[3].path, "lights.0.w");
  EXPECT_EQ(line_with(all, "float material_diffuse").quantity, Quantity::diffuse);
  EXPECT_EQ(line_with(all, "GL_SHININESS").quantity, Quantity::specular);
  EXPECT_EQ(line_with(all, "glShadeModel").path, "shading.mode");
  EXPECT_TRUE(line_with(all, "display()").comment);
}

TEST(Listing, EachNumberStandsWhereItSays) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    Scene scene = random_scene(random);
    const Listing all = listing(scene);
    const Slots parameters = slots(scene);
    for (const ListingLine& line : all.lines)
      for (const ListingNumber& n : line.numbers) {
        ASSERT_LE(n.end, line.text.size());
        ASSERT_EQ(line.text.substr(n.begin, n.end - n.begin), c_literal(n.value)) << line.text;
        if (n.path.empty()) continue;
        ASSERT_NO_THROW(find_slot(parameters, n.path));
      }
  }
}

// The number of that path and component, or null.
const ListingNumber* find(const Listing& listing, const std::string& path, int component) {
  for (const ListingLine& line : listing.lines)
    for (const ListingNumber& n : line.numbers)
      if (n.path == path && n.component == component) return &n;
  return nullptr;
}

TEST(Listing, AnAssignedNumberIsTheOneThatIsShown) {
  Scene scene = one_object();
  scene.lights[0].kind = LightKind::spot;
  scene.lights[0].k_1 = scene.lights[0].k_2 = scene.lights[0].exponent = 0.5;
  scene.camera.projection = Projection::orthographic;
  scene.objects[0].transform = {{1, 2, 3}, {10, 20, 30}, {2, 2, 2}};
  int assigned = 0;
  for (const ListingLine& line : listing(scene).lines)
    for (const ListingNumber& n : line.numbers) {
      if (n.path.empty()) continue;
      const double value = n.value * 0.75 + (n.value == 0 ? 0.25 : 0);
      Scene changed = scene;
      assign_number(changed, n, value);
      EXPECT_FALSE(changed == scene) << n.path;
      const Listing after = listing(changed);
      const ListingNumber* shown = find(after, n.path, n.component);
      ASSERT_TRUE(shown) << n.path;
      EXPECT_DOUBLE_EQ(shown->value / shown->factor, value / n.factor) << n.path;
      ++assigned;
    }
  EXPECT_GT(assigned, 50);
}

TEST(Listing, ATypedNumberIsReadAsCHasIt) {
  Scene scene = one_object();
  const ListingNumber y{0, 0, "lights.0.position", 1, 10, 1};
  for (const auto& [typed, value] :
       {std::pair("1.0", 1.0), {" -2.5f ", -2.5}, {".5", 0.5}, {"1e3F", 1000}, {"+3", 3}}) {
    assign_number(scene, y, typed);
    EXPECT_EQ(scene.lights[0].position, glm::dvec3(10, value, 10)) << typed;
  }
}

TEST(Listing, AWrongNumberChangesNothing) {
  Scene scene = one_object();
  const Scene before = scene;
  const ListingNumber n{0, 0, "material.n", -1, 32, 1}, red{0, 0, "material.k_d", 0, 0.8, 1};
  for (const char* typed : {"", "f", "one", "1,0", "0x10", "1.0 2.0", "nan", "1e400"})
    EXPECT_THROW(assign_number(scene, n, typed), InputError) << typed;
  EXPECT_THROW(assign_number(scene, n, "-1"), InputError);
  EXPECT_THROW(assign_number(scene, red, "1.5"), InputError);
  EXPECT_THROW(assign_number(scene, red, std::nan("")), InputError);
  EXPECT_EQ(scene, before);
}

TEST(Listing, LimitsOfOpenGlAreComments) {
  Scene scene = one_object();
  scene.material.n = 300;
  scene.lights.resize(10);
  scene.shading.reflection = Reflection::reflection_vector;
  for (const Language language : {Language::english, Language::japanese}) {
    const Listing all = listing(scene, language);
    const auto comments =
        std::count_if(all.lines.begin(), all.lines.end(), [](const ListingLine& l) { return l.comment; });
    EXPECT_EQ(comments, 4 + 3);  // of the functions, of the limits
  }
  EXPECT_EQ(line_with(listing(scene), "GL_SHININESS,").numbers[0].value, 128);
  EXPECT_THROW(line_with(listing(scene), "GL_LIGHT8"), std::out_of_range);
}

TEST(Listing, EachMistakeHasAGuiltyLine) {
  Scene scene = one_object();
  scene.objects[0].transform.scale = {2, 2, 2};
  for (const Slot& slot : slots(scene.mistakes)) {
    bool& mistake = *std::get<bool*>(slot.value);
    const auto guilty = [&] {
      int n = 0;
      for (const ListingLine& line : listing(scene).lines) n += line.guilty;
      return n;
    };
    EXPECT_EQ(guilty(), 0);
    mistake = true;
    EXPECT_GT(guilty(), 0) << slot.path;
    mistake = false;
  }
}

}  // namespace
}  // namespace cg
