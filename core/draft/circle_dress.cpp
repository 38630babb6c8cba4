#include "core/draft/circle_dress.h"

#include <algorithm>

#include "core/base/units.h"
#include "core/draft/arc.h"
#include "core/draft/bodice.h"
#include "core/draft/dart.h"

namespace toile::draft {
namespace {

constexpr double kTakenInAtSide = 0.28;  // of what bust and waist differ by, taken in at the side

/// The waist's dart, square to the waist below the bust point or the shoulder blade.
Dart waist_dart(const HalfBodice& h, bool back, double scale) {
  Dart dart;
  dart.width = std::max(0.0, h.bust - h.waist) * (1 - kTakenInAtSide);
  dart.at = back ? h.bust * 0.40 : h.bust_point.x * 0.95;
  dart.length = back ? h.underarm - 30 * scale : h.bust_point.y - 20 * scale;
  return dart;
}

/// The side's lower end.
Vec2 side_end(const HalfBodice& h, bool back, double scale) {
  const Dart dart = waist_dart(h, back, scale);
  return {h.waist + (is_sewn(dart) ? dart.width : 0), 0};
}

Outline half_outline(const HalfBodice& h, bool back, double scale) {
  Outline out({0, 0});
  waist_with_dart(out, side_end(h, back, scale), waist_dart(h, back, scale), "middle", "side");
  add_side_with_dart(out, h);
  add_armhole_and_neck(out, h);
  return out;
}

pattern::Panel right_back(const HalfBodice& h, double scale) {
  Outline out = half_outline(h, true, scale);
  out.line("middle", {0, 0});
  return piece("bodice right back", out);
}

void sew_bodice(Garment& g, const Bodice& b, double scale) {
  for (const std::string side : {"left", "right"}) {
    const std::string rear = "bodice " + side + " back", front = "bodice front";
    sew(g, "shoulder_" + side, {{front, "shoulder_" + side}}, {{rear, "shoulder"}});
    if (b.front.bust_dart > 0) {
      sew(g, "bust_dart_" + side, {{front, "dart_low_" + side}}, {{front, "dart_high_" + side}});
      // The series runs in the outline's direction: upwards on the wearer's left, downwards on the right.
      std::vector<EdgeName> edges{{front, "side_low_" + side}, {front, "side_high_" + side}};
      if (side == "right") std::reverse(edges.begin(), edges.end());
      sew(g, "side_" + side, edges, {{rear, "side"}});
    } else {
      sew(g, "side_" + side, {{front, "side_" + side}}, {{rear, "side"}});
    }
    if (is_sewn(waist_dart(b.front, false, scale)))
      sew(g, "dart_front_" + side, {{front, "dart_middle_" + side}}, {{front, "dart_side_" + side}});
    if (is_sewn(waist_dart(b.back, true, scale)))
      sew(g, "dart_back_" + side, {{rear, "dart_middle"}}, {{rear, "dart_side"}});
  }
  sew(g, "zip", {{"bodice left back", "middle"}}, {{"bodice right back", "middle"}});
}

void sew_skirt(Garment& g) {
  const std::string front = "bodice front";
  sew(g, "waist_front", {{"skirt front", "waist"}},
      {{front, "waist_side_right"}, {front, "waist_middle"}, {front, "waist_side_left"}});
  sew(g, "waist_left", {{"skirt left back", "waist"}},
      {{"bodice left back", "waist_side"}, {"bodice left back", "waist_middle"}});
  sew(g, "waist_right", {{"skirt right back", "waist"}},
      {{"bodice right back", "waist_middle"}, {"bodice right back", "waist_side"}});
  for (const std::string side : {"left", "right"})
    sew(g, "skirt_side_" + side, {{"skirt front", "side_" + side}}, {{"skirt " + side + " back", "side"}});
  sew(g, "skirt_middle", {{"skirt left back", "middle"}}, {{"skirt right back", "middle"}});
}

}  // namespace

Garment draft_circle_dress(const Wearer& w, const CircleDressStyle& s) {
  const double scale = w.height / 1680;
  Bodice b = bodice_of(w, {.bust_ease = s.bust_ease,
                           .waist_ease = s.waist_ease,
                           .armhole_ease = 8,
                           .neck_wider = 42,
                           .front_neck = 62,
                           .back_neck = 42,
                           .shoulder_shift = -14});
  match_sides(b, side_end(b.front, false, scale), side_end(b.back, true, scale));
  Garment g{.name = "circle-dress", .title = "Circle dress"};
  g.cloths = {{"poplin", "poplin", {0.42, 0.05, 0.06}},
              {"satin", "satin", {0.10, 0.16, 0.30}},
              {"chiffon", "silk-chiffon", {0.55, 0.40, 0.45}}};
  const pattern::Panel front = unfolded("bodice front", half_outline(b.front, false, scale), "left", "right");
  const pattern::Panel right = right_back(b.back, scale);
  const double front_waist = length_of(front, {"waist_middle", "waist_side_left", "waist_side_right"});
  const double back_waist = length_of(right, {"waist_middle", "waist_side"});
  const double front_radius = front_waist / kPi, back_radius = back_waist / (kPi / 2),
               length = s.length * scale;
  pattern::Panel left_skirt =
      ring_sector("skirt left back", back_radius, back_radius + length, kPi / 2, "middle", "side");
  g.pattern.panels = {
      front,
      mirrored(right, "bodice left back"),
      right,
      ring_sector("skirt front", front_radius, front_radius + length, kPi, "side_left", "side_right"),
      left_skirt,
      mirrored(left_skirt, "skirt right back")};
  sew_bodice(g, b, scale);
  sew_skirt(g);
  g.girths = {{"bust", w.bust, 2 * (b.front.bust + b.back.bust)},
              {"waist", w.waist, front_waist + 2 * back_waist}};
  g.particle_distance_mm = 20;
  g.max_time_s = 20;
  lay_out(g);
  return g;
}

}  // namespace toile::draft
