#include "core/pattern/seam_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/pattern/seam_series.h"

#include <cstdlib>
static int TPR = getenv("TPR") ? atoi(getenv("TPR")) : 900;
static double TH = getenv("TH") ? atof(getenv("TH")) : 6;
static int TMAX = 400000;
namespace toile {
namespace {

constexpr double kWeakest = -4;              // a pair that is worth less is no candidate
constexpr std::size_t kMostCandidates = 24;  // of a run
constexpr int kRestarts = 3;

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
      : m_(model), locked_(locked), settings_(settings), candidates_(candidates_of(model, locked)) {
    for (Index i = 0; i < static_cast<Index>(m_.runs.size()); ++i)
      if (!locked_[i] && !candidates_[i].empty()) open_.push_back(i);
  }

  /// Never sews run a to run b.
  void forbid(Index a, Index b) { forbidden_ = {a, b}; }

  /// The best of what is found on the way; never worse than the start.
  double run(SeamGluing& gluing, int tries, double threshold, std::uint64_t seed, const RunContext& context) {
    double now = gluing_merit(m_, gluing, settings_), best_merit = now;
    if (open_.empty()) return now;
    Numbers numbers(seed);
    SeamGluing best = gluing;
    for (int k = 0; k < tries; ++k) {
      if (k % 1024 == 0 && context.cancelled()) break;
      const double left = static_cast<double>(tries - k) / tries;
      SeamGluing next = gluing;
      if (!change(next, numbers)) continue;
      const double merit = gluing_merit(m_, next, settings_);
      if (merit < now - threshold * left * left) continue;
      gluing = std::move(next), now = merit;
      if (now > best_merit + 1e-9) best = gluing, best_merit = now;
    }
    gluing = std::move(best);
    return best_merit;
  }

 private:
  bool allowed(Index a, Index b) const {
    return !locked_[a] && !locked_[b] && !(a == forbidden_[0] && b == forbidden_[1]) &&
           !(a == forbidden_[1] && b == forbidden_[0]);
  }

  bool sew(SeamGluing& g, Index a, const Candidate& c) const {
    if (!allowed(a, c.run) || g.partner[a] == c.run) return false;
    g.undo(a), g.undo(c.run);
    g.sew(a, c.run, c.merit);
    return true;
  }

  void sew_mirrored(SeamGluing& g, Index a, Index b) const {
    const Index ma = m_.mirror[a], mb = m_.mirror[b];
    if (ma == kNone || mb == kNone || ma == mb) return;
    for (const Candidate& c : candidates_[ma])
      if (c.run == mb) sew(g, ma, c);
  }

  void turn(SeamGluing& g, Index panel) const { g.turned[panel] = !g.turned[panel]; }

  /// Turns all that hangs together with the panel, that itself included.
  void turn_part(SeamGluing& g, Index panel) const {
    std::vector<char> in(m_.words.size(), 0);
    in[panel] = 1;
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t r = 0; r < m_.runs.size(); ++r) {
        if (g.partner[r] == kNone || !in[m_.runs[r].panel]) continue;
        char& other = in[m_.runs[g.partner[r]].panel];
        grown = grown || !other;
        other = 1;
      }
    }
    for (std::size_t p = 0; p < in.size(); ++p)
      if (in[p]) g.turned[p] = !g.turned[p];
  }

  void turn_some(SeamGluing& g, Index run, bool both, bool part) const {
    if (settings_.sides_known) return;
    const Index panel = m_.runs[run].panel, twin = m_.mirror[run];
    if (part) return turn_part(g, panel);
    turn(g, panel);
    if (both && twin != kNone && m_.runs[twin].panel != panel) turn(g, m_.runs[twin].panel);
  }

  bool change(SeamGluing& g, Numbers& numbers) const {
    const Index a = open_[numbers.below(open_.size())];
    const bool both = numbers.below(4) != 0;
    const std::size_t kind = numbers.below(20);
    if (kind < 15) {
      // Mostly one of the better candidates: the least of two draws.
      const std::size_t n = candidates_[a].size();
      const std::size_t first = numbers.below(n), second = numbers.below(n);
      const Candidate& c = candidates_[a][std::min(first, second)];
      if (kind < 4) {
        g.undo(a);
        turn_some(g, a, both, kind < 2);
      }
      if (!sew(g, a, c)) return false;
      if (both) sew_mirrored(g, a, c.run);
      return true;
    }
    if (kind < 18) {
      if (g.partner[a] == kNone) return false;
      const Index ma = m_.mirror[a];
      if (both && ma != kNone && !locked_[ma]) g.undo(ma);
      g.undo(a);
      return true;
    }
    turn_some(g, a, both, false);
    return !settings_.sides_known;
  }

  const SeamModel& m_;
  const std::vector<char>& locked_;
  GluingSettings settings_;
  Candidates candidates_;
  std::vector<Index> open_;
  std::array<Index, 2> forbidden_{kNone, kNone};
};

int tries_for(const SeamModel& m, int per_run) {
  return std::clamp(per_run * static_cast<int>(m.runs.size()), 2000, TMAX);
}

SeamGluing best_gluing(const SeamModel& m, const SeamGluing& start, const std::vector<char>& locked,
                       const GluingSettings& settings, const RunContext& context) {
  Annealer annealer(m, locked, settings);
  SeamGluing best = start;
  double best_merit = gluing_merit(m, start, settings);
  for (int k = 0; k < kRestarts; ++k) {
    SeamGluing g = start;
    const double merit = annealer.run(g, tries_for(m, TPR), TH, 1 + static_cast<std::uint64_t>(k), context);
    if (merit > best_merit) best = std::move(g), best_merit = merit;
    context.progress("seams", 0.6 * (k + 1) / kRestarts);
  }
  return best;
}

std::vector<FoundSeam> single_seams(const SeamGluing& g, const std::vector<char>& locked) {
  std::vector<FoundSeam> seams;
  for (Index a = 0; a < static_cast<Index>(g.partner.size()); ++a)
    if (g.partner[a] > a && !locked[a]) seams.push_back({{a}, {g.partner[a]}, 0});
  return seams;
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
  const double other = annealer.run(without, tries_for(found.model, 25), 2.5, 7, context);
  return gluing_merit(found.model, found.gluing, settings) - other;
}

}  // namespace

FoundSeams search_seams(const Pattern& pattern, const std::vector<std::array<Index, 2>>& sewn,
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
  found.gluing = best_gluing(found.model, found.gluing, locked, settings, context);
  std::vector<FoundSeam> singles = single_seams(found.gluing, locked);
  sew_series(pattern, found, locked, settings, context);
  locked.resize(found.model.runs.size(), 0);
  for (const FoundSeam& series : found.seams)
    for (const std::vector<Index>* side : {&series.a, &series.b})
      for (const Index r : *side) locked[r] = 1;
  found.seams.insert(found.seams.begin(), singles.begin(), singles.end());
  for (std::size_t k = 0; k < found.seams.size() && !context.cancelled(); ++k) {
    found.seams[k].margin = margin_of(found.seams[k], found, locked, settings, context);
    context.progress("seams",
                     0.7 + 0.3 * static_cast<double>(k + 1) / static_cast<double>(found.seams.size()));
  }
  return found;
}

}  // namespace toile
