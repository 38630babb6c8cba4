#include "core/pattern/dxf/unfold.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace toile::dxf {
namespace {

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

}  // namespace

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
    const pattern::Notch notch = piece.notches[i];
    if (!off(notch.at)) continue;
    const Vec2 inwards = axis.mirrored(axis.at + notch.inwards) - axis.at;
    piece.notches.push_back({axis.mirrored(notch.at), notch.depth, inwards});
  }
  return true;
}

namespace {

/// Unfolds the piece about the chain's axis, or says why not.
void unfold_about(const DxfChain& line, const FoldAxis& axis, DxfFound& owner, DxfNotes& notes) {
  if (spans_fold(owner.piece.outline, axis)) {
    tell(notes, line, DxfFate::kDropped, "mirror line of a piece that is drawn whole", owner.id);
    if (!is_even_about(owner.piece.outline, axis))
      notes.warn(
          line.line,
          "the mirror line runs through the piece, and not through its middle: the piece is taken as it "
          "is drawn, not unfolded",
          owner.id, axis.at);
  } else if (std::vector<Vec2> half = owner.piece.outline; unfold_piece(owner.piece, axis)) {
    if (owner.half.empty()) owner.half = std::move(half);
    tell(notes, line, DxfFate::kConverted, "the piece is unfolded about it", owner.id);
  } else {
    tell(notes, line, DxfFate::kDropped, "a mirror line that does not run along the outline", owner.id);
    notes.warn(line.line, "the mirror line does not run along the outline: the piece is not unfolded",
               owner.id, axis.at);
  }
}

}  // namespace

DxfPieces unfolded(DxfPieces pieces, const std::vector<DxfChain>& chains, const std::vector<DxfFold>& folds) {
  for (const auto& [index, axis] : folds) {
    const DxfChain& line = chains[index];
    std::size_t owner = owner_of(pieces, line.points, DxfReach::kAround);
    if (pieces.placed.size() == 1) owner = 0;  // whose else, however the line lies
    if (owner < pieces.placed.size()) {
      unfold_about(line, axis, pieces.placed[owner].found, pieces.notes);
      continue;
    }
    tell(pieces.notes, line, DxfFate::kDropped, "a mirror line outside of any piece");
    pieces.notes.warn(line.line, "a mirror line lies outside of any piece", -1, axis.at);
  }
  return pieces;
}

}  // namespace toile::dxf
