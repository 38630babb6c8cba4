#include "core/pattern/seams/moves.h"

#include <algorithm>
#include <utility>

#include "core/pattern/seams/folds.h"

namespace toile::seams {
namespace {

constexpr double kWeakest = -1;              // a pair that is worth less is no candidate
constexpr std::size_t kMostCandidates = 12;  // of a run

double best_of(const Candidate& c) { return std::max(c.merit[0], c.merit[1]); }

/// The runs that run a may be sewn to, the best first.
std::vector<Candidate> candidates_of(const SeamModel& m, const std::vector<char>& locked, Index a) {
  std::vector<Candidate> all;
  if (locked[a]) return all;
  for (Index b = 0; b < static_cast<Index>(m.runs.size()); ++b) {
    if (b == a || locked[b] || never_at_fold(m, m.runs[a], m.runs[b])) continue;
    const Candidate c{b, pair_merit(m, a, b)};
    if (best_of(c) > kWeakest) all.push_back(c);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& x, const Candidate& y) { return best_of(x) > best_of(y); });
  if (all.size() > kMostCandidates) all.resize(kMostCandidates);
  return all;
}

bool allowed(const Choices& choices, const Limits& limits, Index a, Index b) {
  if (choices.locked[a] || choices.locked[b]) return false;
  return std::none_of(limits.forbidden.begin(), limits.forbidden.end(),
                      [&](const std::array<Index, 2>& pair) {
                        return (a == pair[0] && b == pair[1]) || (a == pair[1] && b == pair[0]);
                      });
}

bool sew(const Choices& choices, const Limits& limits, SeamGluing& g, Index a, const Candidate& c) {
  if (!allowed(choices, limits, a, c.run) || g.partner[a] == c.run) return false;
  g.undo(a);
  g.undo(c.run);
  g.sew(a, c.run, c.merit);
  return true;
}

/// Sews the same seam on the pieces that mirror those of a and b, where there are such.
void sew_mirrored(const Choices& choices, const Limits& limits, SeamGluing& g, Index a, Index b) {
  const Index ma = choices.model.mirror[a], mb = choices.model.mirror[b];
  if (ma == kNone || mb == kNone || ma == mb) return;
  if (const Candidate* c = choices.candidate(ma, mb)) sew(choices, limits, g, ma, *c);
}

/// Turns the panel over, and the one that mirrors it.
void turn(const SeamModel& m, SeamGluing& g, Index panel) {
  g.turned[panel] = !g.turned[panel];
  const Index twin = m.twin[panel];
  if (twin != kNone && twin != panel) g.turned[twin] = !g.turned[twin];
}

/// Turns all that hangs together with the panel, that itself included.
void turn_part(const SeamModel& m, SeamGluing& g, Index panel) {
  std::vector<char> in(m.words.size(), 0);
  in[panel] = 1;
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t r = 0; r < m.runs.size(); ++r) {
      const Index p = m.runs[r].panel;
      if (!in[p]) continue;
      for (const Index q : {g.partner[r] == kNone ? p : m.runs[g.partner[r]].panel, m.twin[p]}) {
        if (q == kNone || in[q]) continue;
        in[q] = 1;
        grown = true;
      }
    }
  }
  for (std::size_t p = 0; p < in.size(); ++p)
    if (in[p]) g.turned[p] = !g.turned[p];
}

/// Sews run a to one of its better candidates (the least of two draws), and mostly the same on the mirrored
/// pieces; `turned_first`: 1 turns its panel over before, 2 all that hangs on it.
bool sew_anew(const Choices& choices, const Limits& limits, SeamGluing& g, Index a, bool both,
              int turned_first, Numbers& numbers) {
  const std::vector<Candidate>& candidates = choices.candidates[a];
  const std::size_t first = numbers.below(candidates.size()), second = numbers.below(candidates.size());
  const Candidate& c = candidates[std::min(first, second)];
  const Index panel = choices.model.runs[a].panel;
  if (turned_first > 0) g.undo(a);
  if (turned_first == 1 && limits.may_turn) turn(choices.model, g, panel);
  if (turned_first == 2 && limits.may_turn) turn_part(choices.model, g, panel);
  if (!sew(choices, limits, g, a, c)) return false;
  if (both) sew_mirrored(choices, limits, g, a, c.run);
  return true;
}

/// Two sewn pairs change partners: a takes that of another run, whose partner takes a's.
bool exchange(const Choices& choices, const Limits& limits, SeamGluing& g, Index a, bool both,
              Numbers& numbers) {
  const Index b = g.partner[a];
  if (b == kNone || choices.candidates[b].empty()) return false;
  const Candidate& c = choices.candidates[b][numbers.below(choices.candidates[b].size())];
  const Index d = g.partner[c.run];
  const Candidate* rest = d == kNone || d == a ? nullptr : choices.candidate(a, d);
  if (rest == nullptr || !sew(choices, limits, g, b, c) || !sew(choices, limits, g, a, *rest)) return false;
  if (both) {
    sew_mirrored(choices, limits, g, b, c.run);
    sew_mirrored(choices, limits, g, a, d);
  }
  return true;
}

/// Parts run a from its partner, and mostly the mirrored ones.
bool part(const Choices& choices, SeamGluing& g, Index a, bool both) {
  if (g.partner[a] == kNone) return false;
  const Index ma = choices.model.mirror[a];
  if (both && ma != kNone && !choices.locked[ma]) g.undo(ma);
  g.undo(a);
  return true;
}

}  // namespace

const Candidate* Choices::candidate(Index a, Index b) const {
  for (const Candidate& c : candidates[a])
    if (c.run == b) return &c;
  return nullptr;
}

Choices choices_of(const SeamModel& model, const std::vector<char>& locked) {
  Choices choices{model, locked, {}, {}};
  for (Index a = 0; a < static_cast<Index>(model.runs.size()); ++a) {
    choices.candidates.push_back(candidates_of(model, locked, a));
    if (!choices.candidates.back().empty()) choices.open.push_back(a);
  }
  return choices;
}

Limits without_pair(Limits limits, const SeamModel& model, Index a, Index b) {
  limits.forbidden.push_back({a, b});
  // Nor the mirror image of one of them, where no name tells left from right.
  const auto unnamed_image = [&](Index r) {
    const Index image = model.mirror[r];
    return image != kNone && model.runs[image].panel != model.runs[r].panel &&
                   model.words[model.runs[r].panel].side == 0
               ? image
               : r;
  };
  if (unnamed_image(a) != b) {
    limits.forbidden.push_back({unnamed_image(a), b});
    limits.forbidden.push_back({a, unnamed_image(b)});
  }
  for (const Index x : model.same[a]) limits.forbidden.push_back({x, b});
  for (const Index x : model.same[b]) limits.forbidden.push_back({a, x});
  return limits;
}

bool change(const Choices& choices, const Limits& limits, Numbers& numbers, SeamGluing& g) {
  // Of twenty moves fourteen sew anew (two of them with a part of the garment turned over first, two with a
  // panel), three exchange, one parts and two turn a panel.
  constexpr std::size_t kMoves = 20, kPartTurned = 2, kPanelTurned = 4, kSewn = 14, kExchanged = 17,
                        kParted = 18;
  const Index a = choices.open[numbers.below(choices.open.size())];
  const bool both = numbers.below(4) != 0;
  const std::size_t move = numbers.below(kMoves);
  const int turned = move < kPartTurned ? 2 : move < kPanelTurned ? 1 : 0;
  if (move < kSewn) return sew_anew(choices, limits, g, a, both, turned, numbers);
  if (move < kExchanged) return exchange(choices, limits, g, a, both, numbers);
  if (move < kParted) return part(choices, g, a, both);
  if (limits.may_turn) turn(choices.model, g, choices.model.runs[a].panel);
  return limits.may_turn;
}

}  // namespace toile::seams
