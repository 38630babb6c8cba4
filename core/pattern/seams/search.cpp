#include "core/pattern/seams/search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>
#include <utility>

#include "core/base/crew.h"
#include "core/pattern/seams/cuts.h"
#include "core/pattern/seams/moves.h"
#include "core/pattern/seams/remembering_judge.h"
#include "core/pattern/seams/series.h"

namespace toile::seams {
namespace {

constexpr std::size_t kRestarts = 3;       // of each way to cut the edges
constexpr std::size_t kSidedRestarts = 2;  // of each that keep to likely sides
constexpr double kThreshold = 13;          // as much as two good seams
constexpr double kDoubtThreshold = 2.5;    // once the garment stands
constexpr int kTriesPerRun = 2000, kDoubtsPerRun = 25;
constexpr int kMostWork = 3000000;      // tries times runs, of one search: a jacket takes as long as a shirt
constexpr std::size_t kManyRuns = 150;  // a whole wardrobe: fewer and shorter searches
constexpr int kManyRunsWork = 1000000;  // of one of them
constexpr std::size_t kMemory = 8 << 20, kMarginMemory = 1 << 18;  // bytes, of one search
constexpr int kMostThreads = 7;                                    // ways to cut the edges
constexpr double kShareOfGarments = 0.7;  // of the progress; the rest is that of margins
constexpr double kSameMerit = 1e-6;
constexpr int kAgree = 2;  // searches that find the same best: others would, too

/// How long a search goes on, and how much worse a garment it takes on its way at first.
struct Effort {
  int tries;
  double threshold;
  std::uint64_t seed;
};

/// What is sewn, and what all of it is worth.
struct Sewn {
  SeamGluing gluing;
  double merit;
};

/// The best of what is found on the way from `start` by changing it a little at a time and keeping what is
/// not much worse; never worse than the start. `judge` is the model's.
Sewn annealed(const Choices& choices, const Limits& limits, RememberingJudge& judge, SeamGluing gluing,
              const Effort& effort, const RunContext& context) {
  Sewn best{gluing, judge.merit(gluing)};
  if (choices.open.empty()) return best;
  double now = best.merit;
  Numbers numbers(effort.seed);
  SeamGluing next = gluing;
  for (int k = 0; k < effort.tries; ++k) {
    if (k % 1024 == 0 && context.cancelled()) break;
    const double left = static_cast<double>(effort.tries - k) / effort.tries;
    next = gluing;
    if (!change(choices, limits, numbers, next)) continue;
    const double merit = judge.merit(next);
    if (merit < now - effort.threshold * left * left) continue;
    std::swap(gluing, next);
    now = merit;
    if (now <= best.merit + 1e-9) continue;
    best.gluing = gluing;
    best.merit = now;
  }
  return best;
}

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

/// Whether the partners of run k and the next of `parts` are parts of one edge that follow each other.
bool follow(const SeamModel& m, const SeamGluing& g, Index part, Index next) {
  const Index x = g.partner[part], y = g.partner[next];
  if (x == kNone || y == kNone || m.runs[x].panel != m.runs[y].panel || m.runs[x].edge != m.runs[y].edge)
    return false;
  return m.runs[x].from == m.runs[y].to || m.runs[x].to == m.runs[y].from;
}

/// An edge whose parts are all sewn to whole edges, or to the parts of one, is one seam; else every pair is.
std::vector<FoundSeam> sewn_seams(const SeamModel& m, const SeamGluing& g, const std::vector<char>& locked) {
  std::vector<FoundSeam> seams;
  std::vector<bool> done(m.runs.size(), false);
  const auto whole = [&](Index r) { return m.runs[r].from == 0 && m.runs[r].to == 1; };
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r) {
    if (whole(r) || m.runs[r].from > 0) continue;
    std::vector<Index> a = parts_of_edge(m, r), b;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const Index other = g.partner[a[k]];
      const bool in_row =
          (k > 0 && follow(m, g, a[k - 1], a[k])) || (k + 1 < a.size() && follow(m, g, a[k], a[k + 1]));
      if (other != kNone && (whole(other) || in_row)) b.push_back(other);
    }
    if (a.size() != b.size() || std::any_of(a.begin(), a.end(), [&](Index x) { return done[x]; })) continue;
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

/// The garment, or a better one that was found by looking what it would be without one of its seams, each in
/// turn.
Sewn doubted(const Choices& choices, const Limits& limits, RememberingJudge& judge, Sewn garment,
             const RunContext& context) {
  const SeamModel& m = choices.model;
  const Effort effort{tries_for(m, kDoubtsPerRun, m.runs.size() / 2), kDoubtThreshold, 7};
  for (Index r = 0; r < static_cast<Index>(m.runs.size()) && !context.cancelled(); ++r) {
    const Index other = garment.gluing.partner[r];
    if (other <= r || (choices.locked[r] && choices.locked[other])) continue;
    SeamGluing without = garment.gluing;
    without.undo(r);
    Sewn there =
        annealed(choices, without_pair(limits, m, r, other), judge, std::move(without), effort, context);
    if (there.merit > garment.merit + kSameMerit) garment = std::move(there);
  }
  return garment;
}

/// Which panels may be drawn from the other side: none, as the drawing hints, those called back, or a
/// collar's front, which as a lapel shows what is inside elsewhere, alone or with the rest of the collar.
/// Collars without lapels stand, and are drawn as all else is.
std::vector<std::vector<char>> likely_sides(const SeamModel& m, const SeamGluing& g,
                                            const GluingSettings& settings) {
  if (settings.sides_known) return {};
  std::vector<std::vector<char>> sides{g.turned};
  const auto add = [&](const std::vector<char>& turned) {
    if (std::find(sides.begin(), sides.end(), turned) == sides.end()) sides.push_back(turned);
  };
  if (!settings.turned.empty()) add(settings.turned);
  std::vector<char> backs, lapels, collars;
  bool any_lapel = false;
  for (const PieceWords& words : m.words) {
    backs.push_back(words.face < 0);
    lapels.push_back(words.kind == PieceKind::kCollar && words.face > 0);
    collars.push_back(words.kind == PieceKind::kCollar);
    any_lapel = any_lapel || is_lapel(m, static_cast<Index>(collars.size()) - 1);
  }
  add(backs);
  add(lapels);
  if (any_lapel) add(collars);
  return sides;
}

/// A garment with its seams, and what it is worth.
struct Garment {
  FoundSeams found;
  double merit = -std::numeric_limits<double>::max();
};

/// The best garment of a few searches with the edges cut in one way: first run to run, then in series.
Garment best_with_cuts(const pattern::Pattern& pattern, FoundSeams start, std::vector<char> locked,
                       const GluingSettings& settings, const RunContext& context) {
  lengthen(start.gluing, locked, start.model.runs.size());
  const std::vector<std::vector<char>> sides = likely_sides(start.model, start.gluing, settings);
  const bool many = start.model.runs.size() > kManyRuns;
  const std::size_t sided = (many ? 1 : kSidedRestarts) * sides.size();
  const std::size_t restarts = sided + (many ? 1 : kRestarts);
  const Choices choices = choices_of(start.model, locked);
  RememberingJudge judge(start.model, settings, kMemory);
  Garment best;
  double top = best.merit;
  int agreed = 0;
  for (std::size_t k = 0; k < restarts && agreed < kAgree && !context.cancelled(); ++k) {
    const bool keeps_sides = k < sided;
    SeamGluing gluing = start.gluing;
    if (keeps_sides) gluing.turned = sides[k % sides.size()];
    const Limits limits{!settings.sides_known && !keeps_sides, {}};
    const Effort effort{tries_for(start.model, kTriesPerRun), kThreshold, 1 + static_cast<std::uint64_t>(k)};
    Sewn sewn = annealed(choices, limits, judge, std::move(gluing), effort, context);
    sewn = doubted(choices, limits, judge, std::move(sewn), context);
    FoundSeams found{start.model, std::move(sewn.gluing), {}};
    found.seams = sewn_seams(found.model, found.gluing, locked);
    found = sewn_in_series(pattern, std::move(found), locked, settings, context);
    const double merit = gluing_merit(found.model, found.gluing, settings);
    if (merit > top + kSameMerit) {
      top = merit;
      agreed = 0;
    }
    agreed += merit > top - kSameMerit ? 1 : 0;
    if (merit > best.merit) best = {std::move(found), merit};
  }
  return best;
}

/// Where the runs end: the same for models that are cut alike.
std::vector<double> cuts_of(const SeamModel& m) {
  std::vector<double> ends;
  for (const SeamRun& run : m.runs) ends.push_back(run.to);
  return ends;
}

/// The garment with its edges cut in every way that differs from the others, as it is first.
std::vector<FoundSeams> ways_to_cut(const pattern::Pattern& pattern, const FoundSeams& start) {
  std::vector<FoundSeams> ways{start};
  std::vector<std::vector<double>> known{cuts_of(start.model)};
  for (const CutKind kind : {CutKind::kDarts, CutKind::kExactFirst, CutKind::kExactSecond,
                             CutKind::kFirstFirst, CutKind::kSecondFirst, CutKind::kNotches}) {
    FoundSeams cut = start;
    cut.model = with_likely_cuts(pattern, start.model, kind);
    std::vector<double> cuts = cuts_of(cut.model);
    if (std::find(known.begin(), known.end(), cuts) != known.end()) continue;
    known.push_back(std::move(cuts));
    ways.push_back(std::move(cut));
  }
  return ways;
}

/// Tells of `count` parts of work that are done side by side how many are done. The context is told on its
/// own thread alone.
class PartsProgress {
 public:
  PartsProgress(const RunContext& context, std::size_t count, double from, double to)
      : context_(context), count_(count), from_(from), to_(to) {}
  void one_done() {
    const int done = ++done_;
    if (std::this_thread::get_id() != home_) return;
    context_.progress("seams", from_ + (to_ - from_) * done / static_cast<double>(count_));
  }

 private:
  const RunContext& context_;
  std::size_t count_;
  double from_, to_;
  std::atomic<int> done_ = 0;
  std::thread::id home_ = std::this_thread::get_id();
};

/// The best garment over all ways to cut the edges; `start` when nothing is better.
FoundSeams best_garment(const pattern::Pattern& pattern, const FoundSeams& start,
                        const std::vector<char>& locked, const GluingSettings& settings,
                        const RunContext& context, Crew& crew) {
  std::vector<FoundSeams> ways = ways_to_cut(pattern, start);
  std::vector<Garment> garments(ways.size());
  PartsProgress progress(context, ways.size(), 0, kShareOfGarments);
  crew.each(static_cast<int>(ways.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    garments[k] = best_with_cuts(pattern, std::move(ways[k]), locked, settings, context);
    progress.one_done();
  });
  Garment best{start, gluing_merit(start.model, start.gluing, settings)};
  for (Garment& garment : garments)
    if (garment.merit > best.merit) best = std::move(garment);
  return std::move(best.found);
}

/// Whether all runs are of a hood.
bool joins_hood(const SeamModel& m, const std::vector<Index>& runs) {
  return std::all_of(runs.begin(), runs.end(),
                     [&](Index r) { return m.words[m.runs[r].panel].kind == PieceKind::kHood; });
}

/// What is lost when the seam must not be, and the rest may be sewn anew.
double margin_of(const FoundSeam& seam, const FoundSeams& found, const std::vector<char>& fixed,
                 const GluingSettings& settings, const RunContext& context) {
  SeamGluing without = found.gluing;
  std::vector<char> locked = fixed;
  for (const Index r : seam.a) without.undo(r);
  for (const std::vector<Index>* side : {&seam.a, &seam.b})
    for (const Index r : *side) locked[r] = 0;
  const Choices choices = choices_of(found.model, locked);
  // It turns nothing over: a garment seen in a mirror is no other garment. Nor is one whose band is turned.
  Limits limits = without_pair({false, {}}, found.model, seam.a[0], seam.b[0]);
  // Nor is one whose hood is sewn on half by half.
  const std::vector<Index> other_side(seam.b.rbegin(), seam.b.rend());
  const bool hood = joins_hood(found.model, seam.a) || joins_hood(found.model, seam.b);
  if (hood)
    for (std::size_t k = 0; k < seam.a.size(); ++k) limits.forbidden.push_back({seam.a[k], seam.b[k]});
  if (seam.a.size() > 1 && is_whole_border(found.model, found.gluing, seam.a) &&
      is_whole_border(found.model, found.gluing, other_side))
    for (const Index x : seam.a)
      for (const Index y : seam.b) limits.forbidden.push_back({x, y});
  const Effort effort{tries_for(found.model, kDoubtsPerRun, found.seams.size()), kDoubtThreshold, 7};
  RememberingJudge judge(found.model, settings, kMarginMemory);
  const Sewn other = annealed(choices, limits, judge, std::move(without), effort, context);
  return gluing_merit(found.model, found.gluing, settings) - other.merit;
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
  Crew crew(std::min(context.threads, kMostThreads));
  found = best_garment(pattern, found, locked, settings, context, crew);
  locked.resize(found.model.runs.size(), 0);
  for (const FoundSeam& seam : found.seams) {
    if (seam.a.size() < 2) continue;  // cut runs stay as they are
    for (const std::vector<Index>* side : {&seam.a, &seam.b})
      for (const Index r : *side) locked[r] = 1;
  }
  PartsProgress progress(context, found.seams.size(), kShareOfGarments, 1);
  crew.each(static_cast<int>(found.seams.size()), [&](int k) {
    if (context.cancelled()) return;
    FoundSeam& seam = found.seams[static_cast<std::size_t>(k)];
    seam.margin = margin_of(seam, found, locked, settings, context);
    progress.one_done();
  });
  return found;
}

}  // namespace toile::seams
