// "Match this picture": a target whose parameters are hidden, its picture, and how near the student's scene comes to
// it. Pictures and scores are made on threads of their own.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/mailbox.h"
#include "ui/texture.h"
#include "workbench/challenge.h"
#include "workbench/job.h"
#include "workbench/scene_differences.h"
#include "workbench/score.h"

namespace cg {

struct App;

class ChallengeGame {
 public:
  explicit ChallengeGame(std::function<void()> wake);

  // Begins: the student's scene is set to where it starts, one step of undo. The program makes the target up from the
  // scene's models and camera,
  void make_up(App& app, std::uint64_t seed, int level);
  // or it is the scene as it stands,
  void from_scene(App& app);
  // or a file: a preset, a model or a shape. The user is told where it cannot be opened.
  void from_file(App& app, const std::string& what);
  // The parameters that differ are shown.
  void give_up(const App& app);
  void end() { challenge_.reset(); }

  bool playing() const { return challenge_.has_value(); }
  bool given_up() const { return given_up_; }
  bool solved() const { return score_ && score_->value >= solved_at; }
  std::uint64_t seed() const { return seed_; }  // 0: it was not made up
  int level() const { return level_; }
  const std::vector<std::string>& offered() const { return challenge_->offered; }
  const std::optional<Score>& score() const { return score_; }  // of the scene as it was a moment ago
  double best() const { return best_; }
  const std::vector<ParameterDifference>& differences() const { return differences_; }
  bool hint = false;     // the student asked for it
  int wanted_level = 1;  // of the next one that is made up
  std::string typed;     // the file of a target

  // The target's picture; needs the window's OpenGL context. Empty before it is drawn.
  const Texture& picture() const { return texture_; }

  // Once a frame: gives work away and takes what is there.
  void update(App& app);

 private:
  struct Scored {
    std::uint64_t game = 0;
    std::optional<Score> score;
    std::optional<Text> problem;
  };
  void begin(App& app, Challenge challenge);

  static constexpr double solved_at = 99.5;
  static constexpr int picture_side = 512;

  std::function<void()> wake_;
  std::optional<Challenge> challenge_;
  std::uint64_t game_ = 0;  // counts them, so that a late score of the last is not taken
  std::uint64_t seed_ = 0;
  int level_ = 1;
  bool given_up_ = false;
  std::optional<Score> score_;
  double best_ = 0;
  std::vector<ParameterDifference> differences_;
  std::optional<Scene> scored_;  // the scene that the score is asked for
  Texture texture_;
  DrawingHandle shown_;
  Mailbox<Scored> mail_;
  std::unique_ptr<Job> job_;  // draws the target
  Worker scorer_;             // last: it uses the mailbox
};

// The window's own, made at the first call. It must go while the window's OpenGL context is there.
ChallengeGame& game_of(App& app);

}  // namespace cg
