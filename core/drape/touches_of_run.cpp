// Hands on the cloth of a run, as they come and as a log has them.

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/check.h"
#include "core/drape/hands.h"
#include "core/drape/pipeline.h"

namespace toile::drape {

Status DrapeRun::touch(const Touch& touch) {
  if (ended_badly_)
    return Error{"live.busy", "the garment is about to be put on anew; try again when it drapes", "",
                 ErrorKind::kConflict};
  return session_->touch(touch);
}

Status DrapeRun::replay(std::vector<Touch> touches) {
  TOILE_CHECK(session_->steps() == 0);
  if (!touches.empty() && input().settings.method == DrapeMethod::kPaper) return session_->touch(touches[0]);
  TRY(check_touches(touches, session_->garment()));
  if (touches.empty()) return {};
  const std::vector<Touch>& done = session_->hands().log;
  if (touches.size() < done.size() || !std::equal(done.begin(), done.end(), touches.begin()))
    return Error{"live.order", "the log does not begin with the pins that the garment hung by before",
                 "touch 0"};
  to_replay_ = std::move(touches);
  replayed_ = done.size();
  return {};
}

void DrapeRun::touch_again() {
  for (; replayed_ < to_replay_.size() && to_replay_[replayed_].step <= session_->steps(); ++replayed_) {
    const Status taken = session_->touch(to_replay_[replayed_]);
    TOILE_CHECK(taken.ok());  // the log was looked through before
  }
}

/// What the input alone does not tell of how the cloth hangs.
void DrapeRun::tell_touches(DrapeResult& result) const {
  const auto count = [&](TouchKind kind) {
    return std::count_if(result.touches.begin(), result.touches.end(), [kind](const Touch& touch) {
      return touch.kind == kind && (kind != TouchKind::kPull || touch.at.triangle != kNone);
    });
  };
  if (result.touches.empty()) return;
  const auto pulls = count(TouchKind::kPull), pins = count(TouchKind::kPin);
  result.findings.push_back(preflight::found(
      preflight::FindingKind::kTouched,
      "hands were on the cloth while it draped (pulls: " + std::to_string(pulls) +
          ", pins set: " + std::to_string(pins) + "); drape.log has them, and drapes the same again",
      {}, {}));
}

}  // namespace toile::drape
