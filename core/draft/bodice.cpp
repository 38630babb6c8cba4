#include "core/draft/bodice.h"

#include <algorithm>
#include <cmath>

namespace toile::draft {
namespace {

constexpr double kLeastDart = 6;  // mm; less goes in the front's length

HalfBodice half_of(const Wearer& w, const BodiceStyle& s, bool back) {
  const double scale = w.height / 1680;
  const double armhole = w.bust / 8 - 15, ease = s.bust_ease * scale / 4;
  HalfBodice h;
  h.bust = (back ? w.bust / 8 + 55 : w.bust / 4 - 40) + armhole / 2 + ease;
  h.waist = (w.waist + s.waist_ease * scale) / 4 + (back ? -5 : 5) * scale;
  const double dart = 0.25 * std::max(0.0, w.bust - w.underbust);
  h.bust_dart = back || dart < kLeastDart ? 0 : dart;
  const double nape = w.nape_to_waist() + 8 * scale;  // the back is hollow
  const double depth = w.nape_height - w.armpit_height + s.armhole_ease * scale;
  h.underarm = nape - depth + h.bust_dart;
  h.neck = {w.neck / 5 + s.neck_wider * scale, nape + 20 * scale + 0.6 * h.bust_dart};
  h.middle = h.neck.y - (back ? s.back_neck : s.front_neck) * scale;
  const double level = w.shoulder_width / 2 + s.shoulder_shift * scale - h.neck.x;
  h.shoulder = h.neck + normalized(Vec2{1, back ? -0.36 : -0.44}) * (level * 1.077);
  h.chest = std::min(h.shoulder.x, h.bust - armhole / 2 - ease) - (back ? 4 : 16) * scale;
  h.bust_point = {w.bust / 10, w.bust_height - w.waist_height + 0.5 * h.bust_dart};
  return h;
}

}  // namespace

Bodice bodice_of(const Wearer& wearer, const BodiceStyle& style) {
  return {half_of(wearer, style, false), half_of(wearer, style, true)};
}

void match_sides(Bodice& bodice, Vec2 front_low, Vec2 back_low) {
  HalfBodice& front = bodice.front;
  const double over = length(Vec2{front.bust, front.underarm} - front_low) -
                      length(Vec2{bodice.back.bust, bodice.back.underarm} - back_low);
  front.bust_dart = over < kLeastDart ? 0 : over;
  if (front.bust_dart == 0) front.underarm -= over;
}

void add_armhole_and_neck(Outline& out, const HalfBodice& h, double aside) {
  const double deep = h.shoulder.y - h.underarm;
  const Vec2 low{h.bust, h.underarm}, hollow{h.chest, h.underarm + deep * 0.42};
  out.curve("armhole", low - Vec2{(h.bust - h.chest) * 0.62, 0}, hollow - Vec2{0, deep * 0.24}, hollow);
  out.notch(-1e-9);
  const Vec2 down = -perpendicular(normalized(h.shoulder - h.neck));
  out.curve(hollow + Vec2{0, deep * 0.22},
            h.shoulder + Vec2{-std::abs(down.x), -std::abs(down.y)} * (deep * 0.22), h.shoulder);
  out.line("shoulder", h.neck);
  const double drop = h.neck.y - h.middle;
  out.curve("neck", h.neck - Vec2{h.neck.x * 0.04, drop * 0.60}, {h.neck.x * 0.55, h.middle},
            {aside, h.middle});
}

void add_side_with_dart(Outline& out, const HalfBodice& h) {
  const Vec2 low = out.at(), high{h.bust, h.underarm};
  if (h.bust_dart <= 0) {
    out.line("side", high);
    return;
  }
  const double below = std::max(0.2 * (high.y - low.y), 0.32 * (high.y - std::max(0.0, low.y)));
  const Vec2 down = normalized(low - high);
  const Vec2 upper = high + down * below, lower = upper + down * h.bust_dart;
  // Both legs are of one length: the point lies square off the intake's middle, short of the bust point.
  const Vec2 middle = (upper + lower) * 0.5, inwards = perpendicular(normalized(high - low));
  const Vec2 point = middle + inwards * (dot(h.bust_point - middle, inwards) - 25);
  out.line("side_low", lower).line("dart_low", point).line("dart_high", upper).line("side_high", high);
}

}  // namespace toile::draft
