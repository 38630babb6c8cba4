#include "core/draft/trousers.h"

#include <algorithm>
#include <cmath>

#include "core/draft/dart.h"
#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

/// One leg's front or back; side seam at x = 0, the middle of the body at x > 0, hem at y = 0; mm.
struct Leg {
  double width;      ///< at the hips
  double crotch;     ///< how far the crotch point lies beyond the middle
  double waist;      ///< width of the finished piece there
  double hem, knee;  ///< widths
  double middle_in;  ///< the middle seam leans so far
  double middle_up;  ///< and rises so far above the waist's level
  double dart, dart_length;
  double hips, top;  ///< heights of hips and waist
  double crotch_level;
  double crease_up;    ///< how far above it the pressed crease ends
  double side_up = 0;  ///< the side's upper end above the waist's level
};

double crease(const Leg& leg) { return (leg.width + leg.crotch) / 2 - 5; }
double knee_level(const Leg& leg) { return leg.crotch_level * 0.55; }

/// From the hem up to the hips and the waist, drawn upwards.
Outline side_seam(const Leg& leg) {
  const double x = crease(leg), knee = knee_level(leg);
  const Vec2 low{x - leg.hem / 2, 0}, bent{x - leg.knee / 2, knee};
  const double in = leg.width - leg.middle_in - leg.waist - leg.dart;
  const Vec2 up = normalized(bent - low), hip{0, leg.hips}, top{in, leg.top + leg.side_up};
  Outline out(low);
  out.line("side", bent);
  out.curve(bent + up * ((leg.hips - knee) * 0.35), hip - Vec2{0, (leg.hips - knee) * 0.35}, hip);
  const double rise = top.y - hip.y;
  out.curve(hip + Vec2{0, rise * 0.4}, top - Vec2{in * 0.35, rise * 0.4}, top);
  out.notch(-rise);
  return out;
}

Vec2 crotch_point(const Leg& leg) { return {leg.width + leg.crotch, leg.crotch_level}; }

void add_inseam(Outline& out, const Leg& leg) {
  const Vec2 knee{crease(leg) + leg.knee / 2, knee_level(leg)}, point = crotch_point(leg);
  const Vec2 up = normalized(knee - out.at()), way = point - knee;
  out.line("inseam", knee).notch(-1e-9);
  out.curve(knee + up * (length(way) * 0.36), knee + way * 0.72 + Vec2{-leg.crotch * 0.10, 0}, point);
}

double inseam_length(const Leg& leg) {
  Outline out({crease(leg) + leg.hem / 2, 0});
  add_inseam(out, leg);
  return pattern::arc_length(out.edges()[0]);
}

/// The middle's seam from the crotch point around and up to the waist.
void add_middle(Outline& out, const Leg& leg) {
  const Vec2 top{leg.width - leg.middle_in, leg.top + leg.middle_up};
  const Vec2 straight{leg.width, leg.crotch_level + 0.62 * (leg.hips - leg.crotch_level) + leg.crotch * 0.35};
  const Vec2 lean = normalized(top - straight);
  const double rise = straight.y - leg.crotch_level;
  out.curve("crotch", out.at() - Vec2{leg.crotch * 0.62, 0}, straight - lean * (rise * 0.62), straight);
  out.line(top);
}

Dart dart_of(const Leg& leg) { return {(leg.waist + leg.dart) / 2, leg.dart, leg.dart_length}; }

pattern::Panel leg_piece(const std::string& id, const Leg& leg) {
  const Outline side = side_seam(leg);
  Outline out({crease(leg) - leg.hem / 2, 0});
  out.line("hem", {crease(leg) + leg.hem / 2, 0});
  add_inseam(out, leg);
  add_middle(out, leg);
  waist_with_dart(out, side.at(), dart_of(leg), "middle", "side");
  for (auto c = side.edges()[0].curves.rbegin(); c != side.edges()[0].curves.rend(); ++c) {
    const pattern::CubicBezier back = pattern::reversed(*c);
    c == side.edges()[0].curves.rbegin() ? out.curve("side", back.p1, back.p2, back.p3)
                                         : out.curve(back.p1, back.p2, back.p3);
  }
  out.notch(leg.top - leg.hips);
  pattern::Panel panel = piece(id, out);
  panel.lines.push_back(
      {"crease", {{crease(leg), 0}, {crease(leg), leg.crotch_level + leg.crease_up}}, false});
  return panel;
}

/// Makes a figure as great as `wanted` by the leg's own member, which lies between the two.
template <typename Figure>
void solve(Leg& leg, double Leg::*member, double low, double high, double wanted, Figure figure) {
  for (int i = 0; i < 50; ++i) {
    leg.*member = (low + high) / 2;
    (figure(leg) < wanted ? low : high) = leg.*member;
  }
}

double outseam_length(const Leg& leg) { return pattern::arc_length(side_seam(leg).edges()[0]); }

struct Legs {
  Leg front, back;
  double band;
};

Legs legs_of(const Wearer& w, const SlacksStyle& s) {
  const double scale = w.height / 1680;
  const double hip = w.hip + s.hip_ease * scale, waist = w.waist + s.waist_ease * scale;
  Leg front{}, back{};
  front.width = hip / 4 - 10 * scale;
  back.width = hip / 4 + 10 * scale;
  front.crotch = w.hip / 20;
  back.crotch = w.hip / 10 - 4 * scale;
  front.waist = waist / 4 + 5 * scale;
  back.waist = waist / 4 - 5 * scale;
  for (Leg* leg : {&front, &back}) {
    const bool rear = leg == &back;
    const double much = std::max(0.0, leg->width - leg->waist);
    leg->middle_in = rear ? std::max(20 * scale, much * 0.35) : much * 0.14;
    leg->middle_up = rear ? 22 * scale : 0;
    leg->dart = much * (rear ? 0.40 : 0.36);
    leg->dart_length = (rear ? 125 : 90) * scale;
    leg->hem = (rear ? s.back_hem : s.front_hem) * w.hip / 1000;
    leg->knee = leg->hem + 22 * scale;
    leg->crotch_level = w.inseam - (s.rise_ease + s.above_floor) * scale;
    leg->crease_up = (rear ? 0 : 90) * scale;
    leg->hips = w.hip_height - s.above_floor * scale;
    leg->top = w.waist_height - s.above_floor * scale;
  }
  // What is sewn together is of one length: the back's crotch point sinks, its side rises.
  const double inseam = inseam_length(front), side = outseam_length(front), level = back.crotch_level;
  solve(back, &Leg::crotch_level, level - 60, level + 60, inseam, inseam_length);
  solve(back, &Leg::side_up, -40, 40, side, outseam_length);
  return {front, back, waist};
}

void sew_together(Garment& g, const Legs& legs) {
  for (const std::string side : {"left", "right"}) {
    const std::string front = side + " front", back = side + " back";
    sew(g, "side_" + side, {{front, "side"}}, {{back, "side"}});
    sew(g, "inseam_" + side, {{front, "inseam"}}, {{back, "inseam"}});
    for (const auto& [piece, leg] : {std::pair(front, &legs.front), std::pair(back, &legs.back)})
      if (is_sewn(dart_of(*leg))) sew(g, "dart " + piece, {{piece, "dart_middle"}}, {{piece, "dart_side"}});
  }
  sew(g, "crotch_front", {{"right front", "crotch"}}, {{"left front", "crotch"}});
  sew(g, "crotch_back", {{"right back", "crotch"}}, {{"left back", "crotch"}});
  sew(g, "waistband", {{"waistband", "waist"}},
      {{"right front", "waist_middle"},
       {"right front", "waist_side"},
       {"right back", "waist_side"},
       {"right back", "waist_middle"},
       {"left back", "waist_middle"},
       {"left back", "waist_side"},
       {"left front", "waist_side"},
       {"left front", "waist_middle"}});
  sew(g, "waistband_end", {{"waistband", "end_a"}}, {{"waistband", "end_b"}});
}

/// The stitching of the fly: down beside the middle and round to it.
pattern::InnerLine fly_of(const Leg& front, double scale) {
  const double x = front.width - front.middle_in, wide = 32 * scale, low = front.top - 150 * scale;
  return {"fly",
          {{x - wide, front.top - 4 * scale},
           {x - wide + 4 * scale, low + 45 * scale},
           {x - wide * 0.6, low + 14 * scale},
           {x - 2 * scale, low}},
          true};
}

}  // namespace

Garment draft_slacks(const Wearer& w, const SlacksStyle& s) {
  const double scale = w.height / 1680;
  const Legs legs = legs_of(w, s);
  Garment g{.name = "slacks", .title = "Slacks"};
  g.cloths = {{"suiting", "wool-suiting", {0.07, 0.08, 0.12}},
              {"twill", "twill", {0.32, 0.24, 0.14}},
              {"denim", "denim-10oz", {0.03, 0.06, 0.14}}};
  pattern::Panel right = leg_piece("right front", legs.front);
  const pattern::Panel left = leg_piece("left back", legs.back);
  std::vector<pattern::Panel>& panels = g.pattern.panels;
  panels = {right, mirrored(right, "left front"), mirrored(left, "right back"), left};
  panels[1].lines.push_back(fly_of(legs.front, scale));
  for (Vec2& p : panels[1].lines.back().points) p.x = -p.x;
  double around = 0;
  for (const pattern::Panel& p : panels) around += length_of(p, {"waist_middle", "waist_side"});
  panels.push_back(strip("waistband", "waist", around, s.band_height * scale));
  for (size_t leg = 0; leg < 4; ++leg)
    g.folds.push_back({"crease " + panels[leg].id, panels[leg].id, {"crease"}, s.crease_angle, 20});
  g.interlinings = {{"waistband", "interlining"}};
  sew_together(g, legs);
  g.girths = {{"waist", w.waist, around}, {"hip", w.hip, 2 * (legs.front.width + legs.back.width)}};
  lay_out(g);
  return g;
}

}  // namespace toile::draft
