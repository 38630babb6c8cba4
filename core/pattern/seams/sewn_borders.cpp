#include "core/pattern/seams/sewn_borders.h"

#include <algorithm>

#include "core/pattern/seams/armholes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

/// How long the hem of the bodice's pieces is, mm, told by their widths across the grain; 0 where there is no
/// front or no back, or no telling which way a piece lies.
double torso_girth(const SeamModel& m) {
  double girth = 0;
  bool front = false, back = false;
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p) {
    if (m.words[p].kind != PieceKind::kTorso) continue;
    if (!m.upright[p]) return 0;
    double low = 1e30, high = -1e30;
    for (const SeamRun& run : m.runs) {
      if (run.panel != p) continue;
      for (const Vec2& at : run.at) {
        low = std::min(low, cross(m.up[p], at));
        high = std::max(high, cross(m.up[p], at));
      }
    }
    girth += high - low;
    front = front || m.words[p].face > 0;
    back = back || m.words[p].face < 0;
  }
  return front && back ? girth : 0;
}

/// What a border of the bodice alone measures at least, mm.
double least_border(const SeamModel& m) {
  const bool wrists = std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) {
    return m.words[run.panel].kind == PieceKind::kTorso && run.up < -kPairWeights.facing &&
           is_below_arm(m, run);
  });
  return std::min(kGarmentWeights.narrow_share * torso_girth(m),
                  wrists ? kGarmentWeights.wrist_mm : kGarmentWeights.narrow_most_mm);
}

}  // namespace

SewnBorders::SewnBorders(const SeamModel& model)
    : m_(model),
      least_(least_border(model)),
      first_(model.runs.size(), kNone),
      narrow_(model.runs.size(), 0),
      renewed_(model.runs.size(), 0) {
  const SewnPoints unsewn(model);
  for (Index r = 0; r < static_cast<Index>(first_.size()); ++r)
    if (first_[r] == kNone) gather(unsewn, r);
  renewed_.assign(renewed_.size(), 0);
  renewed_list_.clear();
}

/// The border that the run stands for is none any more, if it stands for one.
void SewnBorders::forget(Index r) {
  if (first_[r] != r) return;
  --count_;
  narrow_count_ -= narrow_[r];
}

void SewnBorders::leave(Index r) {
  forget(r);
  first_[r] = kNone;
}

/// Whether the border in `border_` is one of the bodice alone that no head or arm passes through.
bool SewnBorders::is_narrow() const {
  const auto is_torso = [&](Index r) { return m_.words[m_.runs[r].panel].kind == PieceKind::kTorso; };
  if (least_ == 0 || !std::all_of(border_.begin(), border_.end(), is_torso)) return false;
  double length = 0;
  for (const Index r : border_) length += m_.runs[r].length;
  return length > 0 && length < least_;
}

/// Finds what comes together with free run r to one border.
void SewnBorders::gather(const SewnPoints& points, Index r) {
  border_.assign(1, r);
  renewed_[r] = 1;
  ends_.assign({SewnPoints::start_of(r), SewnPoints::end_of(r)});
  while (!ends_.empty()) {
    const Index end = ends_.back();
    ends_.pop_back();
    for (Index other = points.next_free(end); other != end; other = points.next_free(other)) {
      const Index run = SewnPoints::run_of(other);
      if (renewed_[run]) continue;
      renewed_[run] = 1;
      border_.push_back(run);
      ends_.push_back(SewnPoints::opposite(other));  // all that lie at this one are on the way
    }
  }
  std::sort(border_.begin(), border_.end());  // lengths are summed in the runs' order
  for (const Index run : border_) {
    forget(run);
    first_[run] = border_.front();
  }
  ++count_;
  narrow_[border_.front()] = is_narrow();
  narrow_count_ += narrow_[border_.front()];
  renewed_list_.insert(renewed_list_.end(), border_.begin(), border_.end());
}

void SewnBorders::renew(const SewnPoints& points) {
  for (const Index end : points.renewed_free())
    if (const Index r = SewnPoints::run_of(end); !renewed_[r]) gather(points, r);
  for (const Index r : renewed_list_) renewed_[r] = 0;
  renewed_list_.clear();
}

}  // namespace toile::seams
