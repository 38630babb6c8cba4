#include "core/draft/jacket.h"

#include <algorithm>

#include "core/draft/bodice.h"
#include "core/draft/lapel.h"
#include "core/draft/princess.h"
#include "core/draft/two_piece_sleeve.h"
#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

/// Degrees, by which lapels and the collar's fall are pressed over, their wrong sides out. They come to lie
/// on what is below them; pressed farther they pinch the neck's seams before these are shut.
constexpr double kRollAngle = -150;

PrincessBodice body_of(const Wearer& w, const JacketStyle& s) {
  const double scale = w.height / 1680;
  // A jacket lies on the shoulders with its seams and sleeve heads, and comes down less far than it is long.
  Wearer longer = w;
  longer.waist_height -= s.longer * scale;
  const Bodice block = bodice_of(longer, {.bust_ease = s.bust_ease,
                                          .waist_ease = s.waist_ease,
                                          .armhole_ease = 28,
                                          .neck_wider = 12,
                                          .front_neck = 75,
                                          .back_neck = 20,
                                          .shoulder_shift = 6});
  const double quarter = (block.front.bust + block.back.bust) / 2;
  PrincessLevels l{};
  l.hip = std::max(quarter - 10 * scale, (w.hip + s.hip_ease * scale) / 4);
  l.waist = std::min((w.waist + s.waist_ease * scale) / 4, std::max(l.hip, quarter) + 20 * scale);
  l.hips = -w.waist_to_hip();
  l.low = l.hips - s.below_hip * scale;
  l.hem = l.hip + 3 * scale;
  l.back_middle_in = 12 * scale;
  return princess_of(block, l);
}

LapelDraft lapel_draft(const PrincessBodice& b, const pattern::Panel& back, const JacketStyle& s,
                       double scale) {
  LapelDraft d;
  d.neck = b.front.block.neck;
  d.shoulder = b.front.block.shoulder;
  d.break_point = {0, s.break_above_waist * scale};
  d.back_neck = length_of(back, {"neck"});
  d.stand = s.stand * scale;
  d.fall = s.fall * scale;
  d.width = s.lapel * scale;
  d.notch = s.lapel * scale / 2;
  d.gorge_below *= scale;
  d.collar_end *= scale;
  return d;
}

pattern::Panel right_back(const PrincessHalf& half) {
  Outline out(back_middle_hem(half));
  out.line("hem", middle_panel_hem(half));
  add_middle_panel(out, half);
  Outline neck({half.block.bust, half.block.underarm});  // shoulder and neckline are the block's
  add_armhole_and_neck(neck, half.block);
  const pattern::CubicBezier& line = neck.edges()[2].curves.front();
  out.line("shoulder", half.block.neck).curve("neck", line.p1, line.p2, line.p3);
  add_back_middle(out, half);
  return piece("right back", out);
}

pattern::Panel left_front(const PrincessHalf& half, const LapelDraft& lapel, const JacketStyle& s,
                          double scale) {
  const double low = lapel.break_point.y - s.closed * scale;
  const Vec2 hem{26 * scale, half.low};
  Outline out(hem);
  out.line("hem", middle_panel_hem(half));
  add_middle_panel(out, half);
  out.line("shoulder", half.block.neck);
  add_lapel(out, lapel);
  out.line("front", {0, low});
  out.curve("cutaway", {0, low + (half.low - low) * 0.55}, {4 * scale, half.low + 12 * scale}, hem);
  pattern::Panel panel = piece("left front", out);
  panel.lines.push_back(lapel_roll(lapel));
  return panel;
}

void add_sleeves(Garment& g, const Wearer& w, const JacketStyle& s) {
  const double scale = w.height / 1680;
  SleeveDraft d;
  d.front_armhole = length_of(panel_of(g, "left front"), {"armhole"}) +
                    length_of(panel_of(g, "left side front"), {"armhole"});
  d.back_armhole = length_of(panel_of(g, "left back"), {"armhole"}) +
                   length_of(panel_of(g, "left side back"), {"armhole"});
  d.cap_ease = 0.025;
  d.cap_height = 0.31 * (d.front_armhole + d.back_armhole);
  d.length = w.arm_length + 55 * scale;
  d.hem = std::max(s.sleeve_hem * scale, w.wrist * 1.5);
  d.elbow_shift = 9 * scale;
  const TwoPieceSleeve sleeve = left_two_piece_sleeve(d);
  for (const pattern::Panel& p : {sleeve.top, mirrored(sleeve.top, "right top sleeve"), sleeve.under,
                                  mirrored(sleeve.under, "right under sleeve")})
    g.pattern.panels.push_back(p);
}

/// The right side's outlines run the other way round: so do series of their edges.
std::vector<EdgeName> series(bool turned, std::vector<EdgeName> edges) {
  if (turned) std::reverse(edges.begin(), edges.end());
  return edges;
}

void sew_jacket_side(Garment& g, const std::string& side) {
  const bool right = side == "right";
  const std::string front = side + " front", flank = side + " side front", back = side + " back";
  const std::string rear = side + " side back", top = side + " top sleeve", under = side + " under sleeve";
  sew(g, "princess_front_" + side, {{front, "princess"}}, {{flank, "princess"}});
  sew(g, "princess_back_" + side, {{back, "princess"}}, {{rear, "princess"}});
  sew(g, "side_" + side, {{flank, "side"}}, {{rear, "side"}});
  sew(g, "shoulder_" + side, {{front, "shoulder"}}, {{back, "shoulder"}});
  sew(g, "sleeve_front_" + side, {{top, "front_seam"}}, {{under, "front_seam"}});
  sew(g, "sleeve_back_" + side, {{top, "back_seam"}}, {{under, "back_seam"}});
  sew(g, "armhole_front_" + side, series(right, {{flank, "armhole"}, {front, "armhole"}}),
      series(right, {{top, "cap_front"}, {under, "cap_front"}}));
  sew(g, "armhole_back_" + side, series(right, {{back, "armhole"}, {rear, "armhole"}}),
      series(right, {{under, "cap_back"}, {top, "cap_back"}}));
  const std::string of_side = "_" + side;
  for (const std::string edge : {"front_neck", "gorge_inner", "gorge_outer"}) {
    const std::string of_collar = edge + of_side;
    sew(g, of_collar, {{"collar", of_collar}}, {{front, edge}});
  }
}

}  // namespace

Garment draft_jacket(const Wearer& w, const JacketStyle& s) {
  const double scale = w.height / 1680;
  const PrincessBodice b = body_of(w, s);
  Garment g{.name = "jacket", .title = "Tailored jacket"};
  g.cloths = {{"suiting", "wool-suiting", {0.055, 0.075, 0.13}},
              {"flannel", "wool-flannel", {0.20, 0.20, 0.21}},
              {"linen", "linen", {0.52, 0.44, 0.32}}};
  const pattern::Panel back = right_back(b.back);
  const LapelDraft lapel = lapel_draft(b, back, s, scale);
  const pattern::Panel front = left_front(b.front, lapel, s, scale);
  const pattern::Panel flank = side_panel("left side front", b.front);
  const pattern::Panel rear = side_panel("right side back", b.back);
  g.pattern.panels = {front,
                      mirrored(front, "right front"),
                      flank,
                      mirrored(flank, "right side front"),
                      mirrored(back, "left back"),
                      back,
                      mirrored(rear, "left side back"),
                      rear};
  add_sleeves(g, w, s);
  g.pattern.panels.push_back(collar_of("collar", lapel));
  for (const std::string side : {"left", "right"}) sew_jacket_side(g, side);
  sew(g, "front", {{"left front", "front"}}, {{"right front", "front"}});
  sew(g, "back", {{"left back", "middle"}}, {{"right back", "middle"}});
  sew(g, "collar", {{"collar", "neck"}}, {{"right back", "neck"}, {"left back", "neck"}});
  for (const char* fused : {"left front", "right front", "collar"}) {
    g.interlinings.push_back({fused, "interlining"});
    g.folds.push_back({std::string("roll ") + fused, fused, {"roll"}, kRollAngle, 100});
  }
  const double quarters = b.front.block.bust + b.back.block.bust;
  g.girths = {{"bust", w.bust, 2 * quarters},
              {"waist", w.waist, 2 * (b.front.waist + b.back.waist)},
              {"hip", w.hip, 2 * (b.front.hip + b.back.hip)}};
  lay_out(g);
  return g;
}

}  // namespace toile::draft
