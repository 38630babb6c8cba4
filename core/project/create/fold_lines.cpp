#include "core/project/create/fold_lines.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/loop_part.h"

namespace toile::create {
namespace {

constexpr double kChords = 0.05;         // mm, chords from curves
constexpr double kShort = 3;             // mm that a fold line may end before the outline …
constexpr double kShortHalves = 15;      // … and where it parts a piece into two that lie on each other
constexpr double kFits = 2.5;            // mm that what is folded back may look out
constexpr double kMostHalf = 110;        // mm, of a strip's width when it is folded
constexpr double kLeastLong = 2;         // times as long as wide is half a strip …
constexpr double kLeastFull = 0.85;      // … and fills its box
constexpr double kFacing[] = {28, 130};  // mm, breadth of a facing that is cut on
constexpr double kFacingLong = 2.5;      // times its breadth
constexpr double kMostFacing = 0.45;     // of the area that stays
constexpr double kAlongGrain = 0.87;     // cosine

/// What lies left of the line, its last side on it: from `to` around to `from`.
std::vector<Vec2> left_of(const pattern::Panel& panel, const FoldLine& fold) {
  std::vector<Vec2> part;
  for (const pattern::PanelEdge& edge : pattern::edges_between(panel.outline, fold.to, fold.from)) {
    const std::vector<Vec2> points = pattern::flatten(edge, kChords);
    part.insert(part.end(), points.begin(), points.end());
  }
  return part;
}

/// Where the point comes when it is folded over the line.
Vec2 folded_over(Vec2 p, const FoldLine& fold) {
  const Vec2 along = normalized(fold.to - fold.from), off = p - fold.from;
  return fold.from + 2 * dot(off, along) * along - off;
}

/// Whether the part, folded over the line, lies on the rest.
bool lies_on(const std::vector<Vec2>& part, const std::vector<Vec2>& rest, const FoldLine& fold) {
  return std::all_of(part.begin(), part.end(), [&](Vec2 p) {
    const Vec2 over = folded_over(p, fold);
    return geometry::contains(rest, over) || length(geometry::nearest_on(rest, over) - over) < kFits;
  });
}

/// Whether the part ends where the rest does at both ends of the line: a facing does, not any strip.
bool ends_with(const std::vector<Vec2>& part, const std::vector<Vec2>& rest, const FoldLine& fold) {
  constexpr double kReach = 20, kClose = 1.5;  // mm
  const auto ends = [&](auto from, auto to) {
    double left = kReach;
    for (auto p = from, next = p + 1; next != to && left > 0; p = next++) {
      const double step = length(*next - *p);
      const Vec2 at = step > left ? *p + left / step * (*next - *p) : *next, over = folded_over(at, fold);
      if (length(geometry::nearest_on(rest, over) - over) > kClose) return false;
      left -= step;
    }
    return true;
  };
  return ends(part.begin(), part.end()) && ends(part.rbegin(), part.rend());
}

FoldLine turned(const FoldLine& fold) { return {fold.to, fold.from, fold.halves}; }

std::size_t notches_left_of(const pattern::Panel& panel, const FoldLine& fold) {
  return static_cast<std::size_t>(std::count_if(
      panel.notches.begin(), panel.notches.end(),
      [&](const pattern::Notch& notch) { return cross(fold.to - fold.from, notch.at - fold.from) > 0; }));
}

bool is_doubled_strip(const seams::PieceWords& words, const std::vector<Vec2>& half, const FoldLine& fold) {
  using enum seams::PieceKind;
  if (words.kind == kTorso || words.kind == kSleeve || words.kind == kLegs || words.kind == kSkirt)
    return false;
  if (words.kind == kStrap) return false;  // is sewn on by its ends, whose points would be halved
  const double wide = breadth_of(half, fold), long_as = length(fold.to - fold.from);
  return wide <= kMostHalf && long_as >= kLeastLong * wide &&
         std::abs(geometry::signed_area(half)) >= kLeastFull * wide * long_as;
}

bool is_facing_cut_on(const pattern::Panel& panel, const seams::PieceWords& words,
                      const std::vector<Vec2>& part, const std::vector<Vec2>& rest, const FoldLine& fold) {
  // Pleats of a skirt are drawn so as well.
  if (words.kind != seams::PieceKind::kTorso || words.face < 0) return false;
  const double wide = breadth_of(part, fold), long_as = length(fold.to - fold.from);
  return wide >= kFacing[0] && wide <= kFacing[1] && long_as >= kFacingLong * wide &&
         std::abs(dot(normalized(fold.to - fold.from), panel.grain)) >= kAlongGrain &&
         std::abs(geometry::signed_area(part)) <= kMostFacing * std::abs(geometry::signed_area(rest)) &&
         ends_with(part, rest, fold);
}

}  // namespace

std::optional<PartedPiece> parted_along(const pattern::Panel& panel, const Chord& chord) {
  const FoldLine line{chord.from, chord.to};
  PartedPiece parted{line, left_of(panel, line), left_of(panel, turned(line))};
  if (parted.larger.size() < 3 || parted.smaller.size() < 3) return std::nullopt;
  if (std::abs(geometry::signed_area(parted.larger)) < std::abs(geometry::signed_area(parted.smaller))) {
    std::swap(parted.larger, parted.smaller);
    parted.line = turned(line);
  }
  return parted;
}

double breadth_of(const std::vector<Vec2>& part, const FoldLine& fold) {
  const Vec2 along = normalized(fold.to - fold.from);
  double most = 0;
  for (const Vec2 p : part) most = std::max(most, std::abs(cross(along, p - fold.from)));
  return most;
}

std::optional<FoldLine> fold_line(const pattern::Panel& panel, const seams::PieceWords& words) {
  const std::vector<Vec2> outline = pattern::flatten(panel.outline, kChords);
  std::optional<FoldLine> best;
  double best_breadth = HUGE_VAL;
  for (const pattern::InnerLine& line : panel.lines) {
    if (!line.drawn) continue;
    const bool to_outline = chord_across(line.points, outline, kShort).has_value();
    const std::optional<Chord> chord = chord_across(line.points, outline, kShortHalves);
    if (!chord) continue;
    const std::optional<PartedPiece> parted = parted_along(panel, *chord);
    if (!parted) continue;
    FoldLine fold = parted->line;
    const std::vector<Vec2>&rest = parted->larger, &part = parted->smaller;
    if (!lies_on(part, rest, fold)) continue;
    fold.halves = lies_on(rest, part, fold);
    if (!fold.halves && !to_outline) continue;
    if (fold.halves ? !is_doubled_strip(words, part, fold)
                    : !is_facing_cut_on(panel, words, part, rest, fold))
      continue;
    if (fold.halves && notches_left_of(panel, turned(fold)) > notches_left_of(panel, fold))
      fold = turned(fold);
    // The outermost of a facing's lines is where it is folded; the one after it may be the middle.
    if (const double breadth = breadth_of(part, fold); breadth < best_breadth) {
      best = fold;
      best_breadth = breadth;
    }
  }
  return best;
}

pattern::Panel folded(const pattern::Panel& panel, const FoldLine& fold) {
  pattern::Panel rest = panel;
  std::vector<pattern::PanelEdge>& edges = rest.outline.edges;
  edges = pattern::edges_between(panel.outline, fold.to, fold.from);
  edges.push_back(
      {"", {pattern::line_segment(edges.back().curves.back().p3, edges.front().curves.front().p0)}});
  for (std::size_t e = 0; e < edges.size(); ++e) edges[e].id = "e" + std::to_string(e);
  if (fold.halves) edges.back().id = pattern::kFoldEdge;
  const Vec2 along = normalized(fold.to - fold.from);
  const auto stays = [&](Vec2 p) { return cross(along, p - fold.from) > 0.5; };
  std::erase_if(rest.notches, [&](const pattern::Notch& notch) { return !stays(notch.at); });
  std::erase_if(rest.lines, [&](const pattern::InnerLine& line) {
    return !std::all_of(line.points.begin(), line.points.end(), stays);
  });
  return rest;
}

}  // namespace toile::create
