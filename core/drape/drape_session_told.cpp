// What a session tells of itself, and what it remembers.

#include <algorithm>
#include <utility>

#include "core/drape/drape_session.h"
#include "core/drape/make_features.h"
#include "core/drape/seam_gaps.h"

namespace toile::drape {

bool DrapeSession::lost_seams() const { return std::find(lost_.begin(), lost_.end(), true) != lost_.end(); }

SessionState DrapeSession::state() const {
  std::vector<bool> joined(vertex_of_.size());
  for (std::size_t i = 0; i < joined.size(); ++i) {
    joined[i] = vertex_of_[i] == vertex_of_[assembly_.garment.weld[i]];
  }
  return {phase_,
          began_,
          lost_,
          stop_reason_,
          steps_,
          time_,
          begun_,
          phase_start_,
          last_weld_,
          slackened_,
          joined,
          released_,
          off_at_release_,
          watch_.state(),
          solver_->state(),
          probe_.state(),
          motion_.state(),
          hands_.state(),
          {}};
}

Status DrapeSession::restore(SessionState state) {
  if (state.joined.size() != vertex_of_.size() || state.lost.size() != lost_.size() ||
      !is_sound(state.hands, assembly_.garment) || state.released.size() != released_.size() ||
      state.off_at_release.size() != released_.size()) {
    return damaged_checkpoint();
  }
  const Weld weld = joined_as(assembly_.garment, state.joined);
  const auto count = static_cast<std::size_t>(weld.vertex_count);
  if (state.solver.positions.size() != count ||
      state.solver.preloads.size() != assembly_.garment.triangles.size()) {
    return damaged_checkpoint();
  }
  vertex_of_ = weld.vertex_of;
  began_ = state.began;
  lost_ = state.lost;
  released_ = state.released;
  off_at_release_ = state.off_at_release;
  hands_.restore(std::move(state.hands));
  build_solver(model_of(vertex_of_, weld.vertex_count), state.solver.positions, {});
  solver_->set_stitches(stitches_now());
  watch_.restore(std::move(state.watch));
  probe_.restore(std::move(state.probe));
  motion_.restore(state.motion, solver_->model(), obstacles_);
  solver_->set_features(features_now());
  solver_->restore(std::move(state.solver));  // among the bodies as they were
  bodies_moved_ = true;
  phase_ = state.phase;
  stop_reason_ = std::move(state.stop_reason);
  if (stop_reason_)
    stop_reason_->gap = gap_at(stop_reason_->kind);  // no checkpoint keeps what positions tell
  steps_ = state.steps;
  time_ = state.time;
  begun_ = state.begun;
  phase_start_ = state.phase_start;
  last_weld_ = state.last_weld;
  slackened_ = state.slackened;
  return {};
}

Progress DrapeSession::progress() const {
  const double since = time_ - phase_start_;
  if (phase_ == Phase::kSew) return {"sew", std::min(1.0, since / sew_time())};
  if (phase_ == Phase::kDone) return {"drape", 1};
  if (motion_.is_going()) return {"move", motion_.share()};
  const double left = std::max(1e-3, begun_ + input_.settings.max_time - phase_start_);
  return {"drape", std::min(1.0, since / left)};
}

std::vector<std::vector<Vec3>> DrapeSession::moved_bodies() const {
  std::vector<std::vector<Vec3>> moved(input_.bodies.size());
  for (std::size_t b = 0; b < moved.size(); ++b) {
    if (motion_.moves(b)) moved[b] = motion_.vertices(b);
  }
  return moved;
}

MotionFigures DrapeSession::motion() const {
  MotionFigures figures{
      motion_.is_whole(), motion_.share(), motion_.state().played, motion_.state().waited, kNone, 0, {}};
  const Index tight = motion_.state().tight;
  if (figures.whole || tight == kNone) return figures;
  figures.place = solver_->positions()[tight];
  figures.way_left = motion_.way_left_near(figures.place);
  const auto at = std::find(vertex_of_.begin(), vertex_of_.end(), tight);
  figures.panel = assembly_.garment.panel_of_vertex[static_cast<std::size_t>(at - vertex_of_.begin())];
  return figures;
}

CrossingCount DrapeSession::count_crossings(Crew& crew) {
  if (std::exchange(bodies_moved_, false)) {
    const std::vector<std::vector<Vec3>> moved = moved_bodies();
    for (std::size_t b = 0; b < moved.size(); ++b) {
      if (motion_.moves(b)) crossings_.move_body(b, moved[b]);
    }
  }
  return crossings_.count(positions(), crew);
}

solver::constraints::OpenTie DrapeSession::open_button() const {
  return solver::constraints::widest_tie(solver_->features().ties, solver_->positions());
}

/// m, how far open the seam or button is that a stop is about, as the cloth lies now.
double DrapeSession::gap_at(Stop kind) const {
  if (!has_name(kind)) return 0;
  return kind == Stop::kOpenButton ? open_button().excess : seam_gap();
}

std::vector<HoldFigures> DrapeSession::holds() const {
  const std::vector<Vec3> x = positions();
  std::vector<HoldFigures> figures;
  for (std::size_t a = 0; a < released_.size(); ++a) {
    HoldFigures hold{released_[a], 0, off_at_release_[a]};
    if (hold.released) hold.released_at = time_of_full_gravity() + input_.attachments[a].release_after;
    if (!hold.released) hold.off = off_hold(input_, assembly_, a, x);
    figures.push_back(hold);
  }
  return figures;
}

std::array<bool, 2> DrapeSession::held_on_shoulders() const {
  std::array<bool, 2> held{};
  const std::vector<solver::constraints::ShoulderHold>& holds = solver_->features().shoulders;
  for (std::size_t side = 0; side < holds.size(); ++side)
    held.at(side) = solver::constraints::bears(holds[side], solver_->positions());
  return held;
}

std::vector<double> DrapeSession::pair_gaps() const {
  return drape::pair_gaps(assembly_.garment, positions());
}

double DrapeSession::seam_gap() const { return largest_gap(pair_gaps()); }

std::vector<OpenSeam> DrapeSession::open_seams() const {
  return seams_open(input_, assembly_.garment, pair_gaps());
}

std::vector<Vec3> DrapeSession::positions() const {
  std::vector<Vec3> out;
  out.reserve(vertex_of_.size());
  for (const Index v : vertex_of_) out.push_back(solver_->positions()[v]);
  return out;
}

}  // namespace toile::drape
