#include "core/pattern/seams/notch_cuts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/pattern/seams/bodice.h"
#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/kinds.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

bool same_length(double a, double b) {
  return std::abs(a - b) < std::max(kCutWeights.exact * std::max(a, b), kCutWeights.notch_mm);
}

/// Whether the run is drawn as another is, so that both have the same partners or their mirror images.
bool is_twin(const SeamModel& m, Index r, Index other) {
  const auto holds = [&](const std::vector<Index>& all) {
    return std::find(all.begin(), all.end(), other) != all.end();
  };
  return other == r || other == m.mirror[r] || holds(m.same[r]) ||
         (m.mirror[r] != kNone &&
          std::any_of(m.same[r].begin(), m.same[r].end(), [&](Index s) { return m.mirror[s] == other; }));
}

bool has_whole_partner(const SeamModel& m, Index r) {
  for (Index other = 0; other < static_cast<Index>(m.runs.size()); ++other)
    if (m.runs[other].panel != m.runs[r].panel && !is_twin(m, r, other) &&
        same_length(m.runs[other].length, m.runs[r].length) && !never_sewn(m, r, other))
      return true;
  return false;
}

/// Where parts of a run may end: its ends and its notches, mm from its start.
std::vector<double> stops_of(const SeamRun& run) {
  std::vector<double> stops{0};
  stops.insert(stops.end(), run.notches.begin(), run.notches.end());
  stops.push_back(run.length);
  return stops;
}

/// A run, or what of it lies between two of its stops.
struct RunPart {
  Index run = kNone;
  double length = 0;  ///< mm
  bool lonely = false;
};

std::vector<RunPart> parts_of(const SeamModel& m) {
  std::vector<RunPart> parts;
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r) {
    const bool lonely = !has_whole_partner(m, r);
    const std::vector<double> stops = stops_of(m.runs[r]);
    for (std::size_t j = 1; j < stops.size(); ++j)
      for (std::size_t i = 0; i < j; ++i) parts.push_back({r, stops[j] - stops[i], lonely});
  }
  return parts;
}

/// What the parts of a run between its notches are sewn to.
class NotchedRun {
 public:
  NotchedRun(const SeamModel& m, const std::vector<RunPart>& parts, Index r)
      : m_(m), parts_(parts), r_(r), needs_lonely_(has_whole_partner(m, r)), stops_(stops_of(m.runs[r])) {}

  /// The notches between which most of the run has a partner, of equal choices those with the fewest parts.
  std::vector<double> cuts() const {
    struct Best {
      double covered = 0;
      std::size_t from = 0;
      bool met = false;  ///< the part from `from` to here has a partner
    };
    if (goes_whole()) return {};
    std::vector<Best> best(stops_.size());
    for (std::size_t j = 1; j < stops_.size(); ++j) {
      best[j] = {best[j - 1].covered, j - 1, false};
      for (std::size_t i = 0; i < j; ++i) {
        const double part = stops_[j] - stops_[i];
        const bool whole = i == 0 && j + 1 == stops_.size();
        if (whole || best[i].covered + part <= best[j].covered || !is_met(part)) continue;
        best[j] = {best[i].covered + part, i, true};
      }
    }
    std::vector<double> found;
    for (std::size_t j = stops_.size() - 1; j > 0; j = best[j].from) {
      if (!best[j].met) continue;
      for (const std::size_t end : {best[j].from, j})
        if (end > 0 && end + 1 < stops_.size()) found.push_back(stops_[end]);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  /// Whether a part of another run, no whole one, is as long as all of it.
  bool goes_whole() const {
    return std::any_of(parts_.begin(), parts_.end(), [&](const RunPart& other) {
      const SeamRun& run = m_.runs[other.run];
      return run.panel != m_.runs[r_].panel && other.lonely && other.length < run.length &&
             same_length(other.length, stops_.back());
    });
  }
  bool is_met(double part) const {
    if (part < kCutWeights.least_part_mm) return false;
    return std::any_of(parts_.begin(), parts_.end(), [&](const RunPart& other) {
      return m_.runs[other.run].panel != m_.runs[r_].panel && (other.lonely || !needs_lonely_) &&
             same_length(other.length, part) && !is_neck_by_chance(other);
    });
  }

  /// Whether both are of the bodice, and the other is a neck, which goes to collars.
  bool is_neck_by_chance(const RunPart& other) const {
    return are_torsos(m_, r_, other.run) && is_neckline(m_, m_.runs[other.run]);
  }

  const SeamModel& m_;
  const std::vector<RunPart>& parts_;
  const Index r_;
  const bool needs_lonely_;
  const std::vector<double> stops_;
};

/// Whether the run is a leg's crotch: it goes to its mirror image, whatever flies and pockets mark on it.
bool is_crotch(const SeamModel& m, const SeamRun& run) {
  return m.words[run.panel].kind == PieceKind::kLegs && run.turn.back() < kPairWeights.twin_hollow_deg &&
         std::abs(run.up) < kPairWeights.facing;
}

}  // namespace

std::vector<std::vector<double>> notch_cuts(const SeamModel& m) {
  std::vector<std::vector<double>> cuts(m.runs.size());
  if (std::all_of(m.runs.begin(), m.runs.end(), [](const SeamRun& run) { return run.notches.empty(); }))
    return cuts;
  const std::vector<RunPart> parts = parts_of(m);
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r)
    if (!m.runs[r].notches.empty() && !is_crotch(m, m.runs[r])) cuts[r] = NotchedRun(m, parts, r).cuts();
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r) {
    const Index twin = m.mirror[r];  // left and right are sewn alike: a cut on one side alone is by chance
    if (twin != kNone && twin != r && cuts[r].empty()) cuts[twin].clear();
  }
  return cuts;
}

}  // namespace toile::seams
