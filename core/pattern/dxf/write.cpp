#include "core/pattern/dxf/write.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"

namespace toile::dxf {
namespace {

constexpr int kDecimals = 4;         // of a millimetre
constexpr double kGrainShare = 0.5;  // of the piece's size, the length of the grain line
constexpr double kTextHeight = 10;   // mm
// AAMA layers
constexpr const char *kCut = "1", *kTurn = "2", *kNotch = "4", *kGrain = "7", *kInternal = "8",
                     *kInside = "11";

// Groups of a DXF file: a code and a value, each on a line.
class Groups {
 public:
  void add(int code, const std::string& value) { text_ += std::to_string(code) + "\n" + value + "\n"; }
  void add(int code, const char* value) { add(code, std::string(value)); }
  void add(int code, int value) { add(code, std::to_string(value)); }
  void number(int code, double value) {
    const double unsigned_zero = std::abs(value) < 0.5e-4 ? 0.0 : value;
    add(code, fixed_text(unsigned_zero, kDecimals));
  }
  void point(int code, Vec2 p) {
    number(code, p.x);
    number(code + 10, p.y);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void write_line(Groups& out, const std::vector<Vec2>& points, bool closed, const char* layer) {
  out.add(0, "POLYLINE");
  out.add(8, layer);
  out.add(66, 1);
  out.add(70, closed ? 1 : 0);
  for (const Vec2& p : points) {
    out.add(0, "VERTEX");
    out.add(8, layer);
    out.point(10, p);
  }
  out.add(0, "SEQEND");
  out.add(8, layer);
}

void write_point(Groups& out, Vec2 at, const char* layer) {
  out.add(0, "POINT");
  out.add(8, layer);
  out.point(10, at);
}

/// Each edge a line of its own: that is how AAMA files part an outline, and its corners are turn points.
void write_outline(Groups& out, const pattern::Panel& panel, double tolerance) {
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  if (edges.size() == 1) return write_line(out, pattern::flatten(panel.outline, tolerance), true, kCut);
  for (const pattern::PanelEdge& edge : edges)
    write_line(out, pattern::flatten(edge, tolerance), false, kCut);
  for (const pattern::PanelEdge& edge : edges) write_point(out, edge.curves.front().p0, kTurn);
}

void write_notch(Groups& out, const pattern::Notch& notch) {
  write_point(out, notch.at, kNotch);
  out.number(30, notch.depth);
  if (!(notch.inwards == Vec2{}))
    out.number(50, degrees_from_radians(std::atan2(notch.inwards.y, notch.inwards.x)));
}

void write_text(Groups& out, Vec2 at, double height, const std::string& words) {
  out.add(0, "TEXT");
  out.add(8, kCut);
  out.point(10, at);
  out.number(40, height);
  out.add(1, words);
}

// The grain through the middle of the piece, and what it is beside it.
void write_grain_and_texts(Groups& out, const pattern::Panel& panel, double tolerance) {
  const Aabb2 box = bounding_box(pattern::flatten(panel.outline, tolerance));
  const Vec2 middle = box.middle(), size = box.size();
  const double half = kGrainShare / 2 * std::min(size.x, size.y), height = std::min(kTextHeight, half);
  out.add(0, "LINE");
  out.add(8, kGrain);
  out.point(10, middle - panel.grain * half);
  out.point(11, middle + panel.grain * half);
  write_text(out, middle, height, "Piece Name: " + panel.id);
  write_text(out, middle - Vec2{0, 1.5 * height}, height, "Quantity: 1");
}

void write_block(Groups& out, const pattern::Panel& panel, double tolerance) {
  out.add(0, "BLOCK");
  out.add(8, kCut);
  out.add(2, panel.id);
  out.add(70, 0);
  out.point(10, {0, 0});
  write_outline(out, panel, tolerance);
  for (const pattern::Notch& notch : panel.notches) write_notch(out, notch);
  for (const pattern::InnerLine& line : panel.lines) write_line(out, line.points, false, kInternal);
  for (const pattern::Loop& hole : panel.holes)
    write_line(out, pattern::flatten(hole, tolerance), true, kInside);
  write_grain_and_texts(out, panel, tolerance);
  out.add(0, "ENDBLK");
  out.add(8, kCut);
}

void write_header(Groups& out) {
  out.add(0, "SECTION");
  out.add(2, "HEADER");
  out.add(9, "$ACADVER");
  out.add(1, "AC1009");
  out.add(9, "$INSUNITS");
  out.add(70, 4);  // millimetres
  out.add(0, "ENDSEC");
}

Status check(const pattern::Pattern& pattern) {
  if (pattern.panels.empty()) return Error{"dxf.nothing_to_write", "The pattern has no pieces.", ""};
  for (const pattern::Panel& panel : pattern.panels) {
    if (panel.id.empty() || panel.id.find_first_of("\r\n") != std::string::npos) {
      return Error{"dxf.bad_name", "A piece needs a name of one line.", "piece '" + panel.id + "'"};
    }
    if (panel.outline.edges.empty()) {
      return Error{"dxf.nothing_to_write", "The piece has no outline.", "piece " + panel.id};
    }
  }
  return {};
}

}  // namespace

Result<std::string> write_dxf(const pattern::Pattern& pattern, const DxfWriteSettings& settings) {
  TRY(check(pattern));
  Groups out;
  write_header(out);
  out.add(0, "SECTION");
  out.add(2, "BLOCKS");
  for (const pattern::Panel& panel : pattern.panels) write_block(out, panel, settings.tolerance_mm);
  out.add(0, "ENDSEC");
  out.add(0, "SECTION");
  out.add(2, "ENTITIES");
  for (const pattern::Panel& panel : pattern.panels) {
    out.add(0, "INSERT");
    out.add(8, kCut);
    out.add(2, panel.id);
    out.point(10, {0, 0});
  }
  write_text(out, {0, 0}, kTextHeight, "Units: METRIC");
  out.add(0, "ENDSEC");
  out.add(0, "EOF");
  return out.take();
}

}  // namespace toile::dxf
