#include "core/draft/tshirt.h"

#include <algorithm>
#include <cmath>

#include "core/draft/dart.h"
#include "core/draft/sleeve.h"
#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

/// Where the block's points lie: half pieces, x from the middle, y from the hem, mm.
struct Block {
  double quarter_bust, quarter_waist, quarter_hip;
  double underarm, waist, top;  ///< heights; top: where shoulder meets neck
  double neck_half, front_neck, back_neck;
  double shoulder_half, shoulder_drop;
};

Block block_of(const Wearer& w, const TshirtStyle& s) {
  Block b{};
  const double scale = w.height / 1680, bust = w.bust * (1 + s.bust_ease);
  const double waist = std::max(bust - s.waist_in * scale, w.waist + s.least_waist_ease * scale);
  b.quarter_bust = bust / 4;
  b.quarter_hip = std::max(bust, w.hip + s.least_hip_ease * scale) / 4;
  b.quarter_waist = std::min(waist / 4, std::max(b.quarter_bust, b.quarter_hip));
  // The tape finds the neck where it is slimmest; a T-shirt lies around its foot, some four centimetres out.
  b.neck_half = w.neck / 5 + 20 * scale;
  b.back_neck = 24 * scale;
  b.front_neck = w.neck / 5 + 22 * scale;
  b.top = w.nape_height - w.hip_height + s.below_hip * scale + b.back_neck;
  b.waist = b.top - b.back_neck - w.nape_to_waist();
  b.underarm = b.top - b.back_neck - (w.nape_height - w.armpit_height) - 25 * scale;
  b.shoulder_half = w.shoulder_width / 2 + 8 * scale;
  b.shoulder_drop = 0.41 * (b.shoulder_half - b.neck_half);
  return b;
}

pattern::Panel body_piece(const Block& b, bool back) {
  const double neck_depth = back ? b.back_neck : b.front_neck, hollow = back ? 12 : 22;
  const double shoulder = b.top - b.shoulder_drop, deep = shoulder - b.underarm;
  Outline half({0, 0});
  half.line("hem", {b.quarter_hip, 0});
  half.curve("side", {b.quarter_hip, b.waist * 0.4}, {b.quarter_waist, b.waist * 0.7},
             {b.quarter_waist, b.waist});
  const double rest = b.underarm - b.waist;
  half.curve({b.quarter_waist, b.waist + rest * 0.4},
             {b.quarter_bust - (b.quarter_bust - b.quarter_waist) * 0.2, b.underarm - rest * 0.3},
             {b.quarter_bust, b.underarm});
  half.notch(-rest);
  const double reach = b.quarter_bust - b.shoulder_half + hollow;
  half.curve("armhole", {b.quarter_bust - reach * 0.75, b.underarm + deep * 0.02},
             {b.shoulder_half - hollow, b.underarm + deep * 0.42}, {b.shoulder_half, shoulder});
  half.notch(deep * 0.55);
  half.line("shoulder", {b.neck_half, b.top});
  half.curve("neck", {b.neck_half * 0.97, b.top - neck_depth * 0.62},
             {b.neck_half * 0.55, b.top - neck_depth}, {0, b.top - neck_depth});
  return unfolded(back ? "back" : "front", half, back ? "right" : "left", back ? "left" : "right");
}

void sew_together(Garment& g) {
  for (const std::string side : {"left", "right"}) {
    const std::string sleeve = side + " sleeve";
    sew(g, "shoulder_" + side, {{"front", "shoulder_" + side}}, {{"back", "shoulder_" + side}});
    sew(g, "side_" + side, {{"front", "side_" + side}}, {{"back", "side_" + side}});
    sew(g, "armhole_front_" + side, {{"front", "armhole_" + side}}, {{sleeve, "cap_front"}});
    sew(g, "armhole_back_" + side, {{"back", "armhole_" + side}}, {{sleeve, "cap_back"}});
    sew(g, "underarm_" + side, {{sleeve, "underarm_front"}}, {{sleeve, "underarm_back"}});
  }
}

}  // namespace

Garment draft_tshirt(const Wearer& w, const TshirtStyle& s) {
  const Block b = block_of(w, s);
  const double scale = w.height / 1680;
  Garment g{.name = "tshirt", .title = "T-shirt"};
  g.cloths = {{"jersey", "single-jersey", {0.05, 0.16, 0.24}},
              {"interlock", "interlock", {0.62, 0.60, 0.55}},
              {"rib", "rib", {0.04, 0.13, 0.20}}};
  std::vector<pattern::Panel>& panels = g.pattern.panels;
  panels = {body_piece(b, false), body_piece(b, true)};
  SleeveDraft sleeve;
  sleeve.front_armhole = length_of(panels[0], {"armhole_left"});
  sleeve.back_armhole = length_of(panels[1], {"armhole_left"});
  sleeve.cap_height = 0.5 * (sleeve.front_armhole + sleeve.back_armhole) / 2;
  sleeve.length = sleeve.cap_height + 0.20 * w.arm_length;
  pattern::Panel left = left_sleeve("left sleeve", sleeve);
  sleeve.hem = std::max(upper_arm_of(left) - 36 * scale, w.upper_arm * 1.12);
  left = left_sleeve("left sleeve", sleeve);
  panels.push_back(left);
  panels.push_back(mirrored(left, "right sleeve"));
  const double neckline = length_of(panels[0], {"neck"}) + length_of(panels[1], {"neck"});
  panels.push_back(strip("neckband", "neck", neckline * s.band_share, s.band * scale));
  panels.back().fabric = "rib";
  sew_together(g);
  sew(g, "neckband_end", {{"neckband", "end_a"}}, {{"neckband", "end_b"}});
  sew(g, "neckband", {{"neckband", "neck"}}, {{"front", "neck"}, {"back", "neck"}});
  g.girths = {{"bust", w.bust, 4 * b.quarter_bust},
              {"waist", w.waist, 4 * b.quarter_waist},
              {"hip", w.hip, 4 * b.quarter_hip}};
  lay_out(g);
  return g;
}

}  // namespace toile::draft
