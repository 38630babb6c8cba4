#include "core/pattern/dxf/trim.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/units.h"
#include "core/pattern/dxf/layers.h"

namespace toile {
namespace {

constexpr double kMarkReach = 60;  // mm from the outline: an allowance or a hem lies between
constexpr double kOnePlace = 0.1;  // mm; points nearer than this are one

double distance_to_outline(Vec2 p, const std::vector<Vec2>& loop) {
  double nearest = length(loop[0] - p);
  for (std::size_t i = 0, n = loop.size(); i < n; ++i)
    nearest = std::min(nearest, distance_to_segment(p, loop[i], loop[(i + 1) % n]));
  return nearest;
}

/// The piece nearest to the mark, within reach.
DxfFound* owner_of(Vec2 at, std::vector<DxfTrimmings>& pieces) {
  DxfFound* best = nullptr;
  double nearest = kMarkReach;
  for (DxfTrimmings& p : pieces) {
    if (!p.box.grown(kMarkReach).contains(at)) continue;
    const std::vector<Vec2>& outline = p.found->piece.outline;
    const double off = pieces.size() == 1 || contains(outline, at) ? 0 : distance_to_outline(at, outline);
    if (off < nearest) {
      nearest = off;
      best = p.found;
    }
  }
  return best;
}

void add_apart(std::vector<Vec2>& points, Vec2 p) {
  for (const Vec2 q : points)
    if (length(p - q) < kOnePlace) return;
  points.push_back(p);
}

void add_notch(std::vector<Notch>& notches, const Notch& notch) {
  for (const Notch& n : notches)
    if (length(n.at - notch.at) < kOnePlace) return;
  notches.push_back(notch);
}

bool is_off(Vec2 p, const FoldAxis& axis) { return std::abs(axis.side(p)) > kOnFold; }

/// Adds the lines' mirror images. Lines that end on the fold go on behind it, those within it stay.
void unfold_lines(std::vector<std::vector<Vec2>>& lines, const FoldAxis& axis) {
  const auto off = [&](Vec2 p) { return is_off(p, axis); };
  std::vector<std::vector<Vec2>> copies;
  for (std::vector<Vec2>& line : lines) {
    if (std::none_of(line.begin(), line.end(), off)) continue;
    std::vector<Vec2> other(line.rbegin(), line.rend());
    for (Vec2& p : other) p = axis.mirrored(p);
    if (!off(line.back())) {
      line.insert(line.end(), other.begin() + 1, other.end());
    } else if (!off(line.front())) {
      line.insert(line.begin(), other.begin(), other.end() - 1);
    } else {
      copies.push_back(std::move(other));
    }
  }
  lines.insert(lines.end(), copies.begin(), copies.end());
}

class Marker {
 public:
  Marker(bool by_aama, std::vector<DxfTrimmings>& pieces, DxfContext& context)
      : by_aama_(by_aama), pieces_(pieces), context_(context) {}

  void place(const DxfMark& mark, const DxfTransform& to_mm) {
    const Vec2 at = to_mm(mark.at);
    const DxfRole role = by_aama_ ? role_of_layer(mark.layer) : DxfRole::other;
    DxfFound* owner = is_finite(at) ? owner_of(at, pieces_) : nullptr;
    if (!owner) return context_.log.mark(mark.entity, DxfFate::dropped, "a point that belongs to no piece");
    const auto tell = [&](DxfFate fate, const char* reason) {
      context_.log.mark(mark.entity, fate, reason, owner->id);
    };
    switch (role) {
      case DxfRole::notch: {
        Notch notch{at, mark.depth * context_.mm_per_unit, {}};
        if (mark.angle) {
          const double angle = radians_from_degrees(std::fmod(*mark.angle, 360.0));
          notch.inwards = normalized(to_mm.turned({std::cos(angle), std::sin(angle)}));
        }
        add_notch(owner->piece.notches, notch);
        return tell(DxfFate::kept, "notch");
      }
      case DxfRole::turn:
        add_apart(owner->piece.turn_points, at);
        return tell(DxfFate::kept, "turn point: a curve ends there");
      case DxfRole::curve:
        return tell(DxfFate::dropped, "curve point: the outline passes it already");
      case DxfRole::drill:
        add_apart(owner->piece.drills, at);
        return tell(DxfFate::kept, "drill hole");
      case DxfRole::grade:
        return tell(DxfFate::dropped, "grade point");
      default:
        return tell(DxfFate::dropped, "a point without a meaning");
    }
  }

  /// A notch drawn as a line: it begins at the outline.
  void place_line(const DxfCurve& curve, const DxfTransform& to_mm) {
    if (curve.vertices.size() < 2 || curve.kind != DxfCurve::Kind::polyline) return;
    Vec2 a = to_mm(curve.vertices.front().at), b = to_mm(curve.vertices.back().at);
    DxfFound* owner = is_finite(a) && is_finite(b) ? owner_of(a, pieces_) : nullptr;
    if (!owner) return context_.log.mark(curve.entity, DxfFate::dropped, "a notch that belongs to no piece");
    if (distance_to_outline(b, owner->piece.outline) < distance_to_outline(a, owner->piece.outline))
      std::swap(a, b);
    add_notch(owner->piece.notches, {a, length(b - a), normalized(b - a)});
    context_.log.mark(curve.entity, DxfFate::converted, "notch", owner->id);
  }

 private:
  bool by_aama_;
  std::vector<DxfTrimmings>& pieces_;
  DxfContext& context_;
};

}  // namespace

void place_marks(const std::vector<DxfPart>& parts, bool by_aama, std::vector<DxfTrimmings>& pieces,
                 DxfContext& context) {
  Marker marker(by_aama, pieces, context);
  for (const DxfPart& part : parts) {
    DxfTransform to_mm = part.transform;
    to_mm.x = to_mm.x * context.mm_per_unit;
    to_mm.y = to_mm.y * context.mm_per_unit;
    to_mm.origin = to_mm.origin * context.mm_per_unit;
    for (const DxfMark& mark : part.block->marks) marker.place(mark, to_mm);
    for (const DxfCurve& curve : part.block->curves)
      if (by_aama && !curve.closed && role_of_layer(curve.layer) == DxfRole::notch)
        marker.place_line(curve, to_mm);
  }
}

bool unfold_piece(DxfPiece& piece, const FoldAxis& axis) {
  std::optional<UnfoldedLoop> whole = unfolded_loop(piece.outline, axis);
  if (!whole) return false;
  piece.outline = std::move(whole->outline);
  piece.unfolded = true;
  const auto off = [&](Vec2 p) { return is_off(p, axis); };
  const auto mirror_points = [&](std::vector<Vec2>& points, bool keep_on_fold) {
    std::vector<Vec2> both;
    for (const Vec2 p : points) {
      if (off(p) || keep_on_fold) both.push_back(p);
      if (off(p)) both.push_back(axis.mirrored(p));
    }
    points = std::move(both);
  };
  const auto mirror_lines = [&](std::vector<std::vector<Vec2>>& lines) {
    for (std::size_t i = 0, n = lines.size(); i < n; ++i) {
      if (std::none_of(lines[i].begin(), lines[i].end(), off)) continue;
      std::vector<Vec2> other = lines[i];
      for (Vec2& p : other) p = axis.mirrored(p);
      lines.push_back(std::move(other));
    }
  };
  mirror_points(piece.breaks, false);
  mirror_points(piece.turn_points, false);
  mirror_points(piece.drills, true);
  mirror_lines(piece.holes);
  piece.holes.insert(piece.holes.end(), whole->holes.begin(), whole->holes.end());
  unfold_lines(piece.internals, axis);
  for (std::size_t i = 0, n = piece.notches.size(); i < n; ++i) {
    const Notch notch = piece.notches[i];
    if (!off(notch.at)) continue;
    const Vec2 inwards = axis.mirrored(axis.at + notch.inwards) - axis.at;
    piece.notches.push_back({axis.mirrored(notch.at), notch.depth, inwards});
  }
  return true;
}

}  // namespace toile
