#include "core/pattern/dxf/outlines.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/pattern/dxf/groups.h"
#include "core/pattern/outline.h"

namespace toile::dxf {
namespace {

constexpr double kLarger = 1.001;  // times another loop's area: two drawings of one line differ by less

/// Whether `sew` is the sew line within the cut line `loops.outlines[i]`.
bool is_sew_line_of(const DxfLoops& loops, std::size_t i, const DxfLoop& sew, bool by_aama) {
  const DxfLoop& cut = loops.outlines[i];
  if (&sew == &cut || sew.area > cut.area * kLarger) return false;
  const bool on_sew_layer = by_aama && sew.role == DxfRole::sew && sew.depth % 2 == 0;
  if (on_sew_layer) return same_place(sew.box, cut.box) && (is_covered(sew, cut) || is_seam_line(sew, cut));
  return sew.parent == i && is_seam_line(sew, cut);
}

const DxfLoop* sew_line_of(const DxfLoops& loops, std::size_t i, bool by_aama) {
  const DxfLoop& cut = loops.outlines[i];
  if (cut.role != DxfRole::cut || cut.depth % 2 != 0) return nullptr;
  for (const DxfLoop& sew : loops.outlines)
    if (is_sew_line_of(loops, i, sew, by_aama)) return &sew;
  for (const DxfLoop& sew : loops.inner)
    if (is_seam_line(sew, cut)) return &sew;
  return nullptr;
}

/// How the outlines' loops and the pieces are looked at.
struct Outlines {
  const DxfLoops& loops;
  const DxfSeamLines& seams;
  bool by_aama;
};

enum class Inside { none, repeated, other_layer };

/// Whether loop i repeats another one, or (in drawings of free layers) lies within a piece of another layer:
/// a pocket's place, a facing, a mark.
Inside inside_other(const Outlines& o, std::size_t i) {
  const DxfLoop& inner = o.loops.outlines[i];
  for (std::size_t k = 0; k < o.loops.outlines.size(); ++k) {
    const DxfLoop& outer = o.loops.outlines[k];
    if (k == i || o.seams.is_sew_line(outer)) continue;
    const bool other_layer = !o.by_aama && outer.chain->layer != inner.chain->layer;
    const bool equal = is_repeated(inner, outer);
    const bool first = outer.area > inner.area * kLarger || (equal && k < i);
    if (!first || !(other_layer || equal) || !is_covered(inner, outer)) continue;
    return equal ? Inside::repeated : Inside::other_layer;
  }
  return Inside::none;
}

/// The piece of a cut line, by its sew line if it has one.
DxfPlaced piece_of(const DxfLoop& cut, const DxfLoop* sew, int id) {
  const DxfLoop& taken = sew ? *sew : cut;
  const DxfChain& c = *taken.chain;
  DxfPlaced placed{{}, &taken, sew ? &cut : nullptr};
  DxfPiece& piece = placed.found.piece;
  piece.outline = c.points;
  piece.breaks = c.breaks;
  piece.breaks_are_edges = c.breaks_are_edges;
  piece.layer = c.layer;
  piece.line = c.line;
  piece.on_sew_line = sew != nullptr || cut.role == DxfRole::sew;
  placed.found.id = id;
  placed.found.entities = c.entities;
  return placed;
}

void tell_outline(const DxfPlaced& placed, DxfNotes& notes) {
  const DxfChain& c = *placed.loop->chain;
  const int id = placed.found.id;
  tell(notes, c, c.curved ? DxfFate::converted : DxfFate::kept,
       c.curved ? "outline, its arcs drawn out and fitted anew" : "outline", id);
  if (!placed.cut) return;
  const DxfChain& cut = *placed.cut->chain;
  tell(notes, cut, DxfFate::dropped, "the cut line gives way to the sew line", id);
  notes.warn(cut.line,
             "the cut line (layer " + cut.layer + ") gives way to the sew line (layer " + c.layer + ") in " +
                 line_text(c.line),
             id);
}

/// A closed line without area, such as a line drawn twice: a mark within a piece, a fault elsewhere.
void tell_flat(const DxfChain& chain, const DxfLoops& loops, DxfNotes& notes) {
  tell(notes, chain, DxfFate::dropped, "it encloses no area");
  for (const DxfLoop& loop : loops.outlines)
    if (loop.box.grown(kBoxSlack).contains(bounding_box(chain.points))) return;
  notes.fail({"dxf.zero_area", "The outline encloses no area.",
              line_text(chain.line) + ", near " + pattern::place_text(chain.points[0])});
  notes.warn(chain.line, "an outline encloses no area and is left out", -1, chain.points[0]);
}

void add_hole(const DxfChain& chain, DxfFound& owner, DxfNotes& notes) {
  owner.piece.holes.push_back(chain.points);
  tell(notes, chain, chain.curved ? DxfFate::converted : DxfFate::kept, "hole", owner.id);
}

}  // namespace

Result<DxfLoops> loops_of(const std::vector<DxfChain>& chains, const DxfRoles& roles, std::size_t most) {
  DxfLoops loops;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const bool outline = roles.makes_outlines(i);
    if (!chains[i].closed || !(outline || roles.of[i] == DxfRole::internal)) continue;
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

DxfSeamLines seam_lines_of(const DxfLoops& loops, bool by_aama) {
  DxfSeamLines seams;
  for (std::size_t i = 0; i < loops.outlines.size(); ++i)
    seams.sew_of.push_back(sew_line_of(loops, i, by_aama));
  for (const DxfLoop& loop : loops.outlines) {
    int around = 0;
    for (auto parent = loop.parent; parent; parent = loops.outlines[*parent].parent)
      around += seams.is_sew_line(loops.outlines[*parent]) ? 1 : 0;
    seams.around.push_back(around);
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
    if (!seams.is_outer(loops, i) || seams.is_sew_line(loops.outlines[i])) continue;
    const Inside inside = inside_other({loops, seams, by_aama}, i);
    if (inside != Inside::none) {
      tell(pieces.notes, *loops.outlines[i].chain, DxfFate::dropped,
           inside == Inside::repeated ? "drawn a second time" : "within a piece of another layer");
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
    if (seams.is_outer(loops, i) || seams.is_sew_line(loop)) continue;
    const DxfLoop* around = &loops.outlines[*loop.parent];
    // In drawings of free layers the hole lies within the seam line, which lies within the cut line.
    const auto owner = std::find_if(placed.begin(), placed.end(), [&](const DxfPlaced& p) {
      return p.loop == around || (p.cut == around && lies_within(loop, *p.loop));
    });
    if (owner == placed.end()) {
      tell(pieces.notes, *loop.chain, DxfFate::dropped, "a hole outside of any piece");
    } else {
      add_hole(*loop.chain, owner->found, pieces.notes);
    }
  }
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (!roles.by_aama || !chains[i].closed || roles.of[i] != DxfRole::cutout || pieces.used[i]) continue;
    const DxfLoop hole = loop_of(chains[i], i, roles.of[i]);
    const auto owner = std::find_if(placed.begin(), placed.end(),
                                    [&](const DxfPlaced& p) { return lies_within(hole, *p.loop); });
    if (hole.area < pattern::kLeastArea || owner == placed.end()) continue;
    pieces.used[i] = true;
    add_hole(chains[i], owner->found, pieces.notes);
  }
  return pieces;
}

}  // namespace toile::dxf
