#include "core/draft/blouse.h"

#include <algorithm>

#include "core/draft/bodice.h"
#include "core/draft/dart.h"
#include "core/draft/sleeve.h"
#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

/// Below the waist, y from it; mm.
struct Body {
  Bodice bodice;
  double waist, hip;  ///< quarters' widths
  double hips, hem;   ///< heights, below 0
  double placket;     ///< half its width
};

Body body_of(const Wearer& w, const BlouseStyle& s) {
  const double scale = w.height / 1680;
  Body b{};
  b.bodice = bodice_of(w, {.bust_ease = s.bust_ease,
                           .waist_ease = 0,
                           .armhole_ease = 25,
                           .neck_wider = 10,
                           .front_neck = 78,
                           .back_neck = 20,
                           .shoulder_shift = 4});
  const double quarter = (b.bodice.front.bust + b.bodice.back.bust) / 2;
  b.hip = std::max(quarter, (w.hip + s.hip_ease * scale) / 4);
  b.waist = std::max(quarter - s.waist_in * scale, (w.waist + 90 * scale) / 4);
  b.hips = -w.waist_to_hip();
  b.hem = b.hips - s.below_hip * scale;
  b.placket = s.placket * scale / 2;
  match_sides(b.bodice, {b.waist, 0}, {b.waist, 0});
  return b;
}

/// From the hem's outer end up to the waist and on to the underarm; front and back are alike up to the waist.
void add_side(Outline& out, const Body& b, const HalfBodice& half) {
  const double down = -b.hips;
  out.line("side_hem", {b.hip, b.hips}).notch(-1e-9);
  out.curve("side_hip", {b.hip, b.hips + down * 0.4}, {b.waist, -down * 0.4}, {b.waist, 0}).notch(-1e-9);
  add_side_with_dart(out, half);
}

pattern::Panel left_front(const Body& b) {
  Outline out({b.placket, b.hem});
  out.line("hem", {b.hip, b.hem});
  add_side(out, b, b.bodice.front);
  add_armhole_and_neck(out, b.bodice.front, b.placket);
  out.line("edge", {b.placket, b.hem});
  return piece("left front", out);
}

pattern::Panel back_of(const Body& b) {
  Outline half({0, b.hem});
  half.line("hem", {b.hip, b.hem});
  add_side(half, b, b.bodice.back);
  add_armhole_and_neck(half, b.bodice.back);
  return unfolded("back", half, "right", "left");
}

pattern::Panel placket_of(const Body& b) {
  const double top = b.bodice.front.middle;
  Outline out({-b.placket, b.hem});
  out.line("hem", {b.placket, b.hem}).line("left", {b.placket, top});
  out.line("top_left", {0, top}).line("top_right", {-b.placket, top}).line("right", {-b.placket, b.hem});
  return piece("placket", out);
}

/// Rises towards the front, so that it leans to the neck. The fall sits on its "top", as far as the fronts do
/// not lap over each other.
pattern::Panel stand_of(double length, double height, double lap) {
  const double middle = length / 2, rise = 9, top = height - 1, slope = 0.09;
  const double end = rise + top - slope * lap;
  Outline out({0, rise});
  out.curve("neck", {middle * 0.4, rise * 0.05}, {middle * 0.6, 0}, {middle, 0}).notch(-1e-9);
  out.curve({middle * 1.4, 0}, {middle * 1.6, rise * 0.05}, {length, rise});
  out.line("end_b", {length - 3, rise + top}).line("lap_b", {length - 3 - lap, end});
  out.curve("top", {middle * 1.6, height + rise * 0.05}, {middle * 1.4, height}, {middle, height});
  out.notch(-1e-9);
  out.curve({middle * 0.6, height}, {middle * 0.4, height + rise * 0.05}, {3 + lap, end});
  out.line("lap_a", {3, rise + top}).line("end_a", {0, rise});
  return piece("collar stand", out);
}

/// Bent the other way than the stand, so that it falls over it, with points.
pattern::Panel fall_of(double length, double fall, double scale) {
  const double middle = length / 2, bend = 8 * scale, lean = 14 * scale, point = fall + 16 * scale;
  const double back = bend + fall;
  Outline out({0, 0});
  out.curve("neck", {middle * 0.4, bend * 0.8}, {middle * 0.6, bend}, {middle, bend}).notch(-1e-9);
  out.curve({middle * 1.4, bend}, {middle * 1.6, bend * 0.8}, {length, 0});
  out.line("end_b", {length + lean, point});
  out.curve("edge", {middle * 1.6, back}, {middle * 1.4, back}, {middle, back});
  out.curve({middle * 0.6, back}, {middle * 0.4, back}, {-lean, point});
  out.line("end_a", {0, 0});
  return piece("collar", out);
}

std::vector<EdgeName> sides(const std::string& piece, const std::string& suffix, bool dart, bool upwards) {
  std::vector<EdgeName> out{{piece, "side_hem" + suffix}, {piece, "side_hip" + suffix}};
  if (dart) {
    out.push_back({piece, "side_low" + suffix});
    out.push_back({piece, "side_high" + suffix});
  } else {
    out.push_back({piece, "side" + suffix});
  }
  if (!upwards) std::reverse(out.begin(), out.end());
  return out;
}

void sew_body(Garment& g, bool dart) {
  for (const std::string side : {"left", "right"}) {
    const std::string front = side + " front", sleeve = side + " sleeve", cuff = side + " cuff";
    sew(g, "placket_" + side, {{front, "edge"}}, {{"placket", side}});
    sew(g, "shoulder_" + side, {{front, "shoulder"}}, {{"back", "shoulder_" + side}});
    sew(g, "side_" + side, sides(front, "", dart, side == "left"),
        sides("back", "_" + side, false, side == "right"));
    if (dart) sew(g, "bust_dart_" + side, {{front, "dart_low"}}, {{front, "dart_high"}});
    sew(g, "armhole_front_" + side, {{front, "armhole"}}, {{sleeve, "cap_front"}});
    sew(g, "armhole_back_" + side, {{"back", "armhole_" + side}}, {{sleeve, "cap_back"}});
    sew(g, "underarm_" + side, {{sleeve, "underarm_front"}}, {{sleeve, "underarm_back"}});
    sew(g, "cuff_" + side, {{sleeve, "hem"}}, {{cuff, "top"}});
    sew(g, "cuff_end_" + side, {{cuff, "end_a"}}, {{cuff, "end_b"}});
  }
}

void sew_collar(Garment& g) {
  sew(g, "fall", {{"collar", "neck"}}, {{"collar stand", "top"}});
  sew(g, "neck", {{"collar stand", "neck"}},
      {{"placket", "top_right"},
       {"right front", "neck"},
       {"back", "neck"},
       {"left front", "neck"},
       {"placket", "top_left"}});
}

void add_sleeves(Garment& g, const Wearer& w, const BlouseStyle& s, const pattern::Panel& front,
                 const pattern::Panel& back) {
  const double scale = w.height / 1680;
  SleeveDraft d;
  d.front_armhole = length_of(front, {"armhole"});
  d.back_armhole = length_of(back, {"armhole_left"});
  d.cap_ease = 0.02;
  d.cap_height = 0.29 * (d.front_armhole + d.back_armhole);
  const double cuff = w.wrist + s.cuff_ease * scale;
  d.length = w.arm_length + (25 - s.cuff) * scale;
  d.hem = cuff * s.fullness;
  d.elbow_shift = 5 * scale;
  const pattern::Panel left = left_sleeve("left sleeve", d);
  const pattern::Panel band = strip("left cuff", "hem", cuff, s.cuff * scale);
  for (const pattern::Panel& p : {left, mirrored(left, "right sleeve"), band, mirrored(band, "right cuff")})
    g.pattern.panels.push_back(p);
}

}  // namespace

Garment draft_blouse(const Wearer& w, const BlouseStyle& s) {
  const double scale = w.height / 1680;
  const Body b = body_of(w, s);
  Garment g{.name = "blouse", .title = "Blouse"};
  g.cloths = {{"shirting", "shirting", {0.55, 0.62, 0.70}},
              {"poplin", "poplin", {0.72, 0.72, 0.72}},
              {"silk", "silk-habotai", {0.52, 0.36, 0.32}}};
  const pattern::Panel left = left_front(b), back = back_of(b);
  g.pattern.panels = {left, mirrored(left, "right front"), back, placket_of(b)};
  add_sleeves(g, w, s, left, back);
  const double neck = 2 * length_of(left, {"neck"}) + length_of(back, {"neck"}) + 2 * b.placket;
  const pattern::Panel stand = stand_of(neck, s.stand * scale, b.placket);
  for (const pattern::Panel& p : {stand, fall_of(length_of(stand, {"top"}), s.fall * scale, scale)}) {
    g.pattern.panels.push_back(p);
    g.pattern.panels.back().spacing = 0.010;
  }
  sew_body(g, b.bodice.front.bust_dart > 0);
  sew_collar(g);
  g.folds.push_back({"turned collar", "collar", {"neck"}, -170, 100});
  for (const char* stiff : {"collar stand", "collar", "left cuff", "right cuff", "placket"})
    g.interlinings.push_back({stiff, "interlining"});
  const double quarters = b.bodice.front.bust + b.bodice.back.bust;
  g.girths = {{"bust", w.bust, 2 * quarters}, {"waist", w.waist, 4 * b.waist}, {"hip", w.hip, 4 * b.hip}};
  lay_out(g);
  return g;
}

}  // namespace toile::draft
