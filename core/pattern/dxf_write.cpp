#include "core/pattern/dxf_write.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/pattern/curve.h"

namespace toile {
namespace {

constexpr int kDecimals = 4;         // of a millimetre
constexpr double kGrainShare = 0.5;  // of the piece's size, the length of the grain line
constexpr double kTextHeight = 10;   // mm
constexpr const char *kCut = "1", *kGrain = "7", *kInside = "11";  // AAMA layers

// Groups of a DXF file: a code and a value, each on a line.
class Groups {
 public:
  void add(int code, const std::string& value) { text_ += std::to_string(code) + "\n" + value + "\n"; }
  void add(int code, const char* value) { add(code, std::string(value)); }
  void add(int code, int value) { add(code, std::to_string(value)); }
  void number(int code, double value) {
    char buffer[64];
    const double unsigned_zero = std::abs(value) < 0.5e-4 ? 0.0 : value;
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, unsigned_zero, std::chars_format::fixed, kDecimals);
    add(code, std::string(buffer, end.ptr));
  }
  void point(int code, Vec2 p) {
    number(code, p.x);
    number(code + 10, p.y);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void write_loop(Groups& out, const Loop& loop, const char* layer, double tolerance) {
  out.add(0, "POLYLINE");
  out.add(8, layer);
  out.add(66, 1);
  out.add(70, 1);
  for (const Vec2& p : flatten(loop, tolerance)) {
    out.add(0, "VERTEX");
    out.add(8, layer);
    out.point(10, p);
  }
  out.add(0, "SEQEND");
  out.add(8, layer);
}

// The grain through the middle of the piece, and the name beside it.
void write_grain_and_name(Groups& out, const Panel& panel, double tolerance) {
  const std::vector<Vec2> line = flatten(panel.outline, tolerance);
  Vec2 low = line.front(), high = low;
  for (const Vec2& p : line) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Vec2 middle = (low + high) * 0.5;
  const double half = kGrainShare / 2 * std::min(high.x - low.x, high.y - low.y);
  out.add(0, "LINE");
  out.add(8, kGrain);
  out.point(10, middle - panel.grain * half);
  out.point(11, middle + panel.grain * half);
  out.add(0, "TEXT");
  out.add(8, kCut);
  out.point(10, middle);
  out.number(40, std::min(kTextHeight, half));
  out.add(1, "Piece Name: " + panel.id);
}

void write_block(Groups& out, const Panel& panel, double tolerance) {
  out.add(0, "BLOCK");
  out.add(8, kCut);
  out.add(2, panel.id);
  out.add(70, 0);
  out.point(10, {0, 0});
  write_loop(out, panel.outline, kCut, tolerance);
  for (const Loop& hole : panel.holes) write_loop(out, hole, kInside, tolerance);
  write_grain_and_name(out, panel, tolerance);
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

Status check(const Pattern& pattern) {
  if (pattern.panels.empty()) return Error{"dxf.nothing_to_write", "The pattern has no pieces.", ""};
  for (const Panel& panel : pattern.panels) {
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

Result<std::string> write_dxf(const Pattern& pattern, const DxfWriteSettings& settings) {
  if (Status s = check(pattern); !s) return s.error();
  Groups out;
  write_header(out);
  out.add(0, "SECTION");
  out.add(2, "BLOCKS");
  for (const Panel& panel : pattern.panels) write_block(out, panel, settings.tolerance_mm);
  out.add(0, "ENDSEC");
  out.add(0, "SECTION");
  out.add(2, "ENTITIES");
  for (const Panel& panel : pattern.panels) {
    out.add(0, "INSERT");
    out.add(8, kCut);
    out.add(2, panel.id);
    out.point(10, {0, 0});
  }
  out.add(0, "ENDSEC");
  out.add(0, "EOF");
  return out.take();
}

}  // namespace toile
