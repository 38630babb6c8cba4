#include "core/print/pages.h"

#include <algorithm>
#include <cmath>

namespace toile::print {
namespace {

Aabb2 box_of(const Stroke& stroke) {
  Aabb2 box;  // of the handles, which hold the curve
  for (const pattern::CubicBezier& curve : stroke.curves)
    for (const Vec2 p : {curve.p0, curve.p1, curve.p2, curve.p3}) box.add(p);
  return box;
}

bool meet(const Aabb2& a, const Aabb2& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// "A" to "Z", "AA" …
std::string column_name(int column) {
  std::string name;
  for (int rest = column; rest >= 0; rest = rest / 26 - 1)
    name.insert(name.begin(), static_cast<char>('A' + rest % 26));
  return name;
}

}  // namespace

Pages cut_up(const Sheet& sheet, const Paper& paper) {
  const Vec2 window = window_of(paper);
  Pages pages;
  pages.columns = std::max(1, static_cast<int>(std::ceil(sheet.size.x / window.x - 1e-9)));
  pages.rows = std::max(1, static_cast<int>(std::ceil(sheet.size.y / window.y - 1e-9)));
  std::vector<Aabb2> drawn = sheet.pieces;  // within them as well: who cuts wants the paper whole
  for (const Stroke& stroke : sheet.strokes)
    for (const pattern::CubicBezier& curve : stroke.curves)
      drawn.push_back(box_of({stroke.pen, {curve}, false}));
  for (int row = 0; row < pages.rows; ++row) {
    for (int column = 0; column < pages.columns; ++column) {
      const Vec2 corner{column * window.x, sheet.size.y - (row + 1) * window.y};
      const Aabb2 shown{corner, corner + window};
      constexpr double kHair = 1;  // mm: a line is seen where its curve is straight and its box has no width
      const auto is_on = [&](const Aabb2& box) {
        return meet({box.low - Vec2{kHair, kHair}, box.high + Vec2{kHair, kHair}}, shown);
      };
      if (std::none_of(drawn.begin(), drawn.end(), is_on)) continue;
      pages.shown.push_back({column_name(column) + std::to_string(row + 1), column, row, corner});
    }
  }
  return pages;
}

}  // namespace toile::print
