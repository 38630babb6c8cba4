#include "core/pattern/dxf/marks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/layers.h"

namespace toile::dxf {
namespace {

constexpr double kMarkReach = 60;  // mm from the outline: an allowance or a hem lies between
// mm between a notch and the outline, as panel_from_piece takes them
constexpr double kNotchOffSewLine = 60, kNotchOffCutLine = 15;
constexpr double kOnePlace = 0.1;  // mm; points nearer than this are one
constexpr const char* kTwice = "a notch that is drawn twice";

/// The piece nearest to the mark, within reach, and that of a block with one piece in any case; null when
/// there is none.
DxfPlaced* owner_of(Vec2 at, DxfPieces& pieces) {
  if (pieces.is_block && pieces.placed.size() == 1) return &pieces.placed[0];
  DxfPlaced* best = nullptr;
  double nearest = kMarkReach;
  for (DxfPlaced& p : pieces.placed) {
    if (!p.loop->box.grown(kMarkReach).contains(at)) continue;
    const std::vector<Vec2>& outline = p.found.piece.outline;
    const double off =
        pieces.placed.size() == 1 || geometry::contains(outline, at) ? 0 : distance_to_loop(at, outline);
    if (off < nearest) {
      nearest = off;
      best = &p;
    }
  }
  return best;
}

void add_apart(std::vector<Vec2>& points, Vec2 p) {
  for (const Vec2 q : points)
    if (length(p - q) < kOnePlace) return;
  points.push_back(p);
}

/// Whether the piece has no notch there yet; then it has this one.
bool add_notch(DxfPlaced& owner, const pattern::Notch& notch, std::size_t entity) {
  for (const pattern::Notch& n : owner.found.piece.notches)
    if (length(n.at - notch.at) < kOnePlace) return false;
  owner.found.piece.notches.push_back(notch);
  owner.notch_entities.push_back(entity);
  return true;
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
          DxfPlaced& owner) {
  DxfPiece& piece = owner.found.piece;
  switch (role) {
    case DxfRole::kNotch:
      if (distance_to_loop(at, piece.outline) > (piece.on_sew_line ? kNotchOffSewLine : kNotchOffCutLine))
        return {DxfFate::kDropped, "a notch away from the outline"};
      if (!add_notch(owner, notch_of(mark, at, to_mm, mm_per_unit), mark.entity))
        return {DxfFate::kDropped, kTwice};
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
  DxfPlaced* owner = is_finite(at) ? owner_of(at, pieces) : nullptr;
  if (!owner) return pieces.notes.mark(mark.entity, DxfFate::kDropped, "a point that belongs to no piece");
  const Told told = give(mark, role, at, to_mm, mm_per_unit, *owner);
  pieces.notes.mark(mark.entity, told.fate, told.reason, owner->found.id);
}

/// A notch drawn as a line: it begins at the outline.
void place_line(const DxfCurve& curve, const DxfTransform& to_mm, DxfPieces& pieces) {
  if (curve.vertices.size() < 2 || curve.kind != DxfCurve::Kind::kPolyline) return;
  Vec2 a = to_mm(curve.vertices.front().at), b = to_mm(curve.vertices.back().at);
  DxfPlaced* owner = is_finite(a) && is_finite(b) ? owner_of(a, pieces) : nullptr;
  if (!owner) return pieces.notes.mark(curve.entity, DxfFate::kDropped, "a notch that belongs to no piece");
  const std::vector<Vec2>& outline = owner->found.piece.outline;
  if (distance_to_loop(b, outline) < distance_to_loop(a, outline)) std::swap(a, b);
  const bool fresh = add_notch(*owner, {a, length(b - a), normalized(b - a)}, curve.entity);
  pieces.notes.mark(curve.entity, fresh ? DxfFate::kConverted : DxfFate::kDropped, fresh ? "notch" : kTwice,
                    owner->found.id);
}

/// Takes away the notches of the cut line that stand on the sew line too: moved onto it they would be two.
void part_doubles(DxfPlaced& placed, DxfNotes& notes) {
  constexpr double kOnSewLine = 0.5;       // mm
  constexpr double kSlant = 0.25;          // of the allowance: notches stand about square on the line …
  constexpr double kLeast = 1, kMost = 3;  // … mm; double notches are farther apart
  const std::vector<Vec2>& outline = placed.found.piece.outline;
  const std::vector<pattern::Notch> all = std::exchange(placed.found.piece.notches, {});
  std::vector<Vec2> feet;
  feet.reserve(all.size());
  for (const pattern::Notch& notch : all) feet.push_back(geometry::nearest_on(outline, notch.at));
  const auto off = [&](std::size_t i) { return length(all[i].at - feet[i]); };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double reach = std::clamp(kSlant * off(i), kLeast, kMost);
    bool doubled = false;
    for (std::size_t k = 0; k < all.size() && off(i) > kOnSewLine; ++k)
      doubled = doubled || (off(k) <= kOnSewLine && length(feet[k] - feet[i]) <= reach);
    if (!doubled) placed.found.piece.notches.push_back(all[i]);
    if (doubled)
      notes.mark(placed.notch_entities[i], DxfFate::kDropped, "the sew line has this notch too",
                 placed.found.id);
  }
}

}  // namespace

DxfPieces with_marks(DxfPieces pieces, const std::vector<DxfPart>& parts, const std::vector<DxfChain>& chains,
                     const DxfRoles& roles, const DxfReading& reading) {
  const DxfLayerMap& given = reading.settings.layers;
  std::set<std::size_t> notches;  // entities
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (roles.meaning(i) == DxfRole::kNotch)
      notches.insert(chains[i].entities.begin(), chains[i].entities.end());
  const auto meaning_of_point = [&](const std::string& layer) {
    return roles.by_aama || told_role(layer, 0, given) ? role_of_layer(layer, given) : DxfRole::kOther;
  };
  const auto is_notch = [&](const DxfCurve& curve) {
    if (curve.closed) return false;
    const bool by_layer =
        roles.by_aama || given_role(curve.layer, given);  // a line without length is no chain
    return notches.contains(curve.entity) ||
           (by_layer && role_of_layer(curve.layer, given) == DxfRole::kNotch);
  };
  for (const DxfPart& part : parts) {
    const DxfTransform to_mm = part.transform.scaled(reading.mm_per_unit);
    for (const DxfMark& mark : part.block->marks)
      place_mark(mark, meaning_of_point(mark.layer), to_mm, reading.mm_per_unit, pieces);
    for (const DxfCurve& curve : part.block->curves)
      if (is_notch(curve)) place_line(curve, to_mm, pieces);
  }
  for (DxfPlaced& placed : pieces.placed)
    if (placed.cut) part_doubles(placed, pieces.notes);
  return pieces;
}

}  // namespace toile::dxf
