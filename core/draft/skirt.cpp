#include "core/draft/skirt.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/draft/arc.h"
#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

constexpr double kSkirtPiecesApart = 60;  // mm between pieces of the layout

struct Check {
  const char* name;
  double value, low, high;
};

Status check(const SkirtMeasures& m) {
  const Check checks[] = {{"waist", m.waist, 200, 3000},
                          {"hip", m.hip, 200, 3000},
                          {"waist_to_hip", m.waist_to_hip, 20, 600},
                          {"length", m.length, m.waist_to_hip + 20, 2000},
                          {"waist_ease", m.waist_ease, 0, 500},
                          {"hip_ease", m.hip_ease, 0, 1000},
                          {"hem", m.hem, std::max(m.waist + m.waist_ease, m.hip + m.hip_ease), 9000},
                          {"band_height", m.band_height, 10, 300}};
  for (const Check& c : checks) {
    if (c.value >= c.low && c.value <= c.high) continue;
    return Error{"draft.measure",
                 std::string(c.name) + " is " + fixed_text(c.value, 6) + " mm; it must lie between " +
                     fixed_text(c.low, 6) + " and " + fixed_text(c.high, 6) + ".",
                 c.name};
  }
  return {};
}

double half_waist(const SkirtMeasures& m) { return (m.waist + m.waist_ease) / 2; }

/// Angle of the ring sector that one piece is.
double sector(const SkirtMeasures& m) { return (m.hem / 2 - half_waist(m)) / m.length; }

// Points of a piece by distance down from the waist and arc length off its middle.
class Sector {
 public:
  explicit Sector(const SkirtMeasures& m) : middle_(skirt_middle(m, false)), radius_(skirt_waist_radius(m)) {}
  void move_to(double middle) { middle_ = middle; }

  Vec2 at(double down, double angle) const {
    const double r = radius_ + down;
    const double s = std::sin(angle / 2);
    return {middle_ + r * std::sin(angle),
            2 * r * s * s - down};  // radius - r cos(angle), without cancellation
  }

  /// The arc at `down` between two angles.
  std::vector<pattern::CubicBezier> arc(double down, double from, double to) const {
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / kMostPerCurve)));
    std::vector<pattern::CubicBezier> out;
    Vec2 start = at(down, from);
    for (int i = 0; i < parts; ++i) {
      const double a = from + (to - from) * i / parts, b = from + (to - from) * (i + 1) / parts;
      const double handle = (radius_ + down) * 4 / 3 * std::tan((b - a) / 4);
      const Vec2 end = at(down, b);
      out.push_back({start, start + Vec2{std::cos(a), std::sin(a)} * handle,
                     end - Vec2{std::cos(b), std::sin(b)} * handle, end});
      start = end;
    }
    return out;
  }

 private:
  double middle_, radius_;
};

// How far each side of a piece swells beyond the cone at the hip: a quarter of what the whole girth lacks.
double hip_swell(const SkirtMeasures& m) {
  const double cone = (half_waist(m) + sector(m) * m.waist_to_hip) * 2;
  return std::max(0.0, (m.hip + m.hip_ease - cone) / 4);
}

// The side seam from the hem up to the waist, at positive angles.
std::vector<pattern::CubicBezier> side(const Sector& piece, const SkirtMeasures& m, double half) {
  const Vec2 hem = piece.at(m.length, half), waist = piece.at(0, half);
  const double swell = hip_swell(m);
  if (swell <= 0) return {pattern::line_segment(hem, waist)};
  const Vec2 out{std::cos(half), std::sin(half)}, up = normalized(waist - hem);
  const Vec2 hip = piece.at(m.waist_to_hip, half) + out * swell;
  const double below = (m.length - m.waist_to_hip) / 3, above = m.waist_to_hip / 3;
  return {{hem, hem + (hip - hem) * (1.0 / 3), hip - up * below, hip},
          {hip, hip + up * above, waist + (hip - waist) * (1.0 / 3), waist}};
}

std::vector<pattern::CubicBezier> mirrored(const std::vector<pattern::CubicBezier>& curves, double middle) {
  std::vector<pattern::CubicBezier> out;
  const auto flip = [&](Vec2 p) { return Vec2{2 * middle - p.x, p.y}; };
  for (size_t i = curves.size(); i-- > 0;) {
    const pattern::CubicBezier& c = curves[i];
    out.push_back({flip(c.p3), flip(c.p2), flip(c.p1), flip(c.p0)});
  }
  return out;
}

// Corners are computed once and shared, so that edges meet exactly.
void close_exactly(pattern::Loop& loop) {
  for (size_t i = 0; i < loop.edges.size(); ++i) {
    loop.edges[(i + 1) % loop.edges.size()].curves.front().p0 = loop.edges[i].curves.back().p3;
  }
}

pattern::Panel skirt_piece(const SkirtMeasures& m, bool back) {
  const double angle = sector(m), middle = skirt_middle(m, back);
  pattern::Panel panel;
  panel.id = back ? "back" : "front";
  const std::string right_hand = back ? "side_right" : "side_left",
                    left_hand = back ? "side_left" : "side_right";
  if (angle < 1e-9) {  // no flare: a rectangle, with the hips no wider than the waist
    const double w = half_waist(m) / 2;
    const Vec2 a{middle - w, -m.length}, b{middle + w, -m.length}, c{middle + w, 0}, d{middle - w, 0};
    panel.outline.edges = {{"hem", {pattern::line_segment(a, b)}},
                           {right_hand, {pattern::line_segment(b, c)}},
                           {"waist", {pattern::line_segment(c, d)}},
                           {left_hand, {pattern::line_segment(d, a)}}};
    return panel;
  }
  Sector piece(m);
  piece.move_to(middle);
  const std::vector<pattern::CubicBezier> right = side(piece, m, angle / 2);
  panel.outline.edges = {{"hem", piece.arc(m.length, -angle / 2, angle / 2)},
                         {right_hand, right},
                         {"waist", piece.arc(0, angle / 2, -angle / 2)},
                         {left_hand, mirrored(right, middle)}};
  close_exactly(panel.outline);
  return panel;
}

pattern::Panel band_piece(const SkirtMeasures& m, bool back) {
  const double w = half_waist(m) / 2, low = skirt_band_bottom(m), high = low + m.band_height;
  const double x = skirt_middle(m, back);
  pattern::Panel panel;
  panel.id = back ? "band_back" : "band_front";
  const Vec2 a{x - w, low}, b{x + w, low}, c{x + w, high}, d{x - w, high};
  panel.outline.edges = {{"skirt", {pattern::line_segment(a, b)}},
                         {back ? "end_right" : "end_left", {pattern::line_segment(b, c)}},
                         {"top", {pattern::line_segment(c, d)}},
                         {back ? "end_left" : "end_right", {pattern::line_segment(d, a)}}};
  return panel;
}

}  // namespace

double skirt_waist_radius(const SkirtMeasures& m) {
  return sector(m) > 0 ? half_waist(m) / sector(m) : std::numeric_limits<double>::infinity();
}

double skirt_middle(const SkirtMeasures& m, bool back) { return back ? m.hem / 2 + kSkirtPiecesApart : 0; }

double skirt_band_bottom(const SkirtMeasures& m) {
  // Above the ends of the waist line, which curve upwards.
  const double s = std::sin(sector(m) / 4);
  const double rise = sector(m) > 1e-9 ? 2 * skirt_waist_radius(m) * s * s : 0;
  return std::ceil(rise + kSkirtPiecesApart);
}

Result<pattern::Pattern> draft_skirt(const SkirtMeasures& measures) {
  TRY(check(measures));
  // Edges in the order hem, +x side, waist, -x side; bands: skirt, +x end, top, -x end.
  enum : Index { kFront, kBack, kBandFront, kBandBack };
  enum : Index { kLow, kPlusX, kHigh, kMinusX };
  if (sector(measures) >= kPi) {
    return Error{"draft.measure", "The hem is too wide for this length: a piece would be over half a ring.",
                 "hem"};
  }
  if (sector(measures) < 1e-9 && hip_swell(measures) > 0) {
    return Error{"draft.measure", "Without flare the hips must be no wider than the waist.", "hem"};
  }
  pattern::Pattern p;
  p.panels = {skirt_piece(measures, false), skirt_piece(measures, true), band_piece(measures, false),
              band_piece(measures, true)};
  const auto seam = [&](const char* id, Index a, Index edge_a, Index b, Index edge_b) {
    p.seams.push_back({id, {{a, edge_a, false}}, {{b, edge_b, false}}, false});
  };
  seam("side_left", kFront, kPlusX, kBack, kMinusX);
  seam("side_right", kFront, kMinusX, kBack, kPlusX);
  seam("band_left", kBandFront, kPlusX, kBandBack, kMinusX);
  seam("band_right", kBandFront, kMinusX, kBandBack, kPlusX);
  seam("waist_front", kFront, kHigh, kBandFront, kLow);
  seam("waist_back", kBack, kHigh, kBandBack, kLow);
  return p;
}

}  // namespace toile::draft
