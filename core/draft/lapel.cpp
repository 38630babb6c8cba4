#include "core/draft/lapel.h"

#include <cmath>

#include "core/base/units.h"
#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

/// The roll line and what is square to it.
struct Roll {
  Vec2 top;   // on the shoulder's line
  Vec2 up;    // from the break point
  Vec2 body;  // to the wearer's side
};

Roll roll_of(const LapelDraft& d) {
  Roll r;
  r.top = d.neck + normalized(d.neck - d.shoulder) * (0.75 * d.stand);
  r.up = normalized(r.top - d.break_point);
  r.body = -perpendicular(r.up);
  return r;
}

/// A point told by how it lies to where the gorge crosses the roll line: on the body, and unrolled.
struct RollFrame {
  Roll roll;
  Vec2 origin;
  Vec2 unrolled(double out, double up) const { return origin - roll.body * out + roll.up * up; }
};

RollFrame frame_of(const LapelDraft& d) {
  const Roll r = roll_of(d);
  return {r, r.top - r.up * d.gorge_below};
}

/// The collar's front end, unrolled.
Vec2 collar_tip(const LapelDraft& d) {
  constexpr double kOpen = 62;  // degrees between the lapel's top and the collar's end
  const double slope = radians_from_degrees(d.gorge_slope), turn = radians_from_degrees(kOpen) - slope;
  return frame_of(d).unrolled(d.notch * std::cos(slope) + d.collar_end * std::cos(turn),
                              -d.notch * std::sin(slope) + d.collar_end * std::sin(turn));
}

/// The collar's middle: its lower end on the neckline, the way there along the neck, and its height's.
struct CollarMiddle {
  Vec2 low, along, up;
};

CollarMiddle middle_of(const LapelDraft& d) {
  const Roll r = roll_of(d);
  const double a = radians_from_degrees(d.spread);
  const Vec2 along = r.up * std::cos(a) + r.body * std::sin(a);
  // The neck's edge is bent; by what its chord is shorter.
  const double chord = d.back_neck * (1 - a * a / 24);
  const Vec2 half = normalized(along + r.up);
  return {d.neck + half * chord, along, perpendicular(along)};
}

}  // namespace

Lapel lapel_of(const LapelDraft& d) {
  const RollFrame f = frame_of(d);
  const double slope = radians_from_degrees(d.gorge_slope), c = std::cos(slope), s = std::sin(slope);
  Lapel l;
  l.roll_top = f.origin;
  l.notch = f.unrolled(d.notch * c, -d.notch * s);
  l.tip = f.unrolled(d.width * c, -d.width * s);
  // The gorge goes on straight, unrolled, to a line through the neck along the roll line.
  const double inside = dot(d.neck - f.origin, f.roll.body);
  l.gorge_inner = f.unrolled(-inside, inside * s / c);
  const Vec2 way = d.break_point - l.tip;
  const Vec2 out = perpendicular(normalized(way)) * -0.035 * length(way);
  l.edge_handle = l.tip + way * 0.33 + out;
  l.edge_low_handle = l.tip + way * 0.72 + out;
  return l;
}

void add_lapel(Outline& out, const LapelDraft& d) {
  const Lapel l = lapel_of(d);
  out.line("front_neck", l.gorge_inner).line("gorge_inner", l.roll_top).line("gorge_outer", l.notch);
  out.line("lapel_top", l.tip);
  out.curve("lapel", l.edge_handle, l.edge_low_handle, d.break_point);
}

pattern::InnerLine lapel_roll(const LapelDraft& d) {
  return {"roll", {d.break_point, lapel_of(d).roll_top}, false};
}

pattern::Panel collar_of(const std::string& id, const LapelDraft& d) {
  const Lapel l = lapel_of(d);
  const Roll r = roll_of(d);
  const CollarMiddle m = middle_of(d);
  // Mirrored: the collar's right half lies at x > 0.
  const auto flat = [&](Vec2 p) { return Vec2{-dot(p - m.low, m.along), dot(p - m.low, m.up)}; };
  const double tall = d.stand + d.fall;
  Outline out({0, 0});
  out.curve("neck", flat(m.low - m.along * (d.back_neck * 0.35)), flat(d.neck + r.up * (d.back_neck * 0.35)),
            flat(d.neck));
  out.notch(0);
  out.line("front_neck", flat(l.gorge_inner)).line("gorge_inner", flat(l.roll_top));
  out.line("gorge_outer", flat(l.notch));
  const Vec2 tip = collar_tip(d), high = m.low + m.up * tall, way = high - tip;
  out.line("end", flat(tip));
  out.curve("top", flat(tip + r.up * (length(way) * 0.35)), flat(high - m.along * (length(way) * 0.4)),
            {0, tall});
  pattern::Panel panel = unfolded(id, out, "right", "left");
  const Vec2 high_roll = m.low + m.up * d.stand;
  const double third = length(high_roll - r.top) * 0.35;
  const pattern::CubicBezier bend{r.top, r.top + r.up * third, high_roll - m.along * third, high_roll};
  std::vector<Vec2> half{flat(l.roll_top)};
  for (const Vec2 p : pattern::flatten(bend, 0.2)) half.push_back(flat(p));
  pattern::InnerLine roll{"roll", half, false};
  for (auto p = half.rbegin() + 1; p != half.rend(); ++p) roll.points.push_back({-p->x, p->y});
  panel.lines.push_back(roll);
  return panel;
}

}  // namespace toile::draft
