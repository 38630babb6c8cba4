#include "core/pattern/seams/sewn_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

double inner_merit(double angle) {
  constexpr double flat = kGarmentWeights.inner_flat_deg, fair = kGarmentWeights.inner_fair_deg;
  const double off = std::abs(angle - 360);
  if (off <= flat) return kGarmentWeights.inner;
  if (off <= fair) return kGarmentWeights.inner * (fair - off) / (fair - flat);
  return (off - fair) / 100 * (angle < 360 ? kGarmentWeights.inner_cone : kGarmentWeights.inner_ruffle);
}

double border_merit(double angle) {
  constexpr double straight = kGarmentWeights.border_straight_deg, fair = kGarmentWeights.border_fair_deg;
  const double off = std::abs(angle - 180);
  if (off <= straight) return kGarmentWeights.border;
  if (off <= fair) return kGarmentWeights.border * (fair - off) / (fair - straight);
  return std::max(angle > 180 ? kGarmentWeights.border_slit : kGarmentWeights.border_corner,
                  (off - fair) / 100 * kGarmentWeights.border_bent);
}

}  // namespace

SewnPoints::SewnPoints(const SeamModel& model)
    : joined_to_(model.runs.size(), kNone),
      next_free_(2 * model.runs.size()),
      root_(model.runs.size()),
      lies_(model.runs.size(), 0),
      shuts_arm_(model.runs.size(), 0),
      count_(static_cast<int>(model.runs.size())),
      renewed_(model.runs.size(), 0) {
  std::iota(root_.begin(), root_.end(), Index{0});
  for (const SeamRun& run : model.runs) {
    const PieceWords& words = model.words[run.panel];
    runs_.push_back({run.next, kNone});
    angle_.push_back(run.angle);
    const bool trunk = words.kind == PieceKind::kTorso && words.face != 0;
    const int lies_on = trunk ? (words.face > 0 ? kFront : kBack) : kOther;
    traits_.push_back(static_cast<unsigned char>((run.from > 0 ? kCut : 0) |
                                                 (words.kind == PieceKind::kLegs ? kLegs : 0) | lies_on));
  }
  for (Index r = 0; r < static_cast<Index>(runs_.size()); ++r) {
    const Index next = runs_[r].next;
    runs_[next].before = r;
    next_free_[end_of(r)] = start_of(next);
    next_free_[start_of(next)] = end_of(r);
  }
}

void SewnPoints::join(Index r, const Joint& joint) {
  changed_.push_back(r);
  if (runs_[r].joint.other == kNone)
    runs_[r].joint = joint;
  else
    more_.push_back({r, joint});
}

void SewnPoints::part(Index r, Index other) {
  changed_.push_back(r);
  const auto another = [&](auto&& is) { return std::find_if(more_.begin(), more_.end(), is); };
  Joint& first = runs_[r].joint;
  if (first.other != other) {
    more_.erase(another([&](const MoreJoint& m) { return m.run == r && m.joint.other == other; }));
    return;
  }
  first = {};
  const auto next = another([&](const MoreJoint& m) { return m.run == r; });
  if (next == more_.end()) return;
  first = next->joint;
  more_.erase(next);
}

void SewnPoints::sew(Index r, Index partner, bool along) {
  Index& joined_to = joined_to_[r];
  if (joined_to != kNone) {
    part(r, joined_to);
    part(joined_to, r);
  }
  joined_to = partner > r ? partner : kNone;
  if (joined_to != kNone) {
    join(r, {joined_to, along});
    join(joined_to, {r, along});
  }
  runs_[r].free = partner == kNone;
  changed_.push_back(r);
}

void SewnPoints::gather_corner(Index corner) {
  if (renewed_[corner]) return;
  renewed_[corner] = 1;
  point_.push_back(corner);
}

/// Gathers the corners whose ends are sewn to this one, or that as a free end.
void SewnPoints::gather(Index end) {
  const Run& run = runs_[run_of(end)];
  if (run.free) free_.push_back(end);
  if (run.joint.other != kNone) gather_corner(corner_of(met_by(end, run.joint)));
  for (const MoreJoint& more : more_)
    if (more.run == run_of(end)) gather_corner(corner_of(met_by(end, more.joint)));
}

/// The merit of the point whose corners and free ends are in `point_` and `free_`.
void SewnPoints::judge_point() {
  double angle = 0;
  unsigned traits = 0;
  for (const Index corner : point_) {
    angle += angle_[corner];
    traits |= traits_[corner];
  }
  const bool inner = free_.empty();
  if (inner && (traits & kLegs) != 0 && angle < 360) return;  // legs end sharply where they meet
  const double here = inner ? inner_merit(angle) : point_.size() > 1 ? border_merit(angle) : 0;
  const Index root = point_.front();
  // A cut is no corner of the drawing: it proves nothing.
  lies_[root] = (traits & kCut) != 0 ? std::min(0.0, here) : here;
  shuts_arm_[root] = inner && (traits & (kFront | kBack | kOther)) == (kFront | kBack) &&
                     angle < kGarmentWeights.arm_shut_deg;
}

void SewnPoints::renew_point(Index corner) {
  point_.clear();
  free_.clear();
  gather_corner(corner);
  for (std::size_t k = 0; k < point_.size(); ++k) {
    gather(start_of(point_[k]));
    gather(end_of(runs_[point_[k]].before));
  }
  for (std::size_t k = 0; k < free_.size(); ++k) next_free_[free_[k]] = free_[(k + 1) % free_.size()];
  std::sort(point_.begin(), point_.end());  // angles are summed in the runs' order
  for (const Index other : point_) {
    count_ -= root_[other] == other;
    root_[other] = point_.front();
    lies_[other] = 0;
    shuts_arm_[other] = 0;
  }
  renewed_list_.insert(renewed_list_.end(), point_.begin(), point_.end());
  renewed_free_.insert(renewed_free_.end(), free_.begin(), free_.end());
  ++count_;
  judge_point();
}

void SewnPoints::renew() {
  renewed_free_.clear();
  for (const Index r : changed_)
    for (const Index corner : {r, runs_[r].next})
      if (!renewed_[corner]) renew_point(corner);
  for (const Index corner : renewed_list_) renewed_[corner] = 0;
  renewed_list_.clear();
  changed_.clear();
}

double SewnPoints::merit() const {
  double merit = 0;
  for (std::size_t i = 0; i < lies_.size(); ++i) {
    if (shuts_arm_[i]) merit += kGarmentWeights.arm_shut;
    merit += lies_[i];
  }
  return merit;
}

}  // namespace toile::seams
