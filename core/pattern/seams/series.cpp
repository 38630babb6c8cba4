#include "core/pattern/seams/series.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/pattern/seams/round_stand.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

constexpr std::size_t kLongest = 8;       // runs on a side, if it is not a whole border
constexpr std::size_t kMostTrials = 150;  // that are looked at closely, at a time

/// Free runs one after the other along a border.
struct Chain {
  std::size_t border = 0, first = 0;
  std::vector<Index> runs;
  double length = 0;
  bool whole = false;  ///< all of its border
};

struct Trial {
  std::size_t a, b;
  double worth;
  double beyond = 0;  ///< mm that each end of the longer chain goes on beyond the shorter one
};

std::vector<Chain> chains_of(const SeamModel& m, const std::vector<std::vector<Index>>& borders,
                             const std::vector<char>& locked) {
  std::vector<Chain> chains;
  for (std::size_t l = 0; l < borders.size(); ++l) {
    const std::size_t n = borders[l].size();
    for (std::size_t first = 0; first < n; ++first) {
      Chain chain{l, first, {}, 0, false};
      for (std::size_t k = 0; k < n; ++k) {
        const Index r = borders[l][(first + k) % n];
        if (m.runs[r].fold || (r < static_cast<Index>(locked.size()) && locked[r])) break;
        chain.runs.push_back(r);
        chain.length += m.runs[r].length;
        chain.whole = k + 1 == n;
        if (k < kLongest || chain.whole) chains.push_back(chain);
      }
    }
  }
  return chains;
}

bool overlap(const Chain& a, const Chain& b) {
  return a.border == b.border && std::any_of(a.runs.begin(), a.runs.end(), [&](Index r) {
           return std::find(b.runs.begin(), b.runs.end(), r) != b.runs.end();
         });
}

/// Distances of the inner corners from the chain's start.
std::vector<double> corners_of(const SeamModel& m, const std::vector<Index>& runs) {
  std::vector<double> at;
  double s = 0;
  for (std::size_t k = 0; k + 1 < runs.size(); ++k) at.push_back(s += m.runs[runs[k]].length);
  return at;
}

double meeting_distance(double length_mm) {
  return std::max(kSeriesWeights.meet_least_mm, kSeriesWeights.meet * length_mm);
}

/// Corners of b run backwards, scaled to a's length, ascending.
std::vector<double> seen_from(const SeamModel& m, const Chain& a, const Chain& b) {
  std::vector<double> at = corners_of(m, b.runs);
  std::reverse(at.begin(), at.end());
  for (double& s : at) s = (b.length - s) * a.length / b.length;
  return at;
}

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

/// A collar lies as much to the left as to the right around the neck.
bool is_collar_on_neck(const SeamModel& m, const Chain& collar, const Chain& neck) {
  const bool fits = std::abs(collar.length - neck.length) < kSeriesWeights.collar_fits * neck.length;
  return fits && collar.runs.size() == 1 && is_of(m, collar, PieceKind::kCollar) &&
         is_of(m, neck, PieceKind::kTorso) && leads_around(m, neck) && is_symmetric(m, collar) &&
         is_symmetric(m, neck);
}

/// The least that lengths say where one chain is a neckband closed to a ring, or a stand with round ends, and
/// the other a neck: bands of rib are stretched onto a longer one, and stands are longer by what their ends
/// are buttoned over each other. Nothing where they are none.
std::optional<double> band_on_neck(const SeamModel& m, const Chain& a, const Chain& b) {
  const auto is_band = [&](const Chain& chain) {
    const SeamRun& run = m.runs[chain.runs.front()];
    return chain.runs.size() == 1 && is_of(m, chain, PieceKind::kCollar) && m.words[run.panel].stand &&
           (chain.whole || round_stand_edge(m, run) < 0);
  };
  const Chain &band = is_band(a) ? a : b, &neck = is_band(a) ? b : a;
  const bool collar = std::any_of(neck.runs.begin(), neck.runs.end(), [&](Index r) {
    return m.words[m.runs[r].panel].kind == PieceKind::kCollar;
  });
  if (!is_band(band) || !neck.whole || collar) return std::nullopt;
  const double ratio = band.length / neck.length;
  const double beyond = (band.length - neck.length) / 2;
  if (ratio > kSeriesWeights.rib_stretched && ratio < 1) return kSeriesWeights.rib_on_neck;
  return beyond > kSeriesWeights.overlap_least_mm && beyond < kSeriesWeights.overlap_most_mm
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

/// The least that lengths say where one chain is a waistband all around and the other the upper edge of a
/// skirt about twice as long, as it is where its pleats are drawn open: they are gathered. Nothing where that
/// is none.
std::optional<double> pleats_on_band(const SeamModel& m, const Chain& a, const Chain& b) {
  const Chain &band = a.length < b.length ? a : b, &skirt = a.length < b.length ? b : a;
  const auto is_upper = [&](Index r) { return m.runs[r].up > kPairWeights.facing; };
  const bool fits = band.whole && skirt.whole && is_of(m, band, PieceKind::kBand) &&
                    is_of(m, skirt, PieceKind::kSkirt) &&
                    std::all_of(skirt.runs.begin(), skirt.runs.end(), is_upper) &&
                    skirt.length < kSeriesWeights.ratio_pleats * band.length;
  return fits ? std::optional(kSeriesWeights.pleats_on_band) : std::nullopt;
}

/// Whether the chains are of cuffs, which go around a limb each.
bool are_of_two_cuffs(const SeamModel& m, const Chain& a, const Chain& b) {
  const auto is_whole_cuff = [&](const Chain& chain) {
    return is_of(m, chain, PieceKind::kCuff) && m.words[m.runs[chain.runs.front()].panel].face == 0;
  };
  return is_whole_cuff(a) && is_whole_cuff(b);
}

/// Whether all runs of the chain are of the bodice or of its yoke.
bool is_of_bodice(const SeamModel& m, const Chain& chain) {
  return std::all_of(chain.runs.begin(), chain.runs.end(), [&](Index r) {
    const PieceWords& words = m.words[m.runs[r].panel];
    return words.kind == PieceKind::kTorso || words.yoke;
  });
}

/// How far the neck of a front that opens goes on beyond the ends of a collar, mm: by what the fronts are
/// buttoned over each other; or the upper edge of a stand, whose ends are round. Nothing where that is no
/// such collar.
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

/// What speaks for the two chains before the surface is looked at.
double series_merit(const SeamModel& m, const Chain& a, const Chain& b) {
  double merit = length_merit(a.length, b.length);
  merit = std::max(merit, band_on_neck(m, a, b).value_or(merit));
  merit = std::max(merit, pleats_on_band(m, a, b).value_or(merit));
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

std::vector<Trial> trials_of(const SeamModel& m, const std::vector<Chain>& chains) {
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    for (std::size_t j = i + 1; j < chains.size(); ++j) {
      const Chain &a = chains[i], &b = chains[j];
      if (overlap(a, b) || are_of_two_cuffs(m, a, b)) continue;
      const std::optional<double> first = beyond_collar(m, a, b), second = beyond_collar(m, b, a);
      if (first || second)
        trials.push_back({i, j, kSeriesWeights.collar_in_middle, first ? *first : *second});
      if (a.runs.size() + b.runs.size() < 3) continue;
      const double ratio = std::max(a.length, b.length) / std::min(a.length, b.length);
      if (ratio > (a.whole && b.whole ? kSeriesWeights.ratio_whole : kSeriesWeights.ratio) &&
          !pleats_on_band(m, a, b) && !band_on_neck(m, a, b))
        continue;
      trials.push_back({i, j, series_merit(m, a, b), 0});
    }
  }
  std::stable_sort(trials.begin(), trials.end(),
                   [](const Trial& x, const Trial& y) { return x.worth > y.worth; });
  if (trials.size() > kMostTrials) trials.resize(kMostTrials);
  return trials;
}

/// Cuts the chain's runs at the distances that are no corner of it yet; gives its runs after that.
std::vector<Index> cut_chain(const pattern::Pattern& pattern, SeamModel& m, const SeamGluing& g,
                             const std::vector<Index>& runs, const std::vector<double>& places, double near) {
  std::vector<Index> parts;
  double start = 0;
  for (const Index r : runs) {
    const double length = m.runs[r].length;
    const bool backwards = g.turned[m.runs[r].panel] != 0;
    std::vector<double> cuts;
    for (const double s : places)
      if (s > start + near && s < start + length - near)
        cuts.push_back(backwards ? start + length - s : s - start);
    std::sort(cuts.begin(), cuts.end());
    if (!cuts.empty()) m = with_cuts(pattern, std::move(m), r, cuts);
    std::vector<Index> here{r};
    for (std::size_t k = 0; k < cuts.size(); ++k) here.push_back(m.runs[here.back()].next);
    if (backwards) std::reverse(here.begin(), here.end());
    parts.insert(parts.end(), here.begin(), here.end());
    start += length;
  }
  return parts;
}

void grow(SeamGluing& g, std::size_t runs) {
  g.partner.resize(runs, kNone);
  g.merit.resize(runs);
}

/// `found` with the two chains sewn, or nothing when their corners do not come out even.
std::optional<FoundSeams> with_series(const pattern::Pattern& pattern, const FoundSeams& found,
                                      const Chain& a, const Chain& b, double worth) {
  FoundSeams next{found.model, found.gluing, found.seams};
  const double near = meeting_distance(a.length);
  std::vector<double> from_a = corners_of(found.model, a.runs);
  for (double& s : from_a) s = b.length - s * b.length / a.length;
  std::reverse(from_a.begin(), from_a.end());
  const std::vector<double> from_b = seen_from(found.model, a, b);
  FoundSeam seam;
  seam.a = cut_chain(pattern, next.model, next.gluing, a.runs, from_b, near);
  seam.b = cut_chain(pattern, next.model, next.gluing, b.runs, from_a, near * b.length / a.length);
  if (seam.a.size() != seam.b.size()) return std::nullopt;
  std::reverse(seam.b.begin(), seam.b.end());
  grow(next.gluing, next.model.runs.size());
  const double share = 1.0 / static_cast<double>(seam.a.size());
  for (std::size_t k = 0; k < seam.a.size(); ++k) {
    if (never_sewn(next.model, seam.a[k], seam.b[k])) return std::nullopt;
    std::array<double, 2> merit = pair_merit(next.model, seam.a[k], seam.b[k], false);
    for (double& x : merit) x = (x + worth) * share;
    next.gluing.sew(seam.a[k], seam.b[k], merit);
  }
  next.seams.push_back(std::move(seam));
  return next;
}

/// The chain without so much of its ends, which are cut off.
Chain without_ends(const pattern::Pattern& pattern, FoundSeams& found, Chain chain, double beyond) {
  std::vector<Index> parts =
      cut_chain(pattern, found.model, found.gluing, chain.runs, {beyond, chain.length - beyond}, 0);
  grow(found.gluing, found.model.runs.size());
  chain.runs.assign(parts.begin() + 1, parts.end() - 1);
  chain.length -= 2 * beyond;
  chain.whole = false;
  return chain;
}

/// `found` with the trial's chains sewn, or nothing when their corners do not come out even.
std::optional<FoundSeams> tried(const pattern::Pattern& pattern, const FoundSeams& found,
                                const std::vector<Chain>& chains, const Trial& trial) {
  Chain a = chains[trial.a], b = chains[trial.b];
  if (trial.beyond == 0) return with_series(pattern, found, a, b, trial.worth);
  FoundSeams cut{found.model, found.gluing, found.seams};
  Chain& neck = a.length > b.length ? a : b;
  neck = without_ends(pattern, cut, neck, trial.beyond);
  return with_series(pattern, cut, a, b, trial.worth);
}

bool holds(const Chain& chain, Index run) {
  return std::find(chain.runs.begin(), chain.runs.end(), run) != chain.runs.end();
}

/// The chain of `run` and of half of what it goes on along, where that is its own mirror image: a band that
/// goes up a front is sewn on as far as the middle of the back's neck. Nothing where it is none.
std::optional<Chain> with_half_of_next(const pattern::Pattern& pattern, FoundSeams& found, Chain chain,
                                       Index run) {
  const bool first = chain.runs.front() == run;
  const Index next = first ? chain.runs.back() : chain.runs.front();
  if (found.model.mirror[next] != next) return std::nullopt;
  const double half = found.model.runs[next].length / 2;
  const std::vector<Index> parts =
      cut_chain(pattern, found.model, found.gluing, chain.runs, {first ? chain.length - half : half}, 0);
  if (parts.size() != 3) return std::nullopt;
  grow(found.gluing, found.model.runs.size());
  chain.runs.assign(parts.begin() + (first ? 0 : 1), parts.end() - (first ? 1 : 0));
  chain.length -= half;
  chain.whole = false;
  return chain;
}

/// The garment with that seam, whose lengths differ, sewn on along what goes on from its shorter side, so
/// that they agree: a back's side with the yoke's above it. Nothing where nothing of that length goes on.
std::optional<FoundSeams> sewn_further(const pattern::Pattern& pattern, const FoundSeams& found,
                                       std::size_t seam, const std::vector<char>& locked) {
  const Index a = found.seams[seam].a[0], b = found.seams[seam].b[0];
  FoundSeams without{found.model, found.gluing, found.seams};
  without.gluing.undo(a);
  without.seams.erase(without.seams.begin() + static_cast<std::ptrdiff_t>(seam));
  const SeamModel& m = without.model;
  const Index longer = m.runs[a].length > m.runs[b].length ? a : b, shorter = longer == a ? b : a;
  const std::vector<Chain> chains = chains_of(m, free_borders(m, without.gluing), locked);
  const auto one = std::find_if(chains.begin(), chains.end(), [&](const Chain& chain) {
    return chain.runs.size() == 1 && chain.runs[0] == longer;
  });
  if (one == chains.end()) return std::nullopt;
  const auto agrees = [&](const Chain& chain) {
    return std::abs(chain.length - one->length) <= kSeriesWeights.further_mm;
  };
  for (const Chain& chain : chains) {
    if (chain.runs.size() != 2 || !holds(chain, shorter) || overlap(chain, *one)) continue;
    if (agrees(chain)) {
      if (auto next = with_series(pattern, without, chain, *one, series_merit(m, chain, *one))) return next;
      continue;
    }
    FoundSeams cut{without.model, without.gluing, without.seams};
    const std::optional<Chain> half = with_half_of_next(pattern, cut, chain, shorter);
    if (!half || !agrees(*half)) continue;
    if (auto next = with_series(pattern, cut, *half, *one, series_merit(cut.model, *half, *one))) return next;
  }
  return std::nullopt;
}

/// The garment with all seams sewn further that can be, and are better for it.
FoundSeams all_sewn_further(const pattern::Pattern& pattern, FoundSeams found,
                            const std::vector<char>& locked, const GluingSettings& settings) {
  for (std::size_t k = 0; k < found.seams.size();) {
    const FoundSeam& seam = found.seams[k];
    const bool one = seam.a.size() == 1 && seam.b.size() == 1;
    const bool differ = one && std::abs(found.model.runs[seam.a[0]].length -
                                        found.model.runs[seam.b[0]].length) > kSeriesWeights.differ_mm;
    const auto is_locked = [&](Index r) { return r < static_cast<Index>(locked.size()) && locked[r]; };
    auto next = differ && !is_locked(seam.a[0]) && !is_locked(seam.b[0])
                    ? sewn_further(pattern, found, k, locked)
                    : std::nullopt;
    const bool better = next && gluing_merit(next->model, next->gluing, settings) >
                                    gluing_merit(found.model, found.gluing, settings);
    if (better)
      found = std::move(*next);  // what follows has moved up
    else
      ++k;
  }
  return found;
}

}  // namespace

FoundSeams sewn_in_series(const pattern::Pattern& pattern, FoundSeams found, const std::vector<char>& locked,
                          const GluingSettings& settings, const RunContext& context) {
  found = all_sewn_further(pattern, std::move(found), locked, settings);
  for (int round = 0; round < 20 && !context.cancelled(); ++round) {
    const std::vector<Chain> chains = chains_of(found.model, free_borders(found.model, found.gluing), locked);
    const double now = gluing_merit(found.model, found.gluing, settings);
    std::optional<FoundSeams> best;
    double gain = kSeriesWeights.worthwhile;
    for (const Trial& trial : trials_of(found.model, chains)) {
      auto next = tried(pattern, found, chains, trial);
      if (!next) continue;
      const double merit = gluing_merit(next->model, next->gluing, settings) - now;
      if (merit > gain) {
        gain = merit;
        best = std::move(next);
      }
    }
    if (!best) return found;
    found = std::move(*best);
  }
  return found;
}

}  // namespace toile::seams
