#include "core/pattern/dxf/outlines.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/allowance.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/outline.h"

namespace toile::dxf {
namespace {

constexpr double kLarger = 1.001;  // times another loop's area: two drawings of one line differ by less

constexpr double kMuchLost = 0.5;  // share of a piece's area; when less is left, a person should look

std::string percent_text(double share) { return fixed_text(100 * share, 0) + " %"; }

constexpr std::size_t kMostTried = 8;  // lines tried as a piece's sew line: bounds the work on nests

/// Loops, the largest first.
using Candidates = std::vector<const DxfLoop*>;

template <typename Wanted>
Candidates those_of(const std::vector<DxfLoop>& loops, Wanted wanted) {
  Candidates some;
  for (const DxfLoop& loop : loops)
    if (wanted(loop)) some.push_back(&loop);
  std::stable_sort(some.begin(), some.end(),
                   [](const DxfLoop* a, const DxfLoop* b) { return a->area > b->area; });
  return some;
}

/// The candidates that follow the cut line, the largest first.
Candidates followers_of(const DxfLoop& cut, const Candidates& candidates, DxfSewClaim claim) {
  Candidates followers;
  std::size_t tried = 0;
  for (const DxfLoop* sew : candidates) {
    const bool near = sew != &cut && sew->area <= cut.area * kLarger && same_place(sew->box, cut.box);
    if (!near || ++tried > kMostTried) continue;
    const bool same_line = claim == DxfSewClaim::kSaid && is_repeated(*sew, cut);
    if (same_line || is_seam_line(*sew, cut, claim)) followers.push_back(sew);
  }
  return followers;
}

const DxfLoop* first_of(const Candidates& list) { return list.empty() ? nullptr : list.front(); }

/// Whether the layer's name says what its lines are, and that they are no sew lines: sizes, other cloth.
bool names_another_thing(const std::string& layer) {
  const std::string name = lower_case(layer);
  for (const char* word : {"lining", "facing", "fus", "futter", "einlage", "doublure", "forro", "size"})
    if (name.find(word) != std::string::npos) return true;
  static const std::set<std::string> kSizes{"xxs", "xs", "s", "m", "l", "xl", "xxl", "2xl", "3xl", "4xl"};
  return kSizes.contains(name) || number_in<int>(name).value_or(0) > 0;
}

/// Loops of the cut line's own layer with no other one between.
Candidates next_within(const DxfLoops& loops, const DxfLoop& cut) {
  return those_of(loops.outlines, [&](const DxfLoop& loop) {
    return loop.chain->layer == cut.chain->layer && (!loop.parent || &loops.outlines[*loop.parent] == &cut);
  });
}

/// The sew line of a drawing of free layers: on the cut line's own layer, else on the only other layer that
/// has a line along it.
const DxfLoop* free_sew_line_of(const DxfLoops& loops, const DxfLoop& cut) {
  const std::string& layer = cut.chain->layer;
  const auto first = [&](const Candidates& list) {
    return first_of(followers_of(cut, list, DxfSewClaim::kPossible));
  };
  if (const DxfLoop* sew = first(next_within(loops, cut))) return sew;
  const auto is_own = [&](const DxfLoop& loop) { return loop.chain->layer == layer; };
  if (const DxfLoop* sew = first(those_of(loops.inner, is_own))) return sew;
  if (names_another_thing(layer)) return nullptr;
  const Candidates others =
      those_of(loops.outlines, [&](const DxfLoop& loop) { return loop.chain->layer != layer; });
  const Candidates followers = followers_of(cut, others, DxfSewClaim::kPossible);
  for (const DxfLoop* sew : followers)
    if (sew->chain->layer != followers[0]->chain->layer || names_another_thing(sew->chain->layer))
      return nullptr;
  return first_of(followers);
}

const DxfLoop* sew_line_of(const DxfLoops& loops, const DxfLoop& cut, const DxfSewSearch& search) {
  if (cut.depth % 2 != 0) return nullptr;
  if (!search.by_aama) return free_sew_line_of(loops, cut);
  const auto of_role = [&](DxfRole role) {
    return those_of(loops.outlines,
                    [role](const DxfLoop& loop) { return loop.role == role && loop.depth % 2 == 0; });
  };
  const auto best = [&](const Candidates& list, DxfSewClaim claim) {
    return first_of(followers_of(cut, list, claim));
  };
  // Some programs change the two layers' places: then the line on that of sew lines is the outer one.
  if (cut.role == DxfRole::kSew) return best(of_role(DxfRole::kCut), DxfSewClaim::kPossible);
  if (const DxfLoop* sew = best(of_role(DxfRole::kSew), DxfSewClaim::kSaid)) return sew;
  if (const DxfLoop* sew = best(next_within(loops, cut), DxfSewClaim::kPossible)) return sew;
  if (search.on_their_layer) return nullptr;
  const auto is_internal = [](const DxfLoop& loop) { return loop.role == DxfRole::kInternal; };
  if (const DxfLoop* sew = best(those_of(loops.inner, is_internal), DxfSewClaim::kPossible)) return sew;
  const auto is_other = [&](const DxfLoop& loop) {
    return loop.role == DxfRole::kRepeat ||
           (loop.role == DxfRole::kOther && !names_another_thing(loop.chain->layer));
  };
  return best(those_of(loops.inner, is_other), DxfSewClaim::kPossible);
}

/// How the outlines' loops and the pieces are looked at.
struct Outlines {
  const DxfLoops& loops;
  const DxfSeamLines& seams;
  bool by_aama;
};

enum class Inside {
  kNone,
  kRepeated,
  kOtherLayer,
  kALine,  ///< drawn within a piece: told of with the lines
};

/// Whether the loop follows a sew line within it, as lines of top stitches and hems do.
bool follows_a_sew_line(const DxfLoop& loop, const DxfSeamLines& seams) {
  std::size_t tried = 0;
  for (const DxfLoop* sew : seams.sew_of) {
    if (!sew || sew->area <= loop.area || !sew->box.grown(kBoxSlack).contains(loop.box)) continue;
    if (++tried > kMostTried) return false;
    if (is_seam_line(loop, *sew, DxfSewClaim::kPossible)) return true;
  }
  return false;
}

bool meet(const Aabb2& a, const Aabb2& b) { return none_above(a.low, b.high) && none_above(b.low, a.high); }

/// Whether the loop stands on the layer of sew lines where a cut line is, and is not its sew line.
bool is_other_sewing(const Outlines& o, const DxfLoop& loop) {
  if (!o.by_aama || loop.role != DxfRole::kSew) return false;
  return std::any_of(o.loops.outlines.begin(), o.loops.outlines.end(), [&](const DxfLoop& cut) {
    return cut.role == DxfRole::kCut && meet(cut.box, loop.box) &&
           (lies_mostly_within(loop, cut) || lies_mostly_within(cut, loop));
  });
}

/// Whether loop i repeats another one, is a line within a piece, or (in drawings of free layers) lies within
/// a piece of another layer: a pocket's place, a facing, a mark.
Inside inside_other(const Outlines& o, std::size_t i) {
  const DxfLoop& inner = o.loops.outlines[i];
  const bool has_sew_line = o.seams.sew_of[i] != nullptr;
  if (!has_sew_line && (is_other_sewing(o, inner) || follows_a_sew_line(inner, o.seams)))
    return Inside::kALine;
  for (std::size_t k = 0; k < o.loops.outlines.size(); ++k) {
    const DxfLoop& outer = o.loops.outlines[k];
    if (k == i) continue;
    const bool other_layer = !o.by_aama && outer.chain->layer != inner.chain->layer;
    const bool equal = is_repeated(inner, outer);
    const bool first = outer.area > inner.area * kLarger || (equal && k < i);
    if (!first || !(other_layer || equal)) continue;
    // These look through loops or points: asked for every two of a drawing's loops they would take seconds.
    if (!is_covered(inner, outer) || o.seams.is_sew_line(outer)) continue;
    return equal ? Inside::kRepeated : Inside::kOtherLayer;
  }
  return Inside::kNone;
}

/// The piece of a cut line, by its sew line if it has one.
DxfPlaced piece_of(const DxfLoop& cut, const DxfLoop* sew, int id) {
  const DxfLoop& taken = sew ? *sew : cut;
  const DxfChain& c = *taken.chain;
  DxfPlaced placed{{}, &taken, sew ? &cut : nullptr};
  DxfPiece& piece = placed.found.piece;
  piece.outline = c.points;
  piece.breaks = c.breaks;
  piece.turn_points = c.turns;
  piece.breaks_are_edges = c.breaks_are_edges;
  piece.layer = c.layer;
  piece.line = c.line;
  piece.on_sew_line = sew != nullptr || cut.role == DxfRole::kSew;
  placed.found.id = id;
  placed.found.entities = c.entities;
  return placed;
}

void tell_outline(const DxfPlaced& placed, DxfNotes& notes) {
  const DxfChain& c = *placed.loop->chain;
  const int id = placed.found.id;
  tell(notes, c, c.curved ? DxfFate::kConverted : DxfFate::kKept,
       c.curved ? "outline, its arcs drawn out and fitted anew" : "outline", id);
  if (!placed.cut) return;
  const DxfChain& cut = *placed.cut->chain;
  tell(notes, cut, DxfFate::kDropped, "the cut line gives way to the sew line", id);
  notes.warn(cut.line,
             "the cut line (layer " + cut.layer + ") gives way to the sew line (layer " + c.layer + ") in " +
                 line_text(c.line),
             id);
  const double share = placed.loop->area / placed.cut->area;
  if (share < kMuchLost)
    notes.warn(c.line,
               "the sew line encloses " + percent_text(share) +
                   " of what the cut line does: look whether it is the sew line",
               id);
}

/// Warns of pieces of which holes leave little.
void tell_large_holes(const std::vector<DxfPlaced>& placed, DxfNotes& notes) {
  for (const DxfPlaced& p : placed) {
    double open = 0;
    for (const std::vector<Vec2>& hole : p.found.piece.holes) open += std::abs(geometry::signed_area(hole));
    const double left = 1 - open / p.loop->area;
    if (left < kMuchLost)
      notes.warn(p.found.piece.line,
                 "holes take all but " + percent_text(left) +
                     " of the piece: look whether they are cut out, or lines that are drawn in it",
                 p.found.id);
  }
}

/// A closed line without area, such as a line drawn twice: a mark within a piece, a fault elsewhere.
void tell_flat(const DxfChain& chain, const DxfLoops& loops, DxfNotes& notes) {
  tell(notes, chain, DxfFate::kDropped, "it encloses no area");
  for (const DxfLoop& loop : loops.outlines)
    if (loop.box.grown(kBoxSlack).contains(bounding_box(chain.points))) return;
  notes.fail({"dxf.zero_area", "The outline encloses no area.",
              line_text(chain.line) + ", near " + pattern::place_text(chain.points[0])});
  notes.warn(chain.line, "an outline encloses no area and is left out", -1, chain.points[0]);
}

/// Layers for which there are better uses, and on which some programs put sew lines.
bool may_hold_sew_lines(DxfRole role) {
  return role == DxfRole::kInternal || role == DxfRole::kRepeat || role == DxfRole::kOther;
}

void add_hole(const DxfChain& chain, DxfFound& owner, DxfNotes& notes) {
  owner.piece.holes.push_back(chain.points);
  tell(notes, chain, chain.curved ? DxfFate::kConverted : DxfFate::kKept, "hole", owner.id);
}

/// Nothing but where it lies says that this closed line is a hole.
void tell_cut_out(const DxfChain& chain, int piece, DxfNotes& notes) {
  notes.warn(
      chain.line,
      "a closed line within the piece is cut out as a hole; if it is only drawn there, it belongs on a "
      "layer of lines within pieces, such as 8",
      piece, chain.points[0]);
}

}  // namespace

Result<DxfLoops> loops_of(const std::vector<DxfChain>& chains, const DxfRoles& roles, std::size_t most) {
  DxfLoops loops;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const bool outline = roles.makes_outlines(i);
    const bool maybe_sew = !roles.told[i] && may_hold_sew_lines(roles.of[i]);
    if (!chains[i].closed || !(outline || maybe_sew)) continue;
    const DxfLoop loop = loop_of(chains[i], i, roles.of[i]);
    if (loop.area < pattern::kLeastArea && geometry::is_flat(chains[i].points, pattern::kJointTolerance)) {
      if (outline) loops.flat.push_back(i);
      continue;
    }
    (outline ? loops.outlines : loops.inner).push_back(loop);
  }
  if (loops.outlines.size() > most)
    return Error{"dxf.too_large",
                 "The drawing has more than " + std::to_string(most) + " closed outlines, the limit.", "",
                 ErrorKind::kTooLarge};
  loops.outlines = nested(std::move(loops.outlines));
  return loops;
}

bool DxfSeamLines::is_sew_line(const DxfLoop& loop) const {
  return std::find(sew_of.begin(), sew_of.end(), &loop) != sew_of.end();
}

DxfSeamLines seam_lines_of(const DxfLoops& loops, const DxfSewSearch& search) {
  const std::vector<DxfLoop>& all = loops.outlines;
  DxfSeamLines seams;
  for (const DxfLoop& loop : all) seams.parents.push_back(loop.parent);
  // From the outside: what is a sew line is no cut line of what lies in it.
  seams.sew_of.resize(all.size(), nullptr);
  for (const DxfLoop* loop : those_of(all, [](const DxfLoop&) { return true; }))
    if (!seams.is_sew_line(*loop))
      seams.sew_of[std::size_t(loop - all.data())] = sew_line_of(loops, *loop, search);
  // A sew line on another layer, or one that touches its cut line, lies in that one all the same.
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const DxfLoop& loop) { return &loop == seams.sew_of[i]; });
    if (at == all.end() || at->area >= all[i].area) continue;
    std::optional<std::size_t>& parent = seams.parents[std::size_t(at - all.begin())];
    if (!parent) parent = i;
  }
  std::vector<bool> sews;  // of each loop
  sews.reserve(all.size());
  for (const DxfLoop& loop : all) sews.push_back(seams.is_sew_line(loop));
  for (std::size_t i = 0; i < all.size(); ++i) {
    int depth = 0;
    for (auto parent = seams.parents[i]; parent; parent = seams.parents[*parent])
      depth += sews[*parent] ? 0 : 1;
    seams.depths.push_back(depth);
  }
  return seams;
}

DxfPieces outlined(const std::vector<DxfChain>& chains, const DxfLoops& loops, const DxfSeamLines& seams,
                   bool by_aama, int first_id) {
  DxfPieces pieces;
  pieces.used.assign(chains.size(), false);
  for (const DxfLoop& loop : loops.outlines) pieces.used[loop.number] = true;
  for (const std::size_t i : loops.flat) {
    pieces.used[i] = true;
    tell_flat(chains[i], loops, pieces.notes);
  }
  int id = first_id;
  for (std::size_t i = 0; i < loops.outlines.size(); ++i) {
    if (!seams.is_outer(i) || seams.is_sew_line(loops.outlines[i])) continue;
    const Inside inside = inside_other({loops, seams, by_aama}, i);
    if (inside == Inside::kALine) {
      pieces.used[loops.outlines[i].number] = false;
      continue;
    }
    if (inside != Inside::kNone) {
      tell(pieces.notes, *loops.outlines[i].chain, DxfFate::kDropped,
           inside == Inside::kRepeated ? "drawn a second time" : "within a piece of another layer");
      continue;
    }
    pieces.placed.push_back(piece_of(loops.outlines[i], seams.sew_of[i], id++));
    tell_outline(pieces.placed.back(), pieces.notes);
    pieces.used[pieces.placed.back().loop->number] = true;
  }
  return pieces;
}

DxfPieces with_holes(DxfPieces pieces, const std::vector<DxfChain>& chains, const DxfRoles& roles,
                     const DxfLoops& loops, const DxfSeamLines& seams) {
  std::vector<DxfPlaced>& placed = pieces.placed;
  for (std::size_t i = 0; i < loops.outlines.size(); ++i) {
    const DxfLoop& loop = loops.outlines[i];
    if (seams.is_outer(i) || seams.is_sew_line(loop)) continue;
    if (is_other_sewing({loops, seams, roles.by_aama}, loop) || follows_a_sew_line(loop, seams)) {
      pieces.used[loop.number] = false;
      continue;
    }
    const DxfLoop* around = &loops.outlines[*seams.parents[i]];
    // In drawings of free layers the hole lies within the seam line, which lies within the cut line.
    const auto owner = std::find_if(placed.begin(), placed.end(), [&](const DxfPlaced& p) {
      return p.loop == around || (p.cut == around && lies_within(loop, *p.loop));
    });
    if (owner == placed.end()) {
      tell(pieces.notes, *loop.chain, DxfFate::kDropped, "a hole outside of any piece");
    } else {
      add_hole(*loop.chain, owner->found, pieces.notes);
      tell_cut_out(*loop.chain, owner->found.id, pieces.notes);
    }
  }
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (!chains[i].closed || roles.of[i] != DxfRole::kCutout || pieces.used[i]) continue;
    const DxfLoop hole = loop_of(chains[i], i, roles.of[i]);
    const auto owner = std::find_if(placed.begin(), placed.end(),
                                    [&](const DxfPlaced& p) { return lies_within(hole, *p.loop); });
    if (hole.area < pattern::kLeastArea || owner == placed.end()) continue;
    pieces.used[i] = true;
    add_hole(chains[i], owner->found, pieces.notes);
  }
  tell_large_holes(placed, pieces.notes);
  return pieces;
}

}  // namespace toile::dxf
