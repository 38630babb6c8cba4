#include "core/print/sheet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "core/base/text.h"
#include "core/pattern/curve.h"

namespace toile::print {
namespace {

using pattern::CubicBezier;

constexpr double kApart = 15;       // mm between pieces, and around them
constexpr double kTolerance = 0.5;  // mm, of a piece's box: it is let stand apart by more
constexpr double kNotch = 5;        // mm long where the pattern does not tell
constexpr double kGrainShare = 0.5;
constexpr double kArrow = 6;  // mm

CubicBezier moved(const CubicBezier& c, Vec2 by) { return {c.p0 + by, c.p1 + by, c.p2 + by, c.p3 + by}; }

Stroke line_of(Pen pen, const std::vector<Vec2>& points, Vec2 by) {
  Stroke stroke{pen, {}, false};
  for (std::size_t i = 1; i < points.size(); ++i)
    stroke.curves.push_back(pattern::line_segment(points[i - 1] + by, points[i] + by));
  return stroke;
}

Stroke stroke_of(const pattern::Loop& loop, Vec2 by) {
  Stroke stroke{Pen::kOutline, {}, true};
  for (const pattern::PanelEdge& edge : loop.edges)
    for (const CubicBezier& curve : edge.curves) stroke.curves.push_back(moved(curve, by));
  return stroke;
}

/// Of all that is drawn of the piece, as drafted.
Aabb2 box_of(const pattern::Panel& panel) {
  Aabb2 box;
  for (const Vec2 p : pattern::flatten(panel.outline, kTolerance)) box.add(p);
  for (const pattern::InnerLine& line : panel.lines)
    for (const Vec2 p : line.points) box.add(p);
  return box;
}

/// An arrow along the warp through the piece's middle.
void add_grain(Sheet& sheet, const pattern::Panel& panel, const Aabb2& box) {
  const Vec2 along = panel.grain, across{-along.y, along.x};
  const double reach = kGrainShare * 0.5 * std::min(box.size().x, box.size().y);
  const Vec2 tip = box.middle() + along * reach, tail = box.middle() - along * reach;
  sheet.strokes.push_back(line_of(Pen::kGrain, {tail, tip}, {}));
  for (const double side : {-1.0, 1.0}) {
    const Vec2 barb = tip - along * kArrow + across * (side * kArrow / 3);
    sheet.strokes.push_back(line_of(Pen::kGrain, {barb, tip}, {}));
  }
}

void add_piece(Sheet& sheet, const pattern::Panel& panel, const Aabb2& drafted, Vec2 by) {
  const Aabb2 box{drafted.low + by, drafted.high + by};
  sheet.strokes.push_back(stroke_of(panel.outline, by));
  for (const pattern::Loop& hole : panel.holes) sheet.strokes.push_back(stroke_of(hole, by));
  for (const pattern::InnerLine& line : panel.lines)
    sheet.strokes.push_back(line_of(Pen::kInner, line.points, by));
  for (const pattern::Notch& notch : panel.notches) {
    if (notch.inwards == Vec2{}) continue;
    const double depth = notch.depth > 0 ? notch.depth : kNotch;
    sheet.strokes.push_back(line_of(Pen::kMark, {notch.at, notch.at + notch.inwards * depth}, by));
  }
  add_grain(sheet, panel, box);
  const std::string cloth = panel.fabric.empty() ? std::string() : ", " + panel.fabric;
  sheet.captions.push_back({panel.id + cloth, box.middle() + Vec2{kArrow, 0}, 5, true});
}

void add_test_square(Sheet& sheet, const std::string& title, double y) {
  const double x = kApart;
  const Vec2 corners[] = {
      {x, y}, {x + kTestSquare, y}, {x + kTestSquare, y + kTestSquare}, {x, y + kTestSquare}};
  Stroke square = line_of(Pen::kMark, {corners[0], corners[1], corners[2], corners[3], corners[0]}, {});
  square.closed = true;
  sheet.strokes.push_back(std::move(square));
  const std::string side = fixed_text(kTestSquare, 0);
  sheet.captions.push_back({side + " x " + side + " mm", {x + 3, y + 4}, 4});
  sheet.captions.push_back({title, {x + kTestSquare + 8, y + 30}, 8});
  sheet.captions.push_back(
      {"Printed at 100 %, the square measures " + side + " mm.", {x + kTestSquare + 8, y + 17}, 4});
  sheet.captions.push_back(
      {"Lines are where pieces are sewn; add the seam allowance.", {x + kTestSquare + 8, y + 9}, 4});
}

double total_area(const pattern::Pattern& pattern) {
  double area = 0;
  for (const pattern::Panel& panel : pattern.panels) {
    const Vec2 size = box_of(panel).size();
    area += (size.x + kApart) * (size.y + kApart);
  }
  return area;
}

}  // namespace

Sheet lay_out(const pattern::Pattern& pattern, const std::string& title, double width) {
  std::vector<Aabb2> boxes;
  for (const pattern::Panel& panel : pattern.panels) boxes.push_back(box_of(panel));
  constexpr double kHead = 170;  // mm; what stands beside the square needs them
  double across = std::max(width, kHead + 2 * kApart);
  for (const Aabb2& box : boxes) across = std::max(across, box.size().x + 2 * kApart);
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return boxes[a].size().y > boxes[b].size().y; });
  Sheet sheet;
  sheet.pieces.resize(boxes.size());
  add_test_square(sheet, title, kApart);
  double row = kApart + kTestSquare + kApart, x = kApart, highest = 0;
  for (const std::size_t p : order) {
    const Vec2 size = boxes[p].size();
    if (x > kApart && x + size.x + kApart > across) {
      row += highest + kApart;
      x = kApart;
      highest = 0;
    }
    const Vec2 by = Vec2{x, row} - boxes[p].low;
    sheet.pieces[p] = {boxes[p].low + by, boxes[p].high + by};
    add_piece(sheet, pattern.panels[p], boxes[p], by);
    x += size.x + kApart;
    highest = std::max(highest, size.y);
  }
  sheet.size = {across, row + highest + kApart};
  return sheet;
}

double square_width(const pattern::Pattern& pattern, Vec2 page) {
  const double side = std::sqrt(1.2 * total_area(pattern));
  return std::max(1.0, std::ceil(side / page.x)) * page.x;
}

}  // namespace toile::print
