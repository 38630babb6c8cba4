#include "core/pattern/dxf_layers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/dxf_groups.h"
#include "core/pattern/outline.h"

namespace toile {
namespace {

constexpr double kSameArea = 1e-3;  // share by which two drawings of one outline may differ
constexpr double kBoxSlack = 1;     // mm, by which a line may stick out of the piece it belongs to

/// A closed chain with what is asked of it again and again.
struct Outline {
  const DxfChain* chain = nullptr;
  Box2 box;
  double area = 0;
  std::optional<std::size_t> parent;  // the smallest loop around it
  int depth = 0;                      // number of loops around it: an odd one is a hole
};

Outline outline_of(const DxfChain& chain) {
  return {&chain, bounding_box(chain.points), std::abs(signed_area(chain.points)), {}, 0};
}

bool lies_within(const Outline& inner, const Outline& outer) {
  if (inner.area >= outer.area || !outer.box.contains(inner.box)) return false;
  if (!contains(outer.chain->points, inner.chain->points[0])) return false;
  const std::vector<std::vector<Vec2>> both{inner.chain->points, outer.chain->points};
  // A loop that crosses itself is found later, with a better message; here only their meeting counts.
  const std::optional<Crossing> crossing = find_crossing(both);
  return !crossing || crossing->loop_a == crossing->loop_b;
}

/// Finds each loop's parent among those of its layer.
void nest(std::vector<Outline>& loops) {
  std::vector<std::size_t> by_area(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) by_area[i] = i;
  std::stable_sort(by_area.begin(), by_area.end(),
                   [&](auto a, auto b) { return loops[a].area < loops[b].area; });
  for (std::size_t k = by_area.size(); k-- > 0;) {
    Outline& inner = loops[by_area[k]];
    for (std::size_t m = k + 1; m < by_area.size() && !inner.parent; ++m) {
      const Outline& outer = loops[by_area[m]];
      if (outer.chain->layer != inner.chain->layer || !lies_within(inner, outer)) continue;
      inner.parent = by_area[m];
      inner.depth = outer.depth + 1;
    }
  }
}

/// Whether the inner loop lies within the outer one or along it, judged by a sample of its vertices.
bool is_covered(const Outline& inner, const Outline& outer) {
  constexpr double kAlong = 0.1;  // mm from the outline
  constexpr std::size_t kSamples = 200;
  if (!outer.box.grown(kAlong).contains(inner.box)) return false;
  const std::vector<Vec2>&points = inner.chain->points, &loop = outer.chain->points;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / kSamples) {
    bool covered = contains(loop, points[i]);
    for (std::size_t k = 0; k < loop.size() && !covered; ++k)
      covered = distance_to_segment(points[i], loop[k], loop[(k + 1) % loop.size()]) <= kAlong;
    if (!covered) return false;
  }
  return true;
}

/// Whether one box holds the other, nearly.
bool same_place(const Box2& a, const Box2& b) {
  return a.grown(kBoxSlack).contains(b) || b.grown(kBoxSlack).contains(a);
}

class Sorter {
 public:
  Sorter(const std::vector<DxfChain>& chains, const DxfSettings& settings, DxfNotes& notes)
      : chains_(chains), settings_(settings), notes_(notes) {
    for (const DxfChain& c : chains) by_aama_ = by_aama_ || c.layer == "1" || c.layer == "14";
  }

  Result<std::vector<DxfPiece>> run() {
    if (auto error = collect()) return *error;
    nest(loops_);
    if (by_aama_) prefer_sew_lines();
    make_pieces();
    for (const DxfChain& chain : chains_) {
      if (chain.closed && chain.layer == "11" && by_aama_) cut_out(chain);
      if (!chain.closed)
        if (auto error = sort_open(chain)) return *error;
    }
    return std::move(pieces_);
  }

 private:
  bool makes_outlines(const DxfChain& chain) const {
    return !by_aama_ || chain.layer == "1" || chain.layer == "14";
  }

  std::optional<Error> collect() {
    std::vector<const DxfChain*> flat;
    for (const DxfChain& chain : chains_) {
      if (!chain.closed) continue;
      if (!makes_outlines(chain)) {
        if (chain.layer != "11") pass_over(chain, "closed lines", "not a layer of outlines");
      } else if (Outline loop = outline_of(chain);
                 loop.area < kLeastArea && is_flat(chain.points, kJointTolerance)) {
        flat.push_back(&chain);
      } else {
        loops_.push_back(loop);
      }
    }
    if (loops_.size() > settings_.max_loops)
      return Error{
          "dxf.too_large",
          "The drawing has more than " + std::to_string(settings_.max_loops) + " closed outlines, the limit.",
          ""};
    for (const DxfChain* chain : flat)
      if (auto error = sort_flat(*chain)) return error;
    return std::nullopt;
  }

  /// A closed line without area, such as a line drawn twice: a mark within a piece, a fault elsewhere.
  std::optional<Error> sort_flat(const DxfChain& chain) {
    for (const Outline& loop : loops_) {
      if (!loop.box.grown(kBoxSlack).contains(bounding_box(chain.points))) continue;
      pass_over(chain, "closed lines", "they enclose no area");
      return std::nullopt;
    }
    return Error{"dxf.zero_area", "The outline encloses no area.",
                 line_text(chain.line) + ", near " + place_text(chain.points[0])};
  }

  /// Drops cut outlines in whose place there is a sew outline.
  void prefer_sew_lines() {
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (loops_[i].chain->layer != "1" || loops_[i].depth > 0) continue;
      for (const Outline& sew : loops_) {
        if (sew.chain->layer != "14" || sew.depth > 0 || !same_place(sew.box, loops_[i].box)) continue;
        replaced_.emplace_back(i, &sew);
        notes_.add(loops_[i].chain->line, "the cut line (layer 1) gives way to the sew line (layer 14) in " +
                                              line_text(sew.chain->line));
        break;
      }
    }
  }

  /// The outline that stands for a loop's parent.
  const Outline* owner(const Outline& hole) const {
    for (const auto& [cut, sew] : replaced_)
      if (cut == *hole.parent) return lies_within(hole, *sew) ? sew : nullptr;
    return &loops_[*hole.parent];
  }

  bool is_replaced(std::size_t i) const {
    return std::any_of(replaced_.begin(), replaced_.end(), [i](const auto& r) { return r.first == i; });
  }

  void make_pieces() {
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (loops_[i].depth % 2 != 0 || is_replaced(i) || is_internal(i)) continue;
      const DxfChain& c = *loops_[i].chain;
      pieces_.push_back({{}, c.points, {}, c.breaks, {}, c.layer, c.line});
      piece_loops_.push_back(&loops_[i]);
    }
    for (const Outline& loop : loops_) {
      if (loop.depth % 2 == 0) continue;
      const Outline* around = owner(loop);
      const auto it = std::find(piece_loops_.begin(), piece_loops_.end(), around);
      if (it != piece_loops_.end())
        pieces_[std::size_t(it - piece_loops_.begin())].holes.push_back(loop.chain->points);
    }
  }

  /// A loop that repeats another one, or (in drawings of free layers) that lies within a piece of another
  /// layer: a pocket's place, a facing, a mark.
  bool is_internal(std::size_t i) {
    const Outline& inner = loops_[i];
    for (std::size_t k = 0; k < loops_.size(); ++k) {
      const Outline& outer = loops_[k];
      const bool other_layer = !by_aama_ && outer.chain->layer != inner.chain->layer;
      const bool equal =
          std::abs(outer.area - inner.area) <= kSameArea * outer.area && same_place(outer.box, inner.box);
      const bool first = outer.area > inner.area * (1 + kSameArea) || (equal && k < i);
      if (k == i || !first || !(other_layer || equal) || !is_covered(inner, outer)) continue;
      pass_over(*inner.chain, "closed lines",
                equal ? "drawn a second time" : "within a piece of another layer");
      return true;
    }
    return false;
  }

  void cut_out(const DxfChain& chain) {
    const Outline hole = outline_of(chain);
    for (std::size_t p = 0; p < pieces_.size() && hole.area >= kLeastArea; ++p) {
      if (!lies_within(hole, *piece_loops_[p])) continue;
      pieces_[p].holes.push_back(chain.points);
      return;
    }
    pass_over(chain, "closed lines", "internal cutouts outside of any piece");
  }

  std::optional<Error> sort_open(const DxfChain& chain) {
    const Box2 box = bounding_box(chain.points);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const bool inside = piece_loops_[p]->box.grown(kBoxSlack).contains(box);
      if (!inside && !(by_aama_ && makes_outlines(chain) && same_place(piece_loops_[p]->box, box))) continue;
      if (by_aama_ && chain.layer == "7" && inside)
        set_grain(pieces_[p], chain);
      else if (by_aama_ && chain.layer == "6")
        notes_.add(chain.line, "fold line (layer 6): the piece is read as it is drawn, not unfolded");
      else
        pass_over(chain, "open lines", "within a piece");
      return std::nullopt;
    }
    const double gap = length(chain.points.front() - chain.points.back());
    if (makes_outlines(chain) && gap <= polyline_length(chain.points) / 2) return open_outline(chain);
    pass_over(chain, "open lines", "they enclose nothing");
    return std::nullopt;
  }

  static void set_grain(DxfPiece& piece, const DxfChain& chain) {
    if (piece.grain) return;
    const Vec2 d = normalized(chain.points.back() - chain.points.front());
    if (d == Vec2{}) return;
    piece.grain = d.y < 0 || (d.y == 0 && d.x < 0) ? -d : d;
  }

  void pass_over(const DxfChain& chain, const std::string& what, const std::string& why) {
    notes_.count(chain.line, what + " on layer " + chain.layer + " passed over: " + why);
  }

  const std::vector<DxfChain>& chains_;
  const DxfSettings& settings_;
  DxfNotes& notes_;
  bool by_aama_ = false;
  std::vector<Outline> loops_;
  std::vector<std::pair<std::size_t, const Outline*>> replaced_;  // cut loop and its sew loop
  std::vector<DxfPiece> pieces_;
  std::vector<const Outline*> piece_loops_;  // the loop that made each piece
};

}  // namespace

Error open_outline(const DxfChain& chain) {
  const Vec2 a = chain.points.front(), b = chain.points.back();
  char width[40];
  std::snprintf(width, sizeof width, "%.4g", length(a - b));
  return {"dxf.open_outline",
          "The outline on layer " + chain.layer + " is open between " + place_text(a) + " and " +
              place_text(b) + ": a gap of " + width + " mm. Close it in the drawing, or allow wider joints.",
          line_text(chain.line)};
}

Result<std::vector<DxfPiece>> pieces_of_chains(const std::vector<DxfChain>& chains,
                                               const DxfSettings& settings, DxfNotes& notes) {
  return Sorter(chains, settings, notes).run();
}

}  // namespace toile
