#include "core/draft/princess.h"

#include <algorithm>
#include <cmath>

namespace toile::draft {
namespace {

constexpr double kBesideMiddle = 0.33;  // of what is taken in at the waist, beside the middle's seam
constexpr double kSeamsHip = 0.35;      // of what the hips are wider by, that the seam lets out
constexpr double kBladeAside = 0.50;    // of the back's width, where the seam passes the blade
constexpr double kBladeBelow = 0.20;    // of the armhole's depth, below the underarm

Vec2 about(Vec2 centre, double angle, Vec2 p) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec2 d = p - centre;
  return centre + Vec2{c * d.x - s * d.y, s * d.x + c * d.y};
}

/// Armhole from the underarm to its hollow, and from there to the shoulder.
std::vector<pattern::CubicBezier> armhole_of(const HalfBodice& h) {
  Outline out({h.bust, h.underarm});
  add_armhole_and_neck(out, h);
  return out.edges().front().curves;
}

/// The point over which the seam runs.
Vec2 apex(const PrincessHalf& half) {
  const HalfBodice& h = half.block;
  if (!half.back) return h.bust_point;
  return {h.bust * kBladeAside, h.underarm - kBladeBelow * (h.shoulder.y - h.underarm)};
}

double middle_at_waist(const PrincessHalf& half) { return half.middle_in; }

/// Taken in at the waist by the seam, and by the side; less than nothing where the waist is wider.
double seam_in(const PrincessHalf& half) {
  const double all = half.block.bust - middle_at_waist(half) - half.waist;
  return all > 0 ? all * (1 - kBesideMiddle) : 0;
}
double side_x(const PrincessHalf& half) {
  const double all = half.block.bust - middle_at_waist(half) - half.waist;
  return half.block.bust - (all > 0 ? all * kBesideMiddle : all);
}

struct Level {
  double middle, side;  // where the seam's two sides are
  double outer;         // the side seam
};

/// At the hips or the hem, where the half is `width` wide.
Level level_below(const PrincessHalf& half, double width) {
  const double over = width - (half.block.bust - half.middle_in), x = apex(half).x;
  const double out = over * kSeamsHip / 2;
  return {x + out, x - out, half.block.bust + over * (1 - kSeamsHip)};
}

/// From the hem up to the apex, on the middle's side or the other; `lean` is the angle at which it passes the
/// apex.
void add_seam_up(Outline& out, const PrincessHalf& half, bool side, double lean) {
  const Level hip = level_below(half, half.hip);
  const double x = apex(half).x + (side ? 0.5 : -0.5) * seam_in(half), at_hip = side ? hip.side : hip.middle;
  const double down = -half.hips;
  const Vec2 hips{at_hip, half.hips}, up = normalized(hips - out.at()), top = apex(half);
  out.line("princess", hips);
  out.curve(hips + up * (down * 0.4), {x, -down * 0.35}, {x, 0}).notch(-1e-9);
  out.curve({x, top.y * 0.35}, about(top, lean, top - Vec2{0, top.y * 0.35}), top);
}

/// From the apex to the armhole's hollow.
pattern::CubicBezier upper_seam(const PrincessHalf& half, double lean) {
  const Vec2 low = apex(half), high = armhole_of(half.block).front().p3;
  const double rise = high.y - low.y;
  return {low, about(low, lean, low + Vec2{0, rise * 0.5}), high - Vec2{(high.x - low.x) * 0.45, rise * 0.12},
          high};
}

/// The side panel's underarm, the dart closed.
Vec2 underarm_of(const PrincessHalf& half) {
  return about(apex(half), -half.angle, {half.block.bust, half.block.underarm});
}

double side_length(const PrincessHalf& half) { return length(underarm_of(half) - Vec2{side_x(half), 0}); }

PrincessHalf half_of(const HalfBodice& block, const PrincessLevels& l, bool back) {
  return {block, l.waist, l.hip, l.hem, l.hips, l.low, back ? l.back_middle_in : 0, 0, back};
}

}  // namespace

PrincessBodice princess_of(const Bodice& block, const PrincessLevels& l) {
  PrincessBodice out{half_of(block.front, l, false), half_of(block.back, l, true)};
  const double wanted = side_length(out.back);
  double low = -0.2, high = 0.7;
  for (int i = 0; i < 60; ++i) {
    out.front.angle = (low + high) / 2;
    (side_length(out.front) > wanted ? low : high) = out.front.angle;
  }
  return out;
}

Vec2 middle_panel_hem(const PrincessHalf& half) { return {level_below(half, half.hem).middle, half.low}; }

void add_middle_panel(Outline& out, const PrincessHalf& half) {
  add_seam_up(out, half, false, 0);
  const pattern::CubicBezier upper = upper_seam(half, 0);
  out.curve(upper.p1, upper.p2, upper.p3);
  const pattern::CubicBezier armhole = armhole_of(half.block).back();
  out.curve("armhole", armhole.p1, armhole.p2, armhole.p3);
}

pattern::Panel side_panel(const std::string& id, const PrincessHalf& half) {
  const Level hip = level_below(half, half.hip), hem = level_below(half, half.hem);
  Outline seam({hem.side, half.low});  // drawn upwards, to be turned around
  add_seam_up(seam, half, true, -half.angle / 2);
  Outline out({hem.side, half.low});
  out.line("hem", {hem.outer, half.low});
  const Vec2 hips{hip.outer, half.hips}, up = normalized(hips - out.at()), waist{side_x(half), 0};
  out.line("side", hips);
  out.curve(hips + up * (-half.hips * 0.4), waist + Vec2{0, half.hips * 0.35}, waist).notch(-1e-9);
  const Vec2 top = underarm_of(half);
  out.curve(waist + Vec2{0, top.y * 0.3}, top - (top - waist) * 0.4, top);
  const auto closed = [&](Vec2 p) { return about(apex(half), -half.angle, p); };
  const pattern::CubicBezier armhole = armhole_of(half.block).front();
  out.curve("armhole", closed(armhole.p1), closed(armhole.p2), closed(armhole.p3));
  const pattern::CubicBezier upper = pattern::reversed(upper_seam(half, half.angle / 2));
  out.curve("princess", closed(upper.p1), closed(upper.p2), apex(half));
  const std::vector<pattern::CubicBezier>& low = seam.edges().front().curves;
  for (std::size_t i = low.size(); i-- > 0;) {
    const pattern::CubicBezier down = pattern::reversed(low[i]);
    out.curve(down.p1, down.p2, down.p3);
  }
  return piece(id, out);
}

Vec2 back_middle_hem(const PrincessHalf& half) { return {half.middle_in * 0.8, half.low}; }

void add_back_middle(Outline& out, const PrincessHalf& half) {
  const double top = out.at().y, in = half.middle_in;
  out.curve("middle", {0, top * 0.65}, {in, top * 0.30}, {in, 0});
  out.notch(-1e-9);
  const Vec2 hem = back_middle_hem(half);
  out.curve({in, half.low * 0.33}, hem - Vec2{0, half.low * 0.33}, hem);
}

}  // namespace toile::draft
