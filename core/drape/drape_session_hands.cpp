// Hands on a drape under way.

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/drape/drape_session.h"

namespace toile::drape {

namespace {

/// Hands are as strong as they are, whatever the gravity of a drape.
constexpr double kGravity = 9.81;  // m/s²

}  // namespace

Status Session::touch(const Touch&) {
  return Error{"live.method", "a drape by the paper's method takes no hands; toile's own does", ""};
}

const HandsState& Session::hands() const {
  static const HandsState none;
  return none;
}

/// What a hand did is followed by as much time as the drape had to come to rest.
Status DrapeSession::touch(const Touch& touch) {
  if (phase_ == Phase::kDone)
    return Error{"live.over", "the cloth has come to rest; hands are for cloth that drapes", "",
                 ErrorKind::kConflict};
  const std::size_t pulls = hands_.state().pulls.size(), pins = hands_.state().pins.size();
  Touch now = touch;
  now.step = steps_;
  TRY(hands_.take(now, assembly_.garment, positions()));
  if (hands_.state().pulls.size() == pulls && hands_.state().pins.size() == pins) return {};
  solver_->set_leashes(leashes_now());
  probe_.restart();
  watch_.restart(solver_->positions());
  if (hands_.pulling()) return {};
  if (phase_ == Phase::kSew) phase_start_ = std::max(phase_start_, time_ - sew_time());
  if (input_.settings.until_settled && !dynamic()) begun_ = time_;
  return {};
}

void DrapeSession::lead_by_hands() {
  if (!hands_.follow(input_.settings.time_step)) return;
  std::vector<solver::constraints::Leash> leashes = solver_->features().leashes;
  hands_.aim(leashes);
  solver_->set_leashes(std::move(leashes));
}

std::vector<solver::constraints::Leash> DrapeSession::leashes_now() const {
  if (hands_.idle()) return {};
  const std::vector<double>& mass = solver_->model().mass;
  const double weight = std::accumulate(mass.begin(), mass.end(), 0.0) * kGravity;
  return hands_.leashes(assembly_.garment, vertex_of_, weight);
}

/// A drape that ends at rest does not end while somebody pulls, and has its time once they let go.
bool DrapeSession::waits_for_hands() const {
  return hands_.pulling() && input_.settings.until_settled && !dynamic();
}

}  // namespace toile::drape
