#include "ui/challenge_game.h"

#include "raster/software.h"
#include "ui/app.h"
#include "workbench/open.h"

namespace cg {

ChallengeGame::ChallengeGame(std::function<void()> wake) : wake_(wake ? std::move(wake) : [] {}) {}

void ChallengeGame::begin(App& app, Challenge challenge) {
  ++game_;
  challenge_ = std::move(challenge);
  given_up_ = hint = false;
  score_.reset(), scored_.reset(), differences_.clear();
  best_ = 0;
  shown_ = nullptr;
  app.history.end_gesture();
  app.scene = challenge_->start;
  app.history.change(app.scene);
  app.light = app.object = 0;
  app.isolated = {};
  if (!job_) job_ = std::make_unique<Job>(software_technique(), Job::Hooks{load_meshes, wake_});
  Request request;
  request.scene = challenge_->target;
  request.view.width = request.view.height = picture_side;
  job_->submit(std::move(request));
}

void ChallengeGame::make_up(App& app, std::uint64_t seed, int level) {
  seed_ = seed;
  level_ = level;
  begin(app, made_up_challenge(app.scene, seed, level));
}

void ChallengeGame::from_scene(App& app) {
  seed_ = 0;
  begin(app, challenge_of(app.scene));
}

void ChallengeGame::from_file(App& app, const std::string& what) {
  app.errands->run(app, [what]() -> Errands::Done {
    auto challenge = std::make_shared<Challenge>(challenge_of(open_scene(what)));
    return [challenge](App& a) {
      ChallengeGame& game = game_of(a);
      game.seed_ = 0;
      game.begin(a, std::move(*challenge));
    };
  });
}

void ChallengeGame::give_up(const App& app) {
  if (!challenge_) return;
  given_up_ = true;
  differences_ = scene_differences(app.scene, challenge_->target);
}

void ChallengeGame::update(App& app) {
  if (!challenge_) return;
  if (const Job::State state = job_->poll(); state.drawing && state.drawing != shown_ && state.answered > 0) {
    shown_ = state.drawing;
    texture_.upload(shown_->shown);
  }
  if (auto scored = mail_.take(); scored && scored->game == game_) {
    score_ = scored->score;
    if (score_ && !given_up_) best_ = std::max(best_, score_->value);
  }
  if (given_up_) differences_ = scene_differences(app.scene, challenge_->target);
  if (scored_ && *scored_ == app.scene) return;
  if (scorer_.busy()) {
    app.next_frame = std::min(app.next_frame, app.now + 0.05);
    return;
  }
  scored_ = app.scene;
  scorer_.submit([this, game = game_, student = app.scene, target = challenge_->target](Progress& progress) {
    Scored out{game, {}, {}};
    try {
      out.score = cg::score(student, target, software_technique(), progress);
    } catch (const InputError& e) {
      out.problem = Text(e.message(Language::english), e.message(Language::japanese));
    }
    mail_.put(std::move(out));
    wake_();
  });
}

ChallengeGame& game_of(App& app) {
  if (!app.challenge) app.challenge = std::make_shared<ChallengeGame>(app.wake);
  return *app.challenge;
}

}  // namespace cg
