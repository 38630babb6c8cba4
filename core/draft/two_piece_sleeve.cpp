#include "core/draft/two_piece_sleeve.h"

#include <utility>

#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

constexpr double kFrontShare = 0.14, kBackShare = 0.27;  // of the sleeve's width, that the under sleeve takes
constexpr double kElbow = 0.45;                          // of the way from the underarm's level to the hem
constexpr double kForward = 0.6;  // of the elbow's bend, that the front seam keeps at the hem

/// The cap's curve parted where it is at `x`.
std::pair<pattern::CubicBezier, pattern::CubicBezier> parted_at(const pattern::CubicBezier& curve, double x) {
  const bool falling = curve.p3.x < curve.p0.x;
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((pattern::evaluate(curve, middle).x > x) == falling ? low : high) = middle;
  }
  return pattern::split(curve, low);
}

/// What both pieces have in common; mm, y from the underarm's level.
struct Seams {
  double elbow = 0, hem = 0;              // levels, below 0
  double front_elbow = 0, front_hem = 0;  // by which the front seam lies inside its upper end
  double back_elbow = 0, back_hem = 0;    // and the back seam
};

/// A seam from its upper end down over the elbow; `inwards` is the sign of x towards the piece's middle.
void add_down(Outline& out, const std::string& edge, double inwards, double elbow_in, double hem_in,
              const Seams& s) {
  const Vec2 top = out.at();
  const Vec2 elbow{top.x + inwards * elbow_in, s.elbow}, hem{top.x + inwards * hem_in, s.hem};
  const Vec2 along = (hem - top) * (1 / length(hem - top));
  out.curve(edge, top + Vec2{inwards * elbow_in * 0.3, (s.elbow - top.y) * 0.35},
            elbow - along * (length(elbow - top) * 0.35), elbow);
  out.notch(-1e-9);
  out.curve(elbow + along * (length(hem - elbow) * 0.35), hem - (hem - elbow) * 0.3, hem);
}

/// The same seam drawn upwards, from the hem's end that the outline stands at.
void add_up(Outline& out, const std::string& edge, Vec2 top, double inwards, double elbow_in, double hem_in,
            const Seams& s) {
  Outline down(top);
  add_down(down, edge, inwards, elbow_in, hem_in, s);
  const std::vector<pattern::CubicBezier>& curves = down.edges().front().curves;
  const pattern::CubicBezier low = pattern::reversed(curves[1]), high = pattern::reversed(curves[0]);
  out.curve(edge, low.p1, low.p2, low.p3).notch(-1e-9);
  out.curve(high.p1, high.p2, high.p3);
}

void add_curve(Outline& out, const std::string& edge, const pattern::CubicBezier& c, double shift) {
  const Vec2 by{shift, 0};
  out.curve(edge, c.p1 + by, c.p2 + by, c.p3 + by);
}

}  // namespace

TwoPieceSleeve left_two_piece_sleeve(const SleeveDraft& d) {
  const pattern::Panel whole = left_sleeve("whole", d);
  const pattern::CubicBezier& cap_back = edge_of(whole, "cap_back").curves.front();
  const pattern::CubicBezier& cap_front = edge_of(whole, "cap_front").curves.front();
  const double back = cap_back.p0.x, front = -cap_front.p3.x, width = back + front;
  const double from_front = width * kFrontShare, from_back = width * kBackShare;
  const auto [back_low, back_high] = parted_at(cap_back, back - from_back);
  const auto [front_high, front_low] = parted_at(cap_front, from_front - front);
  Seams s;
  s.hem = d.cap_height - d.length;
  s.elbow = s.hem * kElbow;
  s.front_elbow = d.elbow_shift;
  s.front_hem = d.elbow_shift * kForward;
  // Both pieces narrow alike: what the hem is smaller by than the sleeve is taken out at the back seam of
  // each. The front seam's hollow goes along with it on both.
  const double taken = (width - d.hem) / 2;
  s.back_hem = taken - s.front_hem;
  s.back_elbow = s.back_hem * 0.25;
  const double left = from_front - front, right = back - from_back;
  Outline top({left + s.front_hem, s.hem});
  top.line("hem", {right - s.back_hem, s.hem});
  add_up(top, "back_seam", back_high.p0, -1, s.back_elbow, s.back_hem, s);
  add_curve(top, "cap_back", back_high, 0);
  add_curve(top, "cap_front", front_high, 0);
  top.notch(0);
  add_down(top, "front_seam", 1, s.front_elbow, s.front_hem, s);
  // The strips behind and before the underarm, side by side: x = 0 is the underarm.
  const Vec2 front_top = front_low.p0 + Vec2{front, 0};
  Outline under({-from_back + s.back_hem, s.hem});
  under.line("hem", {front_top.x - s.front_hem, s.hem});
  add_up(under, "front_seam", front_top, -1, s.front_elbow, s.front_hem, s);
  add_curve(under, "cap_front", front_low, front);
  add_curve(under, "cap_back", back_low, -back);
  add_down(under, "back_seam", 1, s.back_elbow, s.back_hem, s);
  return {piece("left top sleeve", top), piece("left under sleeve", under)};
}

}  // namespace toile::draft
