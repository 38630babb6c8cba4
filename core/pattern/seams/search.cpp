#include "core/pattern/seams/search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/pattern/seams/cuts.h"
#include "core/pattern/seams/series.h"

namespace toile::seams {
namespace {

constexpr double kWeakest = -4;              // a pair that is worth less is no candidate
constexpr std::size_t kMostCandidates = 24;  // of a run
constexpr std::size_t kRestarts = 3;         // of each way to cut the edges
constexpr std::size_t kSidedRestarts = 2;    // of each that keep to likely sides
constexpr double kThreshold = 13;            // as much as two good seams
constexpr double kDoubtThreshold = 2.5;      // once the garment stands
constexpr int kTriesPerRun = 2000, kDoubtsPerRun = 25;
constexpr int kMostWork = 3000000;      // tries times runs, of one search: a jacket takes as long as a shirt
constexpr std::size_t kManyRuns = 70;   // a whole wardrobe: fewer and shorter searches
constexpr int kManyRunsWork = 1000000;  // of one of them
constexpr double kSameMerit = 1e-6;
constexpr int kAgree = 2;  // searches that find the same best: others would, too

/// SplitMix64 (Steele, Lea and Flood 2014).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t n) {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<std::size_t>((z ^ (z >> 31)) % n);
  }

 private:
  std::uint64_t state_;
};

struct Candidate {
  Index run;
  std::array<double, 2> merit;
};

using Candidates = std::vector<std::vector<Candidate>>;

double best_of(const Candidate& c) { return std::max(c.merit[0], c.merit[1]); }

Candidates candidates_of(const SeamModel& m, const std::vector<char>& locked) {
  Candidates all(m.runs.size());
  for (Index a = 0; a < static_cast<Index>(m.runs.size()); ++a) {
    if (locked[a]) continue;
    for (Index b = 0; b < static_cast<Index>(m.runs.size()); ++b) {
      if (b == a || locked[b]) continue;
      const Candidate c{b, pair_merit(m, a, b)};
      if (best_of(c) > kWeakest) all[a].push_back(c);
    }
    std::stable_sort(all[a].begin(), all[a].end(),
                     [](const Candidate& x, const Candidate& y) { return best_of(x) > best_of(y); });
    if (all[a].size() > kMostCandidates) all[a].resize(kMostCandidates);
  }
  return all;
}

/// One search: changes a gluing a little at a time and keeps what is not much worse.
class Annealer {
 public:
  Annealer(const SeamModel& model, const std::vector<char>& locked, const GluingSettings& settings)
      : m_(model),
        locked_(locked),
        judge_(model, settings),
        candidates_(candidates_of(model, locked)),
        may_turn_(!settings.sides_known) {
    for (Index i = 0; i < static_cast<Index>(m_.runs.size()); ++i)
      if (!locked_[i] && !candidates_[i].empty()) open_.push_back(i);
  }

  /// Never sews run a to run b, nor a run of another piece of the same form in place of one of them: the
  /// garment with two such pieces changed round is the same garment.
  void forbid(Index a, Index b) {
    forbidden_.assign(1, {a, b});
    for (const Index x : m_.same[a]) forbidden_.push_back({x, b});
    for (const Index x : m_.same[b]) forbidden_.push_back({a, x});
  }
  void allow_all() { forbidden_.clear(); }
  /// Turns no panel over.
  void keep_sides() { may_turn_ = false; }

  /// The best of what is found on the way; never worse than the start.
  double run(SeamGluing& gluing, int tries, double threshold, std::uint64_t seed, const RunContext& context) {
    double now = judge_.merit(gluing), best_merit = now;
    if (open_.empty()) return now;
    Numbers numbers(seed);
    SeamGluing best = gluing, next = gluing;
    for (int k = 0; k < tries; ++k) {
      if (k % 1024 == 0 && context.cancelled()) break;
      const double left = static_cast<double>(tries - k) / tries;
      next = gluing;
      if (!change(next, numbers)) continue;
      const double merit = judge_.merit(next);
      if (merit < now - threshold * left * left) continue;
      std::swap(gluing, next);
      now = merit;
      if (now > best_merit + 1e-9) {
        best = gluing;
        best_merit = now;
      }
    }
    gluing = std::move(best);
    return best_merit;
  }

 private:
  bool allowed(Index a, Index b) const {
    if (locked_[a] || locked_[b]) return false;
    return std::none_of(forbidden_.begin(), forbidden_.end(), [&](const std::array<Index, 2>& pair) {
      return (a == pair[0] && b == pair[1]) || (a == pair[1] && b == pair[0]);
    });
  }

  bool sew(SeamGluing& g, Index a, const Candidate& c) const {
    if (!allowed(a, c.run) || g.partner[a] == c.run) return false;
    g.undo(a);
    g.undo(c.run);
    g.sew(a, c.run, c.merit);
    return true;
  }

  const Candidate* candidate(Index a, Index b) const {
    for (const Candidate& c : candidates_[a])
      if (c.run == b) return &c;
    return nullptr;
  }

  void sew_mirrored(SeamGluing& g, Index a, Index b) const {
    const Index ma = m_.mirror[a], mb = m_.mirror[b];
    if (ma == kNone || mb == kNone || ma == mb) return;
    if (const Candidate* c = candidate(ma, mb)) sew(g, ma, *c);
  }

  /// Turns the panel over, and the one that mirrors it.
  void turn(SeamGluing& g, Index panel) const {
    g.turned[panel] = !g.turned[panel];
    const Index twin = m_.twin[panel];
    if (twin != kNone && twin != panel) g.turned[twin] = !g.turned[twin];
  }

  /// Turns all that hangs together with the panel, that itself included.
  void turn_part(SeamGluing& g, Index panel) const {
    std::vector<char> in(m_.words.size(), 0);
    in[panel] = 1;
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t r = 0; r < m_.runs.size(); ++r) {
        const Index p = m_.runs[r].panel;
        if (!in[p]) continue;
        for (const Index q : {g.partner[r] == kNone ? p : m_.runs[g.partner[r]].panel, m_.twin[p]}) {
          if (q == kNone || in[q]) continue;
          in[q] = 1;
          grown = true;
        }
      }
    }
    for (std::size_t p = 0; p < in.size(); ++p)
      if (in[p]) g.turned[p] = !g.turned[p];
  }

  void turn_some(SeamGluing& g, Index run, bool part) const {
    if (!may_turn_) return;
    if (part) return turn_part(g, m_.runs[run].panel);
    turn(g, m_.runs[run].panel);
  }

  /// Two sewn pairs change partners: a takes that of another run, whose partner takes a's.
  bool exchange(SeamGluing& g, Index a, bool both, Numbers& numbers) const {
    const Index b = g.partner[a];
    if (b == kNone || candidates_[b].empty()) return false;
    const Candidate& c = candidates_[b][numbers.below(candidates_[b].size())];
    const Index d = g.partner[c.run];
    const Candidate* rest = d == kNone || d == a ? nullptr : candidate(a, d);
    if (rest == nullptr || !sew(g, b, c) || !sew(g, a, *rest)) return false;
    if (both) {
      sew_mirrored(g, b, c.run);
      sew_mirrored(g, a, d);
    }
    return true;
  }

  bool change(SeamGluing& g, Numbers& numbers) const {
    const Index a = open_[numbers.below(open_.size())];
    const bool both = numbers.below(4) != 0;
    const std::size_t kind = numbers.below(20);
    if (kind < 14) {
      // Mostly one of the better candidates: the least of two draws.
      const std::size_t n = candidates_[a].size();
      const std::size_t first = numbers.below(n), second = numbers.below(n);
      const Candidate& c = candidates_[a][std::min(first, second)];
      if (kind < 4) {
        g.undo(a);
        turn_some(g, a, kind < 2);
      }
      if (!sew(g, a, c)) return false;
      if (both) sew_mirrored(g, a, c.run);
      return true;
    }
    if (kind < 17) return exchange(g, a, both, numbers);
    if (kind < 18) {
      if (g.partner[a] == kNone) return false;
      const Index ma = m_.mirror[a];
      if (both && ma != kNone && !locked_[ma]) g.undo(ma);
      g.undo(a);
      return true;
    }
    turn_some(g, a, false);
    return may_turn_;
  }

  const SeamModel& m_;
  const std::vector<char>& locked_;
  GluingJudge judge_;
  Candidates candidates_;
  std::vector<Index> open_;
  bool may_turn_;
  std::vector<std::array<Index, 2>> forbidden_;
};

/// Tries of one of `searches` that share the work.
int tries_for(const SeamModel& m, int per_run, std::size_t searches = 1) {
  const int runs = static_cast<int>(m.runs.size());
  const int work = m.runs.size() > kManyRuns ? kManyRunsWork : kMostWork;
  const int most = work / std::max(1, runs) / static_cast<int>(std::max<std::size_t>(1, searches));
  return std::clamp(most, 1, per_run * std::max(1, runs));
}

/// The runs that one edge was cut into, in the outline's order, from its first.
std::vector<Index> parts_of_edge(const SeamModel& m, Index first) {
  std::vector<Index> parts{first};
  while (m.runs[parts.back()].to < 1) parts.push_back(m.runs[parts.back()].next);
  return parts;
}

/// An edge whose parts are all sewn to whole edges is one seam; else every pair is.
std::vector<FoundSeam> sewn_seams(const SeamModel& m, const SeamGluing& g, const std::vector<char>& locked) {
  std::vector<FoundSeam> seams;
  std::vector<bool> done(m.runs.size(), false);
  const auto whole = [&](Index r) { return m.runs[r].from == 0 && m.runs[r].to == 1; };
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r) {
    if (whole(r) || m.runs[r].from > 0) continue;
    std::vector<Index> a = parts_of_edge(m, r), b;
    for (const Index part : a)
      if (g.partner[part] != kNone && whole(g.partner[part])) b.push_back(g.partner[part]);
    if (a.size() != b.size()) continue;
    if (g.turned[m.runs[r].panel]) {
      std::reverse(a.begin(), a.end());
      std::reverse(b.begin(), b.end());
    }
    for (const Index x : a) done[x] = done[g.partner[x]] = true;
    seams.push_back({a, b, 0});
  }
  for (Index a = 0; a < static_cast<Index>(m.runs.size()); ++a)
    if (g.partner[a] > a && !done[a] && !(locked[a] && locked[g.partner[a]]))
      seams.push_back({{a}, {g.partner[a]}, 0});
  return seams;
}

void lengthen(SeamGluing& g, std::vector<char>& locked, std::size_t runs) {
  g.partner.resize(runs, kNone);
  g.merit.resize(runs);
  locked.resize(runs, 0);
}

/// Looks whether the garment would be better without one of its seams, each in turn.
void doubt_each(Annealer& annealer, FoundSeams& found, const std::vector<char>& locked, double merit,
                const RunContext& context) {
  const int tries = tries_for(found.model, kDoubtsPerRun, found.model.runs.size() / 2);
  for (Index r = 0; r < static_cast<Index>(found.model.runs.size()) && !context.cancelled(); ++r) {
    const Index other = found.gluing.partner[r];
    if (other <= r || (locked[r] && locked[other])) continue;
    SeamGluing without = found.gluing;
    without.undo(r);
    annealer.forbid(r, other);
    const double there = annealer.run(without, tries, kDoubtThreshold, 7, context);
    if (there > merit + 1e-6) {
      found.gluing = std::move(without);
      merit = there;
    }
  }
  annealer.allow_all();
}

/// Which panels may be drawn from the other side: none, as the drawing hints, or those called back.
std::vector<std::vector<char>> likely_sides(const SeamModel& m, const SeamGluing& g,
                                            const GluingSettings& settings) {
  if (settings.sides_known) return {};
  std::vector<std::vector<char>> sides{g.turned};
  const auto add = [&](const std::vector<char>& turned) {
    if (std::find(sides.begin(), sides.end(), turned) == sides.end()) sides.push_back(turned);
  };
  if (!settings.turned.empty()) add(settings.turned);
  std::vector<char> backs;
  for (const PieceWords& words : m.words) backs.push_back(words.face < 0);
  add(backs);
  return sides;
}

/// The best garment of a few searches with the edges cut in one way: first run to run, then in series.
void search(const pattern::Pattern& pattern, FoundSeams start, std::vector<char> locked,
            const GluingSettings& settings, const RunContext& context, FoundSeams& best, double& best_merit) {
  lengthen(start.gluing, locked, start.model.runs.size());
  const std::vector<std::vector<char>> sides = likely_sides(start.model, start.gluing, settings);
  const bool many = start.model.runs.size() > kManyRuns;
  const std::size_t sided = (many ? 1 : kSidedRestarts) * sides.size();
  const std::size_t restarts = sided + (many ? 1 : kRestarts);
  double top = -std::numeric_limits<double>::max();
  int agreed = 0;
  for (std::size_t k = 0; k < restarts && agreed < kAgree && !context.cancelled(); ++k) {
    Annealer annealer(start.model, locked, settings);
    FoundSeams found = start;
    if (k < sided) {
      found.gluing.turned = sides[k % sides.size()];
      annealer.keep_sides();
    }
    double merit = annealer.run(found.gluing, tries_for(start.model, kTriesPerRun), kThreshold,
                                1 + static_cast<std::uint64_t>(k), context);
    doubt_each(annealer, found, locked, merit, context);
    found.seams = sewn_seams(found.model, found.gluing, locked);
    sew_series(pattern, found, locked, settings, context);
    merit = gluing_merit(found.model, found.gluing, settings);
    if (merit > top + kSameMerit) {
      top = merit;
      agreed = 0;
    }
    agreed += merit > top - kSameMerit ? 1 : 0;
    if (merit > best_merit) {
      best = std::move(found);
      best_merit = merit;
    }
  }
}

/// Where the runs end: the same for models that are cut alike.
std::vector<double> cuts_of(const SeamModel& m) {
  std::vector<double> ends;
  for (const SeamRun& run : m.runs) ends.push_back(run.to);
  return ends;
}

FoundSeams best_garment(const pattern::Pattern& pattern, const FoundSeams& start,
                        const std::vector<char>& locked, const GluingSettings& settings,
                        const RunContext& context) {
  FoundSeams best = start;
  double merit = gluing_merit(start.model, start.gluing, settings);
  search(pattern, start, locked, settings, context, best, merit);
  std::vector<std::vector<double>> known{cuts_of(start.model)};
  for (const CutKind kind : {CutKind::darts, CutKind::exact_first, CutKind::exact_second,
                             CutKind::first_first, CutKind::second_first}) {
    context.progress("seams", 0.1 * static_cast<double>(1 + static_cast<int>(kind)));
    FoundSeams cut = start;
    cut.model = with_likely_cuts(pattern, start.model, kind);
    std::vector<double> cuts = cuts_of(cut.model);
    if (std::find(known.begin(), known.end(), cuts) != known.end()) continue;
    known.push_back(std::move(cuts));
    search(pattern, std::move(cut), locked, settings, context, best, merit);
  }
  return best;
}

/// What is lost when the seam must not be, and the rest may be sewn anew.
double margin_of(const FoundSeam& seam, const FoundSeams& found, const std::vector<char>& fixed,
                 const GluingSettings& settings, const RunContext& context) {
  SeamGluing without = found.gluing;
  std::vector<char> locked = fixed;
  for (const Index r : seam.a) without.undo(r);
  for (const std::vector<Index>* side : {&seam.a, &seam.b})
    for (const Index r : *side) locked[r] = 0;
  Annealer annealer(found.model, locked, settings);
  annealer.forbid(seam.a[0], seam.b[0]);
  annealer.keep_sides();  // a garment seen in a mirror is no other garment
  const double other = annealer.run(without, tries_for(found.model, kDoubtsPerRun, found.seams.size()),
                                    kDoubtThreshold, 7, context);
  return gluing_merit(found.model, found.gluing, settings) - other;
}

}  // namespace

FoundSeams search_seams(const pattern::Pattern& pattern, const std::vector<std::array<Index, 2>>& sewn,
                        const std::vector<Index>& blocked, const GluingSettings& settings,
                        const RunContext& context) {
  FoundSeams found{make_seam_model(pattern), {}, {}};
  found.gluing = nothing_sewn(found.model);
  std::vector<char> locked(found.model.runs.size(), 0);
  for (const Index r : blocked) locked[r] = 1;
  for (const auto& [a, b] : sewn) {
    found.gluing.sew(a, b, pair_merit(found.model, a, b));
    locked[a] = locked[b] = 1;
  }
  found = best_garment(pattern, found, locked, settings, context);
  locked.resize(found.model.runs.size(), 0);
  for (const FoundSeam& seam : found.seams) {
    if (seam.a.size() < 2) continue;  // cut runs stay as they are
    for (const std::vector<Index>* side : {&seam.a, &seam.b})
      for (const Index r : *side) locked[r] = 1;
  }
  for (std::size_t k = 0; k < found.seams.size() && !context.cancelled(); ++k) {
    found.seams[k].margin = margin_of(found.seams[k], found, locked, settings, context);
    context.progress("seams",
                     0.7 + 0.3 * static_cast<double>(k + 1) / static_cast<double>(found.seams.size()));
  }
  return found;
}

}  // namespace toile::seams
