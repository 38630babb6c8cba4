#include "core/pattern/seams/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/text.h"
#include "core/pattern/curve.h"
#include "core/pattern/outline.h"

namespace toile::seams {
namespace {

constexpr double kMeet = 1;       // mm: ends this close are one point
constexpr double kRatio = 3;      // of lengths, that is hardly meant
constexpr double kTouch = 1e-9;   // of an edge: parts may share an end
constexpr double kSliver = 1e-9;  // mm

const pattern::PanelEdge* edge_of(const pattern::Pattern& pattern, const pattern::SeamEdge& e) {
  if (e.panel < 0 || e.panel >= static_cast<Index>(pattern.panels.size())) return nullptr;
  const std::vector<const pattern::PanelEdge*> edges = pattern::edges_of(pattern.panels[e.panel]);
  return e.edge >= 0 && e.edge < static_cast<Index>(edges.size()) ? edges[e.edge] : nullptr;
}

std::string mm_text(double mm) {
  return fixed_text(std::round(mm * 10) / 10, 1) + " mm";  // a half goes up, whatever its last bit
}

/// An end of a side, or of an item in it.
struct End {
  Index panel;
  Vec2 at;
};

/// Where the item starts (`last` false) or ends when it is traversed as the seam says.
End end_of(const pattern::Pattern& pattern, const pattern::SeamEdge& e, bool last) {
  const pattern::PanelEdge& edge = *edge_of(pattern, e);
  return {e.panel,
          pattern::point_at_length(edge, (last != e.reversed ? e.to : e.from) * pattern::arc_length(edge))};
}

End start_of(const pattern::Pattern& p, const std::vector<pattern::SeamEdge>& side) {
  return end_of(p, side.front(), false);
}
End finish_of(const pattern::Pattern& p, const std::vector<pattern::SeamEdge>& side) {
  return end_of(p, side.back(), true);
}

/// Points of pieces, and which of them the seams bring together.
class Meetings {
 public:
  /// All seams but number `without` and those that are left out.
  Meetings(const pattern::Pattern& pattern, std::size_t without, const std::vector<bool>& left_out) {
    for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
      if (s == without || left_out[s]) continue;
      const pattern::Seam& seam = pattern.seams[s];
      join(start_of(pattern, seam.a),
           seam.same_direction ? start_of(pattern, seam.b) : finish_of(pattern, seam.b));
      join(finish_of(pattern, seam.a),
           seam.same_direction ? finish_of(pattern, seam.b) : start_of(pattern, seam.b));
    }
  }
  bool meet(const End& x, const End& y) {
    const Index a = place_of(x), b = place_of(y);
    return places_.root(a) == places_.root(b);
  }

 private:
  Index place_of(const End& end) {
    for (std::size_t i = 0; i < ends_.size(); ++i)
      if (ends_[i].panel == end.panel && length(ends_[i].at - end.at) <= kMeet) return static_cast<Index>(i);
    ends_.push_back(end);
    places_.add();
    return static_cast<Index>(ends_.size() - 1);
  }
  void join(const End& x, const End& y) {
    const Index a = place_of(x);
    places_.join(a, place_of(y));
  }

  std::vector<End> ends_;
  DisjointSets places_;
};

struct Checker {
  const pattern::Pattern& pattern;
  std::vector<SeamIssue> issues;

  std::string place(const pattern::Seam& seam, char side, std::size_t item) const {
    const pattern::SeamEdge& e = (side == 'a' ? seam.a : seam.b)[item];
    std::string text = "seam " + seam.id + ", side " + side + ", item " + std::to_string(item);
    if (const pattern::PanelEdge* edge = edge_of(pattern, e))
      text += " (piece " + pattern.panels[e.panel].id + ", edge " + edge->id + ")";
    return text;
  }
  void add(SeamIssueKind kind, const pattern::Seam& seam, std::string message, std::string where,
           const End& end) {
    const auto index = static_cast<Index>(&seam - pattern.seams.data());
    issues.push_back({kind, index, std::move(message), std::move(where), end.panel, end.at});
  }

  struct Taken {
    pattern::SeamEdge part;
    std::string place;
  };
  std::vector<Taken> taken;

  void check_item(const pattern::Seam& seam, char side, std::size_t item) {
    const pattern::SeamEdge& e = (side == 'a' ? seam.a : seam.b)[item];
    const std::string where = place(seam, side, item);
    if (edge_of(pattern, e) == nullptr)
      return add(SeamIssueKind::kReference, seam, "There is no such edge.", where, {kNone, {}});
    if (!(e.from >= 0 && e.to <= 1 && e.to - e.from > kTouch))
      return add(SeamIssueKind::kRange, seam, "From and to are fractions of the edge, from below to.", where,
                 {e.panel, edge_of(pattern, e)->curves.front().p0});
    for (const Taken& t : taken) {
      if (t.part.panel != e.panel || t.part.edge != e.edge) continue;
      if (std::min(t.part.to, e.to) - std::max(t.part.from, e.from) <= kTouch) continue;
      add(SeamIssueKind::kSewnTwice, seam, "This is sewn in " + t.place + " already.", where,
          end_of(pattern, e, false));
    }
    taken.push_back({e, where});
  }

  /// Whether the seam can be followed at all.
  void check_parts(const pattern::Seam& seam) {
    for (const char side : {'a', 'b'}) {
      const std::vector<pattern::SeamEdge>& items = side == 'a' ? seam.a : seam.b;
      if (items.empty())
        add(SeamIssueKind::kEmptySide, seam, "This side has no edges.", "seam " + seam.id + ", side " + side,
            {kNone, {}});
      for (std::size_t i = 0; i < items.size(); ++i) check_item(seam, side, i);
    }
  }

  void check_series(const pattern::Seam& seam, char side, Meetings& others) {
    const std::vector<pattern::SeamEdge>& items = side == 'a' ? seam.a : seam.b;
    for (std::size_t i = 1; i < items.size(); ++i) {
      const End before = end_of(pattern, items[i - 1], true), after = end_of(pattern, items[i], false);
      if (others.meet(before, after)) continue;
      const bool here = before.panel == after.panel;
      add(SeamIssueKind::kNotContinuous, seam,
          here ? "The edge starts " + mm_text(length(after.at - before.at)) +
                     " from where the one before it ends, at " + pattern::place_text(before.at) + "."
               : "No seam brings its start to where the edge before it ends, at " +
                     pattern::place_text(before.at) + ".",
          place(seam, side, i), after);
    }
  }

  void check_lengths(const pattern::Seam& seam) {
    const double a = series_length(pattern, seam.a), b = series_length(pattern, seam.b);
    if (std::max(a, b) <= kRatio * std::max(std::min(a, b), kSliver)) return;
    add(SeamIssueKind::kLengthRatio, seam, mm_text(a) + " are sewn to " + mm_text(b) + ": over 1 to 3.",
        "seam " + seam.id, start_of(pattern, seam.a));
  }

  void check_loop(const pattern::Seam& seam, Meetings& others) {
    const bool round_a = others.meet(start_of(pattern, seam.a), finish_of(pattern, seam.a));
    const bool round_b = others.meet(start_of(pattern, seam.b), finish_of(pattern, seam.b));
    if (round_a == round_b) return;
    const std::vector<pattern::SeamEdge>& open = round_a ? seam.b : seam.a;
    add(SeamIssueKind::kOpenLoop, seam,
        std::string("Side ") + (round_a ? "a" : "b") +
            " goes round and comes back to its start, but the other side does not.",
        "seam " + seam.id, finish_of(pattern, open));
  }

  /// The other way round, the ends would meet where other seams bring them together.
  bool ends_say_twisted(const pattern::Seam& seam, Meetings& others) const {
    const End a0 = start_of(pattern, seam.a), a1 = finish_of(pattern, seam.a);
    const End b0 = start_of(pattern, seam.b), b1 = finish_of(pattern, seam.b);
    const int along = others.meet(a0, b0) + others.meet(a1, b1);
    const int against = others.meet(a0, b1) + others.meet(a1, b0);
    return seam.same_direction ? against > along : along > against;
  }
};

/// Which pieces are drawn from the same side, as the seams have it: a seam that contradicts the ones before
/// it would make a surface of one side.
class Sides {
 public:
  explicit Sides(std::size_t panels) : parent_(panels), other_(panels, false) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  /// False when the two are known to be the other way.
  bool join(Index a, Index b, bool other) {
    bool side_a = false, side_b = false;
    const std::size_t ra = root(static_cast<std::size_t>(a), side_a),
                      rb = root(static_cast<std::size_t>(b), side_b);
    if (ra == rb) return (side_a != side_b) == other;
    parent_[rb] = ra;
    other_[rb] = (side_a != side_b) != other;
    return true;
  }

 private:
  std::size_t root(std::size_t i, bool& side) const {
    while (parent_[i] != i) {
      side = side != other_[i];
      i = parent_[i];
    }
    return i;
  }
  std::vector<std::size_t> parent_;
  std::vector<bool> other_;
};

/// Joins all pieces of the seam; false when that contradicts what is known.
bool join_sides(const pattern::Seam& seam, Sides& sides) {
  const pattern::SeamEdge& first = seam.a.front();
  bool agrees = true;
  for (const pattern::SeamEdge& e : seam.a)
    agrees = sides.join(first.panel, e.panel, e.reversed != first.reversed) && agrees;
  for (const pattern::SeamEdge& e : seam.b)
    agrees =
        sides.join(first.panel, e.panel, (e.reversed != first.reversed) != seam.same_direction) && agrees;
  return agrees;
}

struct IssueRow {
  SeamIssueKind kind;
  std::string_view code;
  bool error;
};

// A row for each kind, in the order of the enumerators.
constexpr std::array<IssueRow, kSeamIssueKindCount> kIssueTable{
    {{SeamIssueKind::kReference, "seam.reference", true},
     {SeamIssueKind::kRange, "seam.range", true},
     {SeamIssueKind::kSewnTwice, "seam.sewn_twice", true},
     {SeamIssueKind::kEmptySide, "seam.empty_side", true},
     {SeamIssueKind::kNotContinuous, "seam.not_continuous", false},
     {SeamIssueKind::kTwisted, "seam.twisted", false},
     {SeamIssueKind::kLengthRatio, "seam.length_ratio", false},
     {SeamIssueKind::kOpenLoop, "seam.open_loop", false}}};

}  // namespace

std::string_view code_of(SeamIssueKind kind) { return kIssueTable.at(static_cast<std::size_t>(kind)).code; }

bool is_error(SeamIssueKind kind) { return kIssueTable.at(static_cast<std::size_t>(kind)).error; }

double series_length(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& series) {
  double sum = 0;
  for (const pattern::SeamEdge& e : series)
    sum += (e.to - e.from) * pattern::arc_length(*edge_of(pattern, e));
  return sum;
}

std::vector<SeamIssue> check_seams(const pattern::Pattern& pattern) {
  Checker checker{pattern, {}, {}};
  for (const pattern::Seam& seam : pattern.seams) checker.check_parts(seam);
  const auto broken = [](const SeamIssue& i) { return i.kind != SeamIssueKind::kSewnTwice; };
  if (std::any_of(checker.issues.begin(), checker.issues.end(), broken)) return std::move(checker.issues);
  const std::size_t count = pattern.seams.size();
  const std::vector<bool> all(count, false);
  std::vector<bool> torn(count, false);  // their ends say nothing of the other seams
  for (std::size_t s = 0; s < count; ++s) {
    const std::size_t before = checker.issues.size();
    Meetings others(pattern, s, all);
    checker.check_series(pattern.seams[s], 'a', others);
    checker.check_series(pattern.seams[s], 'b', others);
    torn[s] = checker.issues.size() > before;
  }
  Sides sides(pattern.panels.size());
  for (std::size_t s = 0; s < count; ++s) {
    if (torn[s]) continue;
    const pattern::Seam& seam = pattern.seams[s];
    Meetings others(pattern, s, torn);
    checker.check_lengths(seam);
    checker.check_loop(seam, others);
    const bool one_sided = !join_sides(seam, sides);
    if (one_sided || checker.ends_say_twisted(seam, others))
      checker.add(SeamIssueKind::kTwisted, seam,
                  "The seam runs the other way than the seams beside it; turn its direction.",
                  "seam " + seam.id, start_of(pattern, seam.a));
  }
  return std::move(checker.issues);
}

}  // namespace toile::seams
