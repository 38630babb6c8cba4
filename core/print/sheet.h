#pragma once
// The pieces of a pattern laid out on one sheet at 1:1, as lines and words: what printed pages show.

#include <string>
#include <vector>

#include "core/base/aabb.h"
#include "core/pattern/pattern.h"

namespace toile::print {

enum class Pen { kOutline, kInner, kGrain, kMark };

/// Curves one after the other, mm, y up; a closed one ends where it began.
struct Stroke {
  Pen pen = Pen::kOutline;
  std::vector<pattern::CubicBezier> curves;
  bool closed = false;
};

/// Words that begin at a place; mm.
struct Caption {
  std::string text;
  Vec2 at;
  double height = 5;
  bool names_piece = false;
};

struct Sheet {
  Vec2 size;  ///< mm; all strokes lie within 0 and this
  std::vector<Stroke> strokes;
  std::vector<Caption> captions;
  std::vector<Aabb2> pieces;  ///< where each lies, one a panel
};

inline constexpr double kTestSquare = 50;  ///< mm a side; whoever prints measures it

/// Pieces in rows as high as their highest, the highest first, in their drafted directions, apart by a
/// finger's width; `width` (mm) is kept where no piece is wider. Below them stands the test square. REQUIRES
/// panels.
Sheet lay_out(const pattern::Pattern& pattern, const std::string& title, double width);

/// The width that gives about as many pages across as down, mm, for pages of this size.
double square_width(const pattern::Pattern& pattern, Vec2 page);

}  // namespace toile::print
