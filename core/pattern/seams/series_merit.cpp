#include "core/pattern/seams/series_merit.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/seams/gluing.h"
#include "core/pattern/seams/round_stand.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

std::size_t meeting_corners(const SeamModel& m, const Chain& a, const Chain& b) {
  const std::vector<double> other = seen_from(m, a, b);
  const double near = meeting_distance(a.length);
  std::size_t met = 0;
  for (const double s : corners_of(m, a.runs))
    met += std::any_of(other.begin(), other.end(), [&](double x) { return std::abs(x - s) <= near; });
  return met;
}

/// Where a ring of gores is parted between the last and the first of them, by their numbers: −1 where the
/// chain runs from the last one to the first, as borders of pieces do that are seen from their right side, +1
/// where it runs from the first to the last; else 0.
int parted_at_first_gore(const SeamModel& m, const Chain& chain) {
  const auto row = [&](Index r) { return m.rows[m.runs[r].panel]; };
  const PieceRow start = row(chain.runs.front()), end = row(chain.runs.back());
  const bool gores = start.size > 2 && std::all_of(chain.runs.begin(), chain.runs.end(),
                                                   [&](Index r) { return row(r).row == start.row; });
  if (!gores) return 0;
  if (end.place == 0 && start.place == start.size - 1) return -1;
  return start.place == 0 && end.place == start.size - 1 ? 1 : 0;
}

/// Where the chain is parted between back and front: −1 where it begins with the front, +1 where it ends with
/// it, else 0.
int parted_at_side(const SeamModel& m, const Chain& chain) {
  const int start = m.words[m.runs[chain.runs.front()].panel].face;
  const int end = m.words[m.runs[chain.runs.back()].panel].face;
  return start * end < 0 ? end : 0;
}

/// Gores are counted to the right from a side seam, those of the front first.
bool gores_in_order(const SeamModel& m, const Chain& a, const Chain& b) {
  return parted_at_first_gore(m, a) * parted_at_side(m, b) > 0 ||
         parted_at_first_gore(m, b) * parted_at_side(m, a) > 0;
}

/// Whether the chain is its own mirror image.
bool is_symmetric(const SeamModel& m, const Chain& chain) {
  const std::size_t n = chain.runs.size();
  for (std::size_t k = 0; k < n; ++k)
    if (m.mirror[chain.runs[k]] != chain.runs[n - 1 - k]) return false;
  return true;
}

/// Whether all runs of the chain are of pieces of that kind.
bool is_of(const SeamModel& m, const Chain& chain, PieceKind kind) {
  return std::all_of(chain.runs.begin(), chain.runs.end(),
                     [&](Index r) { return m.words[m.runs[r].panel].kind == kind; });
}

/// Whether a hood's chain would end in the middle of the back, and its face lie there.
bool opens_behind(const SeamModel& m, const Chain& hood, const Chain& neck) {
  const auto is_back = [&](Index r) { return m.words[m.runs[r].panel].face < 0; };
  return is_of(m, hood, PieceKind::kHood) && is_of(m, neck, PieceKind::kTorso) &&
         is_back(neck.runs.front()) && is_back(neck.runs.back()) &&
         !std::all_of(neck.runs.begin(), neck.runs.end(), is_back);
}

/// Whether the chain goes through the front, the back and the front again, or the other way round.
bool leads_around(const SeamModel& m, const Chain& chain) {
  const auto face = [&](Index r) { return m.words[m.runs[r].panel].face; };
  const int end = face(chain.runs.front());
  return end != 0 &&
         std::any_of(chain.runs.begin(), chain.runs.end(), [&](Index r) { return face(r) == -end; });
}

/// Whether the chain runs around a point of a collar.
bool rounds_collar_point(const SeamModel& m, const Chain& chain) {
  for (std::size_t k = 1; k < chain.runs.size(); ++k) {
    const SeamRun &x = m.runs[chain.runs[k - 1]], &y = m.runs[chain.runs[k]];
    if (x.panel != y.panel || m.words[x.panel].kind != PieceKind::kCollar) continue;
    const SeamRun& later = m.runs[chain.runs[k - 1]].next == chain.runs[k] ? y : x;
    if (later.angle < kSeriesWeights.collar_point_deg) return true;
  }
  return false;
}

/// A collar lies as much to the left as to the right around the neck, and so does a hood of several pieces.
bool is_collar_on_neck(const SeamModel& m, const Chain& collar, const Chain& neck) {
  const bool fits = std::abs(collar.length - neck.length) < kSeriesWeights.collar_fits * neck.length;
  const bool one = collar.runs.size() == 1 && is_of(m, collar, PieceKind::kCollar);
  const bool hood = collar.runs.size() > 2 && is_of(m, collar, PieceKind::kHood) &&
                    m.words[m.runs[neck.runs.front()].panel].face > 0;  // its face lies in front
  return fits && (one || hood) && is_of(m, neck, PieceKind::kTorso) && leads_around(m, neck) &&
         is_symmetric(m, collar) && is_symmetric(m, neck);
}

/// The least that lengths say where one chain is a neckband and the other a neck: bands of rib are stretched
/// onto a longer one, and stands that are closed to a ring are longer by what their ends are buttoned over
/// each other. Nothing where they are none.
std::optional<double> band_on_neck(const SeamModel& m, const Chain& a, const Chain& b) {
  const auto is_band = [&](const Chain& chain) {
    return (chain.whole || is_symmetric(m, chain)) && chain.runs.size() == 1 &&
           is_of(m, chain, PieceKind::kCollar) && m.words[m.runs[chain.runs.front()].panel].stand;
  };
  const Chain &band = is_band(a) ? a : b, &neck = is_band(a) ? b : a;
  const bool collar = std::any_of(neck.runs.begin(), neck.runs.end(), [&](Index r) {
    return m.words[m.runs[r].panel].kind == PieceKind::kCollar;
  });
  if (!is_band(band) || !neck.whole || collar) return std::nullopt;
  const double ratio = band.length / neck.length;
  const double beyond = (band.length - neck.length) / 2;
  if (ratio > kSeriesWeights.rib_stretched && ratio < 1)
    return band.whole ? kSeriesWeights.rib_on_neck : kSeriesWeights.rib_along_neck;
  return band.whole && beyond > kSeriesWeights.overlap_least_mm && beyond < kSeriesWeights.overlap_most_mm
             ? std::optional(kSeriesWeights.stand_on_neck)
             : std::nullopt;
}

/// Whether one chain is a lower border all around and the other a longer upper one that meets it at both
/// sides: tiers of a skirt, which no names tell.
bool is_tier_on_tier(const SeamModel& m, const Chain& a, const Chain& b) {
  const auto level = [&](const Chain& chain, int faces) {
    return chain.whole && chain.runs.size() == 2 &&
           std::all_of(chain.runs.begin(), chain.runs.end(), [&](Index r) {
             return m.words[m.runs[r].panel].kind == PieceKind::kSkirt &&
                    faces * m.runs[r].up > kPairWeights.facing_fully;
           });
  };
  const Chain &upper = a.length < b.length ? a : b, &lower = a.length < b.length ? b : a;
  return m.nameless && level(upper, -1) && level(lower, 1) && meeting_corners(m, a, b) == 1;
}

/// Whether the chain is the lower border of a bodice, all around.
bool is_waist_of_bodice(const SeamModel& m, const Chain& chain) {
  using enum PieceKind;
  return chain.whole && std::all_of(chain.runs.begin(), chain.runs.end(), [&](Index r) {
           const PieceWords& words = m.words[m.runs[r].panel];
           const bool unnamed = words.kind == kOther && words.face != 0;
           return (words.kind == kTorso || unnamed) && !words.layer && m.runs[r].up < -kPairWeights.facing;
         });
}

/// The least that lengths say where one chain is a waistband or a bodice's waist all around and the other the
/// upper edge of a skirt about twice as long, as it is where it is gathered, or its pleats are drawn open.
/// Nothing where that is none.
std::optional<double> gathered_below(const SeamModel& m, const Chain& a, const Chain& b) {
  const Chain &waist = a.length < b.length ? a : b, &skirt = a.length < b.length ? b : a;
  const auto is_upper = [&](Index r) { return m.runs[r].up > kPairWeights.facing; };
  const bool holds = (waist.whole && is_of(m, waist, PieceKind::kBand)) || is_waist_of_bodice(m, waist);
  const bool fits = holds && skirt.whole && is_of(m, skirt, PieceKind::kSkirt) &&
                    std::all_of(skirt.runs.begin(), skirt.runs.end(), is_upper) &&
                    skirt.length < kSeriesWeights.ratio_gathered * waist.length;
  return fits ? std::optional(kSeriesWeights.gathered_below) : std::nullopt;
}

/// Whether all runs of the chain are of the bodice or of its yoke.
bool is_of_bodice(const SeamModel& m, const Chain& chain) {
  return std::all_of(chain.runs.begin(), chain.runs.end(), [&](Index r) {
    const PieceWords& words = m.words[m.runs[r].panel];
    return words.kind == PieceKind::kTorso || words.yoke;
  });
}

/// Corners of the neck that notches of the collar meet where both lie around the middle of the back: a collar
/// may end before the neck does.
std::size_t collar_notches_met(const SeamModel& m, const Chain& collar, const Chain& neck) {
  if (collar.runs.size() != 1 || neck.runs.size() < 2 || !is_of(m, collar, PieceKind::kCollar)) return 0;
  const std::vector<double> corners = corners_of(m, neck.runs);
  const std::vector<double>& notches = m.runs[collar.runs.front()].notches;
  return static_cast<std::size_t>(std::count_if(notches.begin(), notches.end(), [&](double n) {
    return std::any_of(corners.begin(), corners.end(), [&](double c) {
      return std::abs((n - collar.length / 2) - (c - neck.length / 2)) < kSeriesWeights.notch_from_middle_mm;
    });
  }));
}

}  // namespace

bool are_of_two_cuffs(const SeamModel& m, const Chain& a, const Chain& b) {
  const auto is_whole_cuff = [&](const Chain& chain) {
    return is_of(m, chain, PieceKind::kCuff) && m.words[m.runs[chain.runs.front()].panel].face == 0;
  };
  return is_whole_cuff(a) && is_whole_cuff(b);
}

std::optional<double> beyond_collar(const SeamModel& m, const Chain& collar, const Chain& neck) {
  const double beyond = (neck.length - collar.length) / 2;
  if (beyond < kSeriesWeights.overlap_least_mm || beyond > kSeriesWeights.overlap_most_mm ||
      !is_of(m, collar, PieceKind::kCollar) || !is_symmetric(m, collar) || !is_symmetric(m, neck))
    return std::nullopt;
  if (std::all_of(neck.runs.begin(), neck.runs.end(),
                  [&](Index r) { return round_stand_edge(m, m.runs[r]) > 0; }))
    return is_inner_of_collar(m, collar.runs) ? std::optional(beyond) : std::nullopt;
  if (collar.runs.size() != 1 || neck.runs.size() < 3 || !is_of_bodice(m, neck)) return std::nullopt;
  if (m.words[m.runs[collar.runs.front()].panel].stand) return std::nullopt;  // ribs are stretched on
  const Index front = m.runs[neck.runs.front()].panel, other = m.runs[neck.runs.back()].panel;
  const bool opens = front != other && m.twin[front] == other && m.words[front].face >= 0;
  const double least = std::min(m.runs[neck.runs.front()].length, m.runs[collar.runs.front()].length);
  return opens && 2 * beyond < least ? std::optional(beyond) : std::nullopt;
}

bool lengths_fit(const SeamModel& m, const Chain& a, const Chain& b) {
  const double ratio = std::max(a.length, b.length) / std::min(a.length, b.length);
  return ratio <= (a.whole && b.whole ? kSeriesWeights.ratio_whole : kSeriesWeights.ratio) ||
         gathered_below(m, a, b) || band_on_neck(m, a, b);
}

double series_merit(const SeamModel& m, const Chain& a, const Chain& b) {
  double merit = length_merit(a.length, b.length);
  merit = std::max(merit, band_on_neck(m, a, b).value_or(merit));
  merit = std::max(merit, gathered_below(m, a, b).value_or(merit));
  if (is_tier_on_tier(m, a, b)) merit = std::max(merit, kSeriesWeights.tier_on_tier);
  if (a.whole && b.whole && gores_in_order(m, a, b)) merit += kSeriesWeights.gores_in_order;
  merit += std::min(kSeriesWeights.corners_most,
                    kSeriesWeights.corner * static_cast<double>(meeting_corners(m, a, b)));
  merit +=
      kSeriesWeights.corner * static_cast<double>(collar_notches_met(m, a, b) + collar_notches_met(m, b, a));
  if (a.whole && b.whole) merit += kSeriesWeights.whole_borders;
  if (is_collar_on_neck(m, a, b) || is_collar_on_neck(m, b, a)) merit += kSeriesWeights.collar_on_neck;
  if (opens_behind(m, a, b) || opens_behind(m, b, a)) merit += kSeriesWeights.hood_behind;
  if (rounds_collar_point(m, a) || rounds_collar_point(m, b)) merit += kSeriesWeights.round_collar_point;
  return merit;
}

}  // namespace toile::seams
