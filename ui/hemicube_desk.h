// One patch's hemicube, drawn and counted beside the window on threads of its own: what it sees from one of its
// positions, its row of form factors, and of one patch that it sees all that is told about the two.
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "radiosity/hemicube_picture.h"
#include "radiosity/known_factor.h"
#include "radiosity/nusselt.h"
#include "radiosity/patch_tree.h"
#include "radiosity/solution.h"
#include "ui/settings.h"
#include "ui/texture.h"
#include "workbench/lesson.h"
#include "workbench/worker.h"

namespace cg {

struct App;

// The patches of a scene, ready to be asked about. Never changed once it is made.
struct HemicubeGround {
  // `inputs` as HemicubeDesk::inputs_of(), `loaded` the same with its meshes; `gl` may be null.
  HemicubeGround(Scene inputs, const Scene& loaded, const MakeDrawItems& gl, Progress& progress);
  HemicubeGround(const HemicubeGround&) = delete;
  HemicubeGround& operator=(const HemicubeGround&) = delete;

  // The patch that a ray meets first, on either side; `direction` unit.
  std::optional<std::uint32_t> met(const glm::dvec3& origin, const glm::dvec3& direction) const;
  // The patch that lies where one of another division lay.
  std::optional<std::uint32_t> at_place_of(const Patch& patch) const;

  const Scene inputs;
  const std::uint64_t geometry;
  const Patches patches;
  const std::vector<ItemPolygon> polygons;
  const MakeDrawItems gl;  // all of it by one context, made when it is first drawn with
  const HemicubeViewer viewer;
  const PatchTree tree;
  const std::vector<std::uint16_t> all;  // a bit each
};
using GroundHandle = std::shared_ptr<const HemicubeGround>;

// What a position of the patch sees.
struct HemicubeSight {
  GroundHandle ground;
  std::uint32_t patch = 0;
  std::size_t position = 0, positions = 1;
  Radiosity options;
  HemicubeShow show = HemicubeShow::items;
  bool solved = false;  // of HemicubeShow::seen: the solved light, not the material
  HemicubeView view;
  std::vector<PatchPixels> pixels;  // by item
  Picture picture;                  // the cross; of HemicubeShow::nusselt the disc

  const PatchPixels* of(std::uint32_t item) const;  // null: no pixel
};

// The row of the matrix.
struct HemicubeRow {
  GroundHandle ground;
  std::uint32_t patch = 0;
  Radiosity options;
  FormFactorMethod method;
  FormFactorRow row;
  std::vector<FormFactor> by_size;  // the same, largest first
  std::vector<KnownFactor> known;   // of the first of by_size
  double factor(std::uint32_t other) const;
};

// The patch and one that it sees.
struct HemicubePair {
  std::shared_ptr<const HemicubeSight> sight;
  std::shared_ptr<const HemicubeRow> row;  // null: only the pixels are marked so far
  std::uint32_t item = no_item;            // with from_behind where the position sees its back
  std::vector<PixelEdge> outline;
  Picture others;  // dark over all other pixels of the cross
  // From the position alone:
  KnownFactor point;
  std::array<WeightedSum, names_of<PixelWeight>.size()> weighted{};
  NusseltProjection shadow;
  // From all of the patch; nothing before it is computed.
  struct Whole {
    double there = 0, back = 0;  // F_ij, F_ji
    KnownFactor known;
    double reciprocity = 0, relative = 0;  // |A_i F_ij - A_j F_ji|, m^2, and that over A_i F_ij (0 where that is 0)
  };
  std::optional<Whole> whole;

  std::uint32_t other() const { return item & ~from_behind; }
};

// What of it is on the graphics card.
struct HemicubeArt {
  Texture picture, others;
  std::shared_ptr<const HemicubeSight> sight;  // that they are of
  std::shared_ptr<const HemicubePair> pair;
};

class HemicubeDesk {
 public:
  // `wake` is called on another thread when there is something new.
  // `gl` draws the hemicubes that are OpenGL's; where it is null the software does.
  explicit HemicubeDesk(std::function<void()> wake, MakeDrawItems gl = {});

  // Once a frame while the panel is shown: asks for what is new. Sets the patch of the settings where they name none,
  // or one that the scene does not have; it stays where it is when the scene is divided in another way. `solution` may
  // be null.
  void update(const Scene& scene, const SolutionHandle& solution, Settings& settings);
  // The numbers of the settings are meant as they are, for the scene that comes.
  void forget_place() { place_.reset(), other_place_.reset(); }

  // What is there, of the newest that was asked for; null before.
  struct State {
    GroundHandle ground;
    std::shared_ptr<const HemicubeSight> sight;
    std::shared_ptr<const HemicubeRow> row;
    std::shared_ptr<const HemicubePair> pair;
    std::optional<Text> message;  // why there are no patches
    std::optional<Text> trouble;  // why what was asked for last is not drawn
  };
  const State& state() const { return shown_; }
  bool busy() const { return grounder_.busy() || viewer_.busy() || rower_.busy() || pairer_.busy(); }
  bool current() const { return current_; }  // the patches are those of the scene
  bool draws_by_gl() const { return gl_ != nullptr; }

  // The item that is asked about: the one under the mouse, the one chosen, or the patch that is seen best.
  std::uint32_t item(const Settings& settings) const;
  // Under the mouse in this frame, in a picture, the cross or the list: lit everywhere in the next.
  void point_at(std::uint32_t item) { next_pointed_ = item; }
  std::uint32_t pointed() const { return pointed_; }  // no_item: none
  // Once a frame; true where another one is lit now.
  bool turn_pointed();

  HemicubeArt art;
  double azimuth = -35, elevation = 26;  // degrees, from where the hemisphere is looked at

  // What of a scene its patches depend on.
  static Scene inputs_of(const Scene& scene);

 private:
  struct Place {
    int number;
    Patch patch;
  };
  Radiosity options_of(const Radiosity& r) const;
  void settle(const Scene& scene, Settings& settings);
  void ask_sight(const Scene& scene, const SolutionHandle& solution, const Settings& settings);
  void ask_row(const Scene& scene, const Settings& settings);
  void ask_pair(const Settings& settings);
  template <class T>
  void publish(std::shared_ptr<const T> State::*what, std::shared_ptr<const T> value);
  void make_ground(Scene inputs, Progress& progress);
  void make_pair(HemicubePair pair, Progress& progress);

  std::function<void()> wake_;
  const MakeDrawItems gl_;
  mutable std::mutex mutex_;  // guards what follows
  State newest_;
  // Of the window's thread alone.
  State shown_;
  bool current_ = false;
  std::optional<Scene> asked_inputs_;
  GroundHandle settled_;
  std::optional<Place> place_, other_place_;
  std::uint32_t pointed_ = no_item, next_pointed_ = no_item;
  struct SightKey {
    GroundHandle ground;
    std::uint32_t patch;
    std::size_t position;
    Radiosity options;
    HemicubeShow show;
    SolutionHandle solution;
    Display display;
    friend bool operator==(const SightKey&, const SightKey&) = default;
  };
  struct RowKey {
    GroundHandle ground;
    std::uint32_t patch;
    Radiosity options;
    friend bool operator==(const RowKey&, const RowKey&) = default;
  };
  struct PairKey {
    std::shared_ptr<const HemicubeSight> sight;
    std::shared_ptr<const HemicubeRow> row;
    std::uint32_t item;
    friend bool operator==(const PairKey&, const PairKey&) = default;
  };
  std::optional<SightKey> asked_sight_;
  std::optional<RowKey> asked_row_;
  std::optional<PairKey> asked_pair_;
  std::chrono::steady_clock::time_point row_since_, pair_since_;
  // Of the pairer's thread alone.
  std::shared_ptr<const AllWeights> weights_;
  Worker grounder_, viewer_, rower_, pairer_;  // last: they use what stands above
};

// Whether the panel is shown and something of it is still to come.
bool looks_at_hemicube(const App& app);

// The window's own, made at the first call. It must go while the window's OpenGL context is there.
HemicubeDesk& hemicube_of(App& app);

// The panel of the hemicube shows what a lesson's step wants, when it is opened.
void show_hemicube(App& app, const LessonView& view);

}  // namespace cg
