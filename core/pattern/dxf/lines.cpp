#include "core/pattern/dxf/lines.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>

#include "core/base/text.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/outline.h"

namespace toile::dxf {
namespace {

constexpr std::size_t kMostInternals = 500;  // lines within a piece: unfolded, a document takes twice as many
constexpr std::size_t kMostInternalPoints = 4999;  // likewise of one of them, and one that closes it

/// The error that a chain should close and does not.
Error open_outline(const DxfChain& chain) {
  const Vec2 a = chain.points.front(), b = chain.points.back();
  return {"dxf.open_outline",
          "The outline on layer " + chain.layer + " is open between " + pattern::place_text(a) + " and " +
              pattern::place_text(b) + ": a gap of " + significant_text(length(a - b), 4) +
              " mm. Close it in the drawing, or allow wider joints.",
          line_text(chain.line)};
}

/// Tells of a line that lies in no piece. One that may have been meant to close is a fault.
void tell_homeless(const DxfChain& chain, DxfRole role, DxfNotes& notes) {
  const double gap = length(chain.points.front() - chain.points.back());
  const bool meant = (role == DxfRole::kCut || role == DxfRole::kSew) && !chain.closed;
  if (meant && gap <= geometry::polyline_length(chain.points) / 2) {
    const Error error = open_outline(chain);
    notes.fail(error);
    tell(notes, chain, DxfFate::kDropped, "an outline that does not close");
    notes.warn(chain.line, "left out: " + error.message, -1, chain.points.back());
    return;
  }
  if (meant && !notes.open) notes.open = open_outline(chain);
  tell(notes, chain, DxfFate::kDropped,
       chain.closed ? "it belongs to no piece" : "it encloses nothing and belongs to no piece");
}

void keep_internal(const DxfChain& chain, DxfFound& owner, DxfNotes& notes) {
  const auto drop = [&](const std::string& reason) {
    tell(notes, chain, DxfFate::kDropped, reason, owner.id);
  };
  if (geometry::polyline_length(chain.points) < pattern::kJointTolerance)
    return drop("a line without length");
  if (owner.piece.internals.size() == kMostInternals)
    return drop("a piece takes " + std::to_string(kMostInternals) + " lines within it");
  if (chain.points.size() > kMostInternalPoints)
    return drop("a line within a piece has 5,000 points at most");
  owner.piece.internals.push_back(chain.points);
  if (chain.closed) owner.piece.internals.back().push_back(chain.points.front());
  tell(notes, chain, chain.curved ? DxfFate::kConverted : DxfFate::kKept, "line within the piece", owner.id);
}

void keep_drill(const DxfChain& chain, DxfFound& owner, DxfNotes& notes) {
  const Aabb2 box = bounding_box(chain.points);
  owner.piece.drills.push_back(box.middle());
  tell(notes, chain, DxfFate::kConverted, "drill hole", owner.id);
}

/// From point to point: a grain line may go on as the head of its arrow.
Vec2 longest_stretch(const std::vector<Vec2>& points) {
  Vec2 longest;
  for (std::size_t k = 1; k < points.size(); ++k)
    if (const Vec2 way = points[k] - points[k - 1]; length(way) > length(longest)) longest = way;
  return longest;
}

void set_grain(const DxfChain& chain, DxfFound& owner, DxfNotes& notes) {
  if (owner.piece.grain) return tell(notes, chain, DxfFate::kDropped, "a second grain line", owner.id);
  const Vec2 d = normalized(longest_stretch(chain.points));
  if (d == Vec2{}) return tell(notes, chain, DxfFate::kDropped, "a grain line without a direction", owner.id);
  owner.piece.grain = d.y < 0 || (d.y == 0 && d.x < 0) ? -d : d;
  tell(notes, chain, DxfFate::kKept, "grain line", owner.id);
}

/// Why a line of this role says nothing of its piece's shape; nothing when it says something.
std::optional<std::string> idle_reason(DxfRole role) {
  if (role == DxfRole::kSew) return "a sew line that does not close";
  if (role == DxfRole::kGrade) return "grade reference line";
  if (role == DxfRole::kGuide) return "reference line for stripes or plaids";
  return std::nullopt;
}

/// Gives the line to the piece that it lies in. `role`: by AAMA's layers, or `other`.
void place_in(const DxfChain& chain, DxfRole role, DxfFound& owner, DxfNotes& notes) {
  if (role == DxfRole::kGrain) return set_grain(chain, owner, notes);
  if (role == DxfRole::kSew && chain.closed) {
    notes.warn(chain.line,
               "the closed line on layer " + chain.layer +
                   " does not follow the cut line: it is a line within the piece, not its sew line",
               owner.id);
    return keep_internal(chain, owner, notes);
  }
  if (role == DxfRole::kSew)
    notes.warn(chain.line, "the sew line does not close: the piece is its cut line", owner.id);
  if (const auto idle = idle_reason(role)) return tell(notes, chain, DxfFate::kDropped, *idle, owner.id);
  if (role == DxfRole::kDrill) return keep_drill(chain, owner, notes);
  keep_internal(chain, owner, notes);
}

/// Whether a later pass tells of the line: mirror lines with the folds, notches with the marks.
bool comes_later(const DxfChain& chain, DxfRole role) {
  return role == DxfRole::kMirror || (role == DxfRole::kNotch && !chain.closed);
}

/// As they are drawn, but of grain lines the longest first: heads of arrows are lines of their own.
std::vector<std::size_t> in_order(const std::vector<DxfChain>& chains, const DxfRoles& roles) {
  std::vector<std::size_t> order(chains.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) {
    return roles.meaning(i) == DxfRole::kGrain ? -length(longest_stretch(chains[i].points)) : 0.0;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

/// Lines with a meaning belong to a piece although they leave it; of others nobody knows what they are.
DxfReach reach_of(DxfRole role) {
  if (role == DxfRole::kCut || role == DxfRole::kSew) return DxfReach::kAround;
  return role == DxfRole::kOther ? DxfReach::kWithin : DxfReach::kCrossing;
}

}  // namespace

DxfPieces with_lines(DxfPieces pieces, const std::vector<DxfChain>& chains, const DxfRoles& roles) {
  for (const std::size_t i : in_order(chains, roles)) {
    const DxfChain& chain = chains[i];
    const DxfRole meaning = roles.meaning(i);
    if (pieces.used[i] || comes_later(chain, meaning)) continue;
    const std::size_t owner = owner_of(pieces, chain.points, reach_of(meaning));
    DxfFound* found = owner < pieces.placed.size() ? &pieces.placed[owner].found : nullptr;
    if (meaning == DxfRole::kRepeat)
      tell(pieces.notes, chain, DxfFate::kDropped, "repeats another layer at another density",
           found ? found->id : -1);
    else if (found)
      place_in(chain, meaning, *found, pieces.notes);
    else
      tell_homeless(chain, roles.of[i], pieces.notes);
  }
  return pieces;
}

}  // namespace toile::dxf
