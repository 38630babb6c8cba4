#include "core/pattern/dxf/pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "core/pattern/dxf/fold.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/layers.h"
#include "core/pattern/dxf/nest.h"
#include "core/pattern/dxf/trim.h"
#include "core/pattern/outline.h"

namespace toile {
namespace {

constexpr double kBoxSlack = 1;        // mm, by which a line may stick out of the piece it belongs to
constexpr double kWidestGap = 1;       // mm that are closed without a question
constexpr double kSliver = 1e-3;       // of the line's length squared: less area than that is no outline
constexpr double kWidestShare = 2e-3;  // of the line's length, likewise
constexpr std::size_t kMostInternals = 500;  // lines within a piece: unfolded, a document takes twice as many
constexpr std::size_t kMostInternalPoints = 4999;  // likewise of one of them, and one that closes it

/// The error that a chain should close and does not.
Error open_outline(const DxfChain& chain) {
  const Vec2 a = chain.points.front(), b = chain.points.back();
  char width[40];
  std::snprintf(width, sizeof width, "%.4g", length(a - b));
  return {"dxf.open_outline",
          "The outline on layer " + chain.layer + " is open between " + place_text(a) + " and " +
              place_text(b) + ": a gap of " + width + " mm. Close it in the drawing, or allow wider joints.",
          line_text(chain.line)};
}

class Sorter {
 public:
  Sorter(const std::vector<DxfPart>& parts, DxfContext& context, int& next_id)
      : parts_(parts), context_(context), log_(context.log), next_id_(next_id) {}

  Result<std::vector<DxfFound>> run() {
    std::vector<DxfChain> chains = TRY(chains_of(parts_, context_));
    chains_ = std::move(chains);
    find_roles();
    close_chains();
    if (auto error = collect()) return *error;
    nest(loops_);
    find_seam_lines();
    make_pieces();
    add_holes();
    for (std::size_t i = 0; i < chains_.size(); ++i)
      if (!used_[i]) place_rest(chains_[i], roles_[i]);
    std::vector<DxfTrimmings> trimmings;
    for (DxfPlaced& placed : placed_) trimmings.push_back({&placed.found, placed.loop->box});
    place_marks(parts_, by_aama_, trimmings, context_);
    unfold();
    std::vector<DxfFound> found;
    for (DxfPlaced& placed : placed_) found.push_back(std::move(placed.found));
    return found;
  }

 private:
  struct DxfPlaced {
    DxfFound found;
    const DxfLoop* loop = nullptr;  // its outline
    const DxfLoop* cut = nullptr;   // the cut line around it, when the outline is the sew line
  };

  /// Layers have AAMA's meaning where any line stands on those of outlines.
  void find_roles() {
    bool repeated = false;
    for (const DxfChain& c : chains_) {
      const DxfRole role = role_of_layer(c.layer), deep = repeated_role(c.layer);
      by_aama_ = by_aama_ || role == DxfRole::cut || role == DxfRole::sew;
      repeated = repeated || (deep != role && (deep == DxfRole::cut || deep == DxfRole::sew));
    }
    const bool only_repeated = !by_aama_ && repeated;
    by_aama_ = by_aama_ || repeated;
    for (const DxfChain& c : chains_)
      roles_.push_back(!by_aama_       ? DxfRole::cut
                       : only_repeated ? repeated_role(c.layer)
                                       : role_of_layer(c.layer));
    for (std::size_t i = 0; i < chains_.size(); ++i)
      if (chains_[i].inner && makes_outlines(i)) roles_[i] = DxfRole::internal;
    used_.assign(chains_.size(), false);
    for (std::size_t i = 0; i < chains_.size(); ++i)
      if (by_aama_ && roles_[i] == DxfRole::mirror && !chains_[i].closed)
        if (const auto axis = fold_axis(chains_[i].points)) folds_.emplace_back(i, *axis);
  }

  void mark(const DxfChain& chain, DxfFate fate, const std::string& reason, int piece = -1) {
    for (const std::size_t entity : chain.entities) log_.mark(entity, fate, reason, piece);
  }

  void drop(const DxfChain& chain, const std::string& reason, int piece = -1) {
    mark(chain, DxfFate::dropped, reason, piece);
  }

  bool makes_outlines(std::size_t i) const { return roles_[i] == DxfRole::cut || roles_[i] == DxfRole::sew; }

  /// Closes outlines that end at a fold or stop a little short.
  void close_chains() {
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      DxfChain& chain = chains_[i];
      if (chain.closed || !makes_outlines(i) || chain.points.size() < 3) continue;
      const double gap = length(chain.points.front() - chain.points.back());
      const double way = polyline_length(chain.points);
      const bool at_fold = std::any_of(folds_.begin(), folds_.end(), [&](const auto& fold) {
        return closes_at_fold(chain.points, fold.second) && !spans_fold(chain.points, fold.second);
      });
      if (!at_fold && (gap > std::max(kWidestGap, kWidestShare * way) || gap > way / 4 ||
                       std::abs(signed_area(chain.points)) < kSliver * way * way))
        continue;
      chain.closed = true;
      if (at_fold) continue;
      char width[40];
      std::snprintf(width, sizeof width, "%.3g", gap);
      log_.warn(chain.line,
                "the outline on layer " + chain.layer + " had a gap of " + width + " mm and was closed", -1,
                chain.points.back());
    }
  }

  std::optional<Error> collect() {
    std::vector<std::size_t> flat;
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      const DxfChain& chain = chains_[i];
      const bool candidate = makes_outlines(i) || roles_[i] == DxfRole::internal;
      if (!chain.closed || !candidate) continue;
      const DxfLoop loop = loop_of(chain, roles_[i]);
      if (loop.area < kLeastArea && is_flat(chain.points, kJointTolerance)) {
        if (makes_outlines(i)) flat.push_back(i);
        continue;
      }
      if (makes_outlines(i)) used_[i] = true;
      (makes_outlines(i) ? loops_ : inner_loops_).push_back(loop);
    }
    if (loops_.size() > context_.settings.max_loops)
      return Error{"dxf.too_large",
                   "The drawing has more than " + std::to_string(context_.settings.max_loops) +
                       " closed outlines, the limit.",
                   ""};
    for (const std::size_t i : flat) sort_flat(i);
    return std::nullopt;
  }

  /// A closed line without area, such as a line drawn twice: a mark within a piece, a fault elsewhere.
  void sort_flat(std::size_t i) {
    const DxfChain& chain = chains_[i];
    used_[i] = true;
    drop(chain, "it encloses no area");
    for (const DxfLoop& loop : loops_)
      if (loop.box.grown(kBoxSlack).contains(bounding_box(chain.points))) return;
    context_.fail({"dxf.zero_area", "The outline encloses no area.",
                   line_text(chain.line) + ", near " + place_text(chain.points[0])});
    log_.warn(chain.line, "an outline encloses no area and is left out", -1, chain.points[0]);
  }

  /// A loop with none or two around it; seam lines do not count, since they part no cloth.
  bool is_outer(std::size_t i) const { return (loops_[i].depth - below_seams_[i]) % 2 == 0; }

  int seams_around(std::size_t i) const {
    int count = 0;
    for (auto parent = loops_[i].parent; parent; parent = loops_[*parent].parent)
      count += is_seam_line_of_any(loops_[*parent]) ? 1 : 0;
    return count;
  }

  /// Finds the sew line of each cut line: on layer 14 within it, on layer 8, or in drawings of free layers
  /// the next loop inside, where those follow it at the width of an allowance.
  void find_seam_lines() {
    sew_of_.assign(loops_.size(), nullptr);
    below_seams_.assign(loops_.size(), 0);
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const DxfLoop& cut = loops_[i];
      if (cut.role != DxfRole::cut || !is_outer(i)) continue;
      for (std::size_t k = 0; k < loops_.size() && !sew_of_[i]; ++k) {
        const DxfLoop& sew = loops_[k];
        if (k == i || sew.area > cut.area * 1.001) continue;
        const bool on_sew_layer = by_aama_ && sew.role == DxfRole::sew && sew.depth % 2 == 0;
        if (on_sew_layer ? same_place(sew.box, cut.box) && (is_covered(sew, cut) || is_seam_line(sew, cut))
                         : sew.parent == i && is_seam_line(sew, cut))
          sew_of_[i] = &sew;
      }
      for (std::size_t k = 0; k < inner_loops_.size() && !sew_of_[i]; ++k)
        if (is_seam_line(inner_loops_[k], cut)) sew_of_[i] = &inner_loops_[k];
    }
    for (std::size_t i = 0; i < loops_.size(); ++i) below_seams_[i] = seams_around(i);
  }

  bool is_seam_line_of_any(const DxfLoop& loop) const {
    return std::find(sew_of_.begin(), sew_of_.end(), &loop) != sew_of_.end();
  }

  void make_pieces() {
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (!is_outer(i) || is_seam_line_of_any(loops_[i]) || is_inside_other(i)) continue;
      const DxfLoop& cut = loops_[i];
      const DxfLoop& taken = sew_of_[i] ? *sew_of_[i] : cut;
      const DxfChain& c = *taken.chain;
      DxfPlaced placed{{}, &taken, sew_of_[i] ? &cut : nullptr};
      DxfPiece& piece = placed.found.piece;
      piece.outline = c.points;
      piece.breaks = c.breaks;
      piece.breaks_are_edges = c.breaks_are_edges;
      piece.layer = c.layer;
      piece.line = c.line;
      piece.on_sew_line = sew_of_[i] != nullptr || cut.role == DxfRole::sew;
      placed.found.id = next_id_++;
      placed.found.entities = c.entities;
      mark(c, c.curved ? DxfFate::converted : DxfFate::kept,
           c.curved ? "outline, its arcs drawn out and fitted anew" : "outline", placed.found.id);
      if (sew_of_[i]) {
        used_[std::size_t(&c - chains_.data())] = true;
        drop(*cut.chain, "the cut line gives way to the sew line", placed.found.id);
        log_.warn(cut.chain->line,
                  "the cut line (layer " + cut.chain->layer + ") gives way to the sew line (layer " +
                      c.layer + ") in " + line_text(c.line),
                  placed.found.id);
      }
      placed_.push_back(std::move(placed));
    }
  }

  /// A loop that repeats another one, or (in drawings of free layers) that lies within a piece of another
  /// layer: a pocket's place, a facing, a mark.
  bool is_inside_other(std::size_t i) {
    const DxfLoop& inner = loops_[i];
    for (std::size_t k = 0; k < loops_.size(); ++k) {
      const DxfLoop& outer = loops_[k];
      if (k == i || is_seam_line_of_any(outer)) continue;
      const bool other_layer = !by_aama_ && outer.chain->layer != inner.chain->layer;
      const bool equal = is_repeated(inner, outer);
      const bool first = outer.area > inner.area * 1.001 || (equal && k < i);
      if (!first || !(other_layer || equal) || !is_covered(inner, outer)) continue;
      drop(*inner.chain, equal ? "drawn a second time" : "within a piece of another layer");
      return true;
    }
    return false;
  }

  void add_holes() {
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const DxfLoop& loop = loops_[i];
      if (is_outer(i) || is_seam_line_of_any(loop)) continue;
      const DxfLoop* around = &loops_[*loop.parent];
      // In drawings of free layers the hole lies within the seam line, which lies within the cut line.
      const auto owner = std::find_if(placed_.begin(), placed_.end(), [&](const DxfPlaced& p) {
        return p.loop == around || (p.cut == around && lies_within(loop, *p.loop));
      });
      if (owner == placed_.end()) {
        drop(*loop.chain, "a hole outside of any piece");
      } else {
        add_hole(*loop.chain, *owner);
      }
    }
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      if (!by_aama_ || !chains_[i].closed || roles_[i] != DxfRole::cutout || used_[i]) continue;
      const DxfLoop hole = loop_of(chains_[i], roles_[i]);
      const auto owner = std::find_if(placed_.begin(), placed_.end(),
                                      [&](const DxfPlaced& p) { return lies_within(hole, *p.loop); });
      if (hole.area < kLeastArea || owner == placed_.end()) continue;
      used_[i] = true;
      add_hole(chains_[i], *owner);
    }
  }

  void add_hole(const DxfChain& chain, DxfPlaced& owner) {
    owner.found.piece.holes.push_back(chain.points);
    mark(chain, chain.curved ? DxfFate::converted : DxfFate::kept, "hole", owner.found.id);
  }

  /// The piece that a line belongs to: the smallest whose box holds it.
  DxfPlaced* owner_of(const Aabb2& box, bool overlap_is_enough) {
    DxfPlaced* best = nullptr;
    for (DxfPlaced& p : placed_) {
      const Aabb2& around = p.cut ? p.cut->box : p.loop->box;
      const bool inside = around.grown(kBoxSlack).contains(box);
      if (!inside && !(overlap_is_enough && same_place(around, box))) continue;
      if (!best || p.loop->area < best->loop->area) best = &p;
    }
    return best;
  }

  /// Lines that are no outlines.
  void place_rest(const DxfChain& chain, DxfRole role) {
    const Aabb2 box = bounding_box(chain.points);
    const bool outline = by_aama_ && (role == DxfRole::cut || role == DxfRole::sew);
    DxfPlaced* owner = owner_of(box, outline);
    if (by_aama_ && role == DxfRole::mirror) return;  // unfold() tells
    if (by_aama_ && role == DxfRole::repeat)
      return drop(chain, "repeats another layer at another density", owner ? owner->found.id : -1);
    if (by_aama_ && role == DxfRole::notch && !chain.closed) return;  // with the marks
    if (!owner) {
      const double gap = length(chain.points.front() - chain.points.back());
      const bool meant = (role == DxfRole::cut || role == DxfRole::sew) && !chain.closed;
      if (meant && gap <= polyline_length(chain.points) / 2) return fail_open(chain);
      if (meant && !context_.open) context_.open = open_outline(chain);
      return drop(chain,
                  chain.closed ? "it belongs to no piece" : "it encloses nothing and belongs to no piece");
    }
    const int id = owner->found.id;
    if (by_aama_ && role == DxfRole::grain) return set_grain(owner->found, chain);
    if (by_aama_ && role == DxfRole::sew) {
      log_.warn(chain.line, "the sew line does not close: the piece is its cut line", id);
      return drop(chain, "a sew line that does not close", id);
    }
    if (by_aama_ && role == DxfRole::grade) return drop(chain, "grade reference line", id);
    if (by_aama_ && role == DxfRole::guide) return drop(chain, "reference line for stripes or plaids", id);
    if (by_aama_ && role == DxfRole::drill) return keep_drill(chain, owner->found);
    keep_internal(chain, owner->found);
  }

  void fail_open(const DxfChain& chain) {
    const Error error = open_outline(chain);
    context_.fail(error);
    drop(chain, "an outline that does not close");
    log_.warn(chain.line, "left out: " + error.message, -1, chain.points.back());
  }

  void keep_internal(const DxfChain& chain, DxfFound& owner) {
    if (polyline_length(chain.points) < kJointTolerance)
      return drop(chain, "a line without length", owner.id);
    if (owner.piece.internals.size() == kMostInternals)
      return drop(chain, "a piece takes " + std::to_string(kMostInternals) + " lines within it", owner.id);
    if (chain.points.size() > kMostInternalPoints)
      return drop(chain, "a line within a piece has 5,000 points at most", owner.id);
    owner.piece.internals.push_back(chain.points);
    if (chain.closed) owner.piece.internals.back().push_back(chain.points.front());
    mark(chain, chain.curved ? DxfFate::converted : DxfFate::kept, "line within the piece", owner.id);
  }

  void keep_drill(const DxfChain& chain, DxfFound& owner) {
    const Aabb2 box = bounding_box(chain.points);
    owner.piece.drills.push_back(box.middle());
    mark(chain, DxfFate::converted, "drill hole", owner.id);
  }

  void set_grain(DxfFound& owner, const DxfChain& chain) {
    if (owner.piece.grain) return drop(chain, "a second grain line", owner.id);
    const Vec2 d = normalized(chain.points.back() - chain.points.front());
    if (d == Vec2{}) return drop(chain, "a grain line without a direction", owner.id);
    owner.piece.grain = d.y < 0 || (d.y == 0 && d.x < 0) ? -d : d;
    mark(chain, DxfFate::kept, "grain line", owner.id);
  }

  void unfold() {
    for (const auto& [index, axis] : folds_) {
      const DxfChain& line = chains_[index];
      DxfPlaced* owner = owner_of(bounding_box(line.points), true);
      if (!owner && placed_.size() == 1) owner = &placed_[0];
      if (!owner) {
        drop(line, "a mirror line outside of any piece");
        log_.warn(line.line, "a mirror line lies outside of any piece", -1, axis.at);
        continue;
      }
      const int id = owner->found.id;
      if (spans_fold(owner->found.piece.outline, axis)) {
        drop(line, "mirror line of a piece that is drawn whole", id);
      } else if (unfold_piece(owner->found.piece, axis)) {
        mark(line, DxfFate::converted, "the piece is unfolded about it", id);
      } else {
        drop(line, "a mirror line that does not run along the outline", id);
        log_.warn(line.line, "the mirror line does not run along the outline: the piece is not unfolded", id,
                  axis.at);
      }
    }
  }

  const std::vector<DxfPart>& parts_;
  DxfContext& context_;
  DxfLog& log_;
  int& next_id_;
  bool by_aama_ = false;
  std::vector<DxfChain> chains_;
  std::vector<DxfRole> roles_;  // of each chain
  std::vector<bool> used_;      // each chain, as an outline or a hole
  std::vector<std::pair<std::size_t, FoldAxis>> folds_;
  std::vector<DxfLoop> loops_;
  std::vector<DxfLoop> inner_loops_;    // closed lines of layer 8
  std::vector<const DxfLoop*> sew_of_;  // of each loop
  std::vector<int> below_seams_;        // number of seam lines around each loop
  std::vector<DxfPlaced> placed_;
};

}  // namespace

Result<std::vector<DxfFound>> pieces_of(const std::vector<DxfPart>& parts, DxfContext& context,
                                        int& next_id) {
  return Sorter(parts, context, next_id).run();
}

}  // namespace toile
