#include "core/pattern/dxf/marks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/layers.h"

namespace toile::dxf {
namespace {

constexpr double kMarkReach = 60;  // mm from the outline: an allowance or a hem lies between
constexpr double kOnePlace = 0.1;  // mm; points nearer than this are one

double distance_to_outline(Vec2 p, const std::vector<Vec2>& loop) {
  double nearest = length(loop[0] - p);
  for (std::size_t i = 0, n = loop.size(); i < n; ++i)
    nearest = std::min(nearest, geometry::distance_to_segment(p, loop[i], loop[(i + 1) % n]));
  return nearest;
}

/// The piece nearest to the mark, within reach; null when there is none.
DxfFound* owner_of(Vec2 at, std::vector<DxfPlaced>& placed) {
  DxfFound* best = nullptr;
  double nearest = kMarkReach;
  for (DxfPlaced& p : placed) {
    if (!p.loop->box.grown(kMarkReach).contains(at)) continue;
    const std::vector<Vec2>& outline = p.found.piece.outline;
    const double off =
        placed.size() == 1 || geometry::contains(outline, at) ? 0 : distance_to_outline(at, outline);
    if (off < nearest) {
      nearest = off;
      best = &p.found;
    }
  }
  return best;
}

void add_apart(std::vector<Vec2>& points, Vec2 p) {
  for (const Vec2 q : points)
    if (length(p - q) < kOnePlace) return;
  points.push_back(p);
}

void add_notch(std::vector<pattern::Notch>& notches, const pattern::Notch& notch) {
  for (const pattern::Notch& n : notches)
    if (length(n.at - notch.at) < kOnePlace) return;
  notches.push_back(notch);
}

/// A notch of a POINT; its direction is told as an angle in the drawing.
pattern::Notch notch_of(const DxfMark& mark, Vec2 at, const DxfTransform& to_mm, double mm_per_unit) {
  pattern::Notch notch{at, mark.depth * mm_per_unit, {}};
  if (mark.angle) {
    const double angle = radians_from_degrees(std::fmod(*mark.angle, 360.0));
    notch.inwards = normalized(to_mm.turned({std::cos(angle), std::sin(angle)}));
  }
  return notch;
}

/// What has become of a mark.
struct Told {
  DxfFate fate;
  const char* reason;
};

/// Gives the mark to the piece.
Told give(const DxfMark& mark, DxfRole role, Vec2 at, const DxfTransform& to_mm, double mm_per_unit,
          DxfPiece& piece) {
  switch (role) {
    case DxfRole::kNotch:
      add_notch(piece.notches, notch_of(mark, at, to_mm, mm_per_unit));
      return {DxfFate::kKept, "notch"};
    case DxfRole::kTurn:
      add_apart(piece.turn_points, at);
      return {DxfFate::kKept, "turn point: a curve ends there"};
    case DxfRole::kCurve:
      return {DxfFate::kDropped, "curve point: the outline passes it already"};
    case DxfRole::kDrill:
      add_apart(piece.drills, at);
      return {DxfFate::kKept, "drill hole"};
    case DxfRole::kGrade:
      return {DxfFate::kDropped, "grade point"};
    default:
      return {DxfFate::kDropped, "a point without a meaning"};
  }
}

void place_mark(const DxfMark& mark, DxfRole role, const DxfTransform& to_mm, double mm_per_unit,
                DxfPieces& pieces) {
  const Vec2 at = to_mm(mark.at);
  DxfFound* owner = is_finite(at) ? owner_of(at, pieces.placed) : nullptr;
  if (!owner) return pieces.notes.mark(mark.entity, DxfFate::kDropped, "a point that belongs to no piece");
  const Told told = give(mark, role, at, to_mm, mm_per_unit, owner->piece);
  pieces.notes.mark(mark.entity, told.fate, told.reason, owner->id);
}

/// A notch drawn as a line: it begins at the outline.
void place_line(const DxfCurve& curve, const DxfTransform& to_mm, DxfPieces& pieces) {
  if (curve.vertices.size() < 2 || curve.kind != DxfCurve::Kind::kPolyline) return;
  Vec2 a = to_mm(curve.vertices.front().at), b = to_mm(curve.vertices.back().at);
  DxfFound* owner = is_finite(a) && is_finite(b) ? owner_of(a, pieces.placed) : nullptr;
  if (!owner) return pieces.notes.mark(curve.entity, DxfFate::kDropped, "a notch that belongs to no piece");
  const std::vector<Vec2>& outline = owner->piece.outline;
  if (distance_to_outline(b, outline) < distance_to_outline(a, outline)) std::swap(a, b);
  add_notch(owner->piece.notches, {a, length(b - a), normalized(b - a)});
  pieces.notes.mark(curve.entity, DxfFate::kConverted, "notch", owner->id);
}

}  // namespace

DxfPieces with_marks(DxfPieces pieces, const std::vector<DxfPart>& parts, bool by_aama, double mm_per_unit) {
  for (const DxfPart& part : parts) {
    const DxfTransform to_mm = part.transform.scaled(mm_per_unit);
    for (const DxfMark& mark : part.block->marks) {
      const DxfRole role = by_aama ? role_of_layer(mark.layer) : DxfRole::kOther;
      place_mark(mark, role, to_mm, mm_per_unit, pieces);
    }
    for (const DxfCurve& curve : part.block->curves)
      if (by_aama && !curve.closed && role_of_layer(curve.layer) == DxfRole::kNotch)
        place_line(curve, to_mm, pieces);
  }
  return pieces;
}

}  // namespace toile::dxf
