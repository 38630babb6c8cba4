#include "core/pattern/seams/series.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/pattern/seams/chains.h"
#include "core/pattern/seams/series_merit.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

constexpr std::size_t kMostTrials = 150;  // that are looked at closely, at a time

struct Trial {
  std::size_t a, b;
  double worth;
  double beyond = 0;  ///< mm that each end of the longer chain goes on beyond the shorter one
};

std::vector<Trial> trials_of(const SeamModel& m, const std::vector<Chain>& chains) {
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    for (std::size_t j = i + 1; j < chains.size(); ++j) {
      const Chain &a = chains[i], &b = chains[j];
      if (overlap(a, b) || are_of_two_cuffs(m, a, b)) continue;
      const std::optional<double> first = beyond_collar(m, a, b), second = beyond_collar(m, b, a);
      if (first || second)
        trials.push_back({i, j, kSeriesWeights.collar_in_middle, first ? *first : *second});
      if (a.runs.size() + b.runs.size() < 3 || !lengths_fit(m, a, b)) continue;
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

/// Two runs that are sewn to each other.
struct Pair {
  std::size_t seam = 0, place = 0;  ///< of FoundSeams, of the seam's sides
};

void erase(std::vector<FoundSeam>& seams, const Pair& pair) {
  FoundSeam& seam = seams[pair.seam];
  seam.a.erase(seam.a.begin() + static_cast<std::ptrdiff_t>(pair.place));
  seam.b.erase(seam.b.begin() + static_cast<std::ptrdiff_t>(pair.place));
  if (seam.a.empty()) seams.erase(seams.begin() + static_cast<std::ptrdiff_t>(pair.seam));
}

/// The garment with that pair, whose lengths differ, sewn on along what goes on from its shorter side, so
/// that they agree: a back's side with the yoke's above it. Nothing where nothing of that length goes on.
std::optional<FoundSeams> sewn_further(const pattern::Pattern& pattern, const FoundSeams& found,
                                       const Pair& pair, const std::vector<char>& locked) {
  const Index a = found.seams[pair.seam].a[pair.place], b = found.seams[pair.seam].b[pair.place];
  FoundSeams without{found.model, found.gluing, found.seams};
  without.gluing.undo(a);
  erase(without.seams, pair);
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

/// The first or last pair of the seam, where it goes on, if its lengths differ and both are free to change.
std::optional<Pair> end_that_differs(const FoundSeams& found, std::size_t seam,
                                     const std::vector<char>& locked) {
  const auto is_locked = [&](Index r) { return r < static_cast<Index>(locked.size()) && locked[r]; };
  const std::vector<Index>&a = found.seams[seam].a, &b = found.seams[seam].b;
  for (const std::size_t k : {std::size_t{0}, a.size() - 1}) {
    const double difference = std::abs(found.model.runs[a[k]].length - found.model.runs[b[k]].length);
    if (difference > kSeriesWeights.differ_mm && !is_locked(a[k]) && !is_locked(b[k])) return Pair{seam, k};
  }
  return std::nullopt;
}

/// The garment with all seams sewn further that can be, and are better for it.
FoundSeams all_sewn_further(const pattern::Pattern& pattern, FoundSeams found,
                            const std::vector<char>& locked, const GluingSettings& settings) {
  for (std::size_t k = 0; k < found.seams.size();) {
    const std::optional<Pair> pair = end_that_differs(found, k, locked);
    auto next = pair ? sewn_further(pattern, found, *pair, locked) : std::nullopt;
    const bool better = next && gluing_merit(next->model, next->gluing, settings) >
                                    gluing_merit(found.model, found.gluing, settings);
    if (better)
      found = std::move(*next);  // what follows has moved up, or the seam has lost its end
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
