// What viewers do to a job's drape while it is under way, and what they want to know of it.

#include <utility>
#include <vector>

#include "server/jobs/kept_drape.h"
#include "server/jobs/runner.h"

namespace toile::jobs {

/// Those who held the cloth before have gone with their streams.
void JobRun::let_go_of_all() {
  const std::vector<drape::Grip> pulls = run_->session().hands().pulls;
  for (const drape::Grip& pull : pulls) {
    drape::Touch touch;
    touch.kind = drape::TouchKind::kLetGo;
    touch.id = pull.id;
    const Status done = run_->touch(touch);
    if (!done) context_.log.warn("a hand does not let go", done.error());
  }
}

void JobRun::take_touches(TouchInbox& hands) {
  for (const LiveTouch& wish : hands.take()) {
    const bool names = wish.epoch != 0 && wish.epoch != epoch_;
    const Status done =
        names ? Status(Error{"live.epoch", "the cloth has other triangles by now; look at it again", "",
                             ErrorKind::kStale})
              : run_->touch(wish.touch);
    if (!done && wish.refused) wish.refused(done.error());
    told_ = {};  // the next figures are told at once
  }
}

Result<std::string> JobRun::shape() const {
  if (!aside_) return shape_in_memory();
  const auto kept = TRY(place_.documents->store().checkpoint(context_, job_id_));
  return TRY(decode_kept(kept.bytes)).shape;
}

std::string JobRun::shape_in_memory() const {
  if (result_) return warm::encode_hung(result_->hung);
  const bool hangs = run_ && run_->session().progress().phase == "drape";
  return hangs ? warm::encode_hung(run_->hung()) : std::string();
}

JobProgress JobRun::touch_where_it_stands(TouchInbox& hands) {
  if (run_) take_touches(hands);
  read_figures();
  return progress_;
}

/// Who looks at what is paused sees where it is.
void JobRun::tell_where_it_stands(const RunControl& control) {
  told_ = {};
  const Progress p = run_->session().progress();
  tell(control, p.phase, p.fraction);
}

}  // namespace toile::jobs
