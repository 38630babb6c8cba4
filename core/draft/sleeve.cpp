#include "core/draft/sleeve.h"

#include <cmath>

#include "core/draft/garment.h"
#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

/// The cap from the back's underarm (x > 0) over the top to the front's, of a half width each.
Outline cap(Outline outline, double back, double front, double height) {
  outline.curve("cap_back", {back * 0.72, height * 0.10}, {back * 0.42, height * 0.98}, {0, height});
  outline.curve("cap_front", {-front * 0.46, height * 1.0}, {-front * 0.66, height * 0.06}, {-front, 0});
  return outline;
}

double cap_length(double back, double front, double height) {
  const Outline drawn = cap(Outline({back, 0}), back, front, height);
  return pattern::arc_length(drawn.edges()[0]) + pattern::arc_length(drawn.edges()[1]);
}

}  // namespace

pattern::Panel left_sleeve(const std::string& id, const SleeveDraft& d) {
  const double wanted = (d.front_armhole + d.back_armhole) * (1 + d.cap_ease);
  // The back is wider by as much as its armhole is longer.
  const double share = d.back_armhole / (d.front_armhole + d.back_armhole);
  double narrow = 0, wide = wanted;
  for (int i = 0; i < 60; ++i) {
    const double width = (narrow + wide) / 2;
    (cap_length(width * share, width * (1 - share), d.cap_height) < wanted ? narrow : wide) = width;
  }
  const double back = wide * share, front = wide * (1 - share), low = d.cap_height - d.length;
  const double left = -d.hem / 2 - d.elbow_shift, right = d.hem / 2 - d.elbow_shift;
  Outline outline({left, low});
  outline.line("hem", {right, low});
  const auto side = [&](const std::string& edge, Vec2 from, Vec2 to) {
    const Vec2 way = to - from;
    outline.curve(edge, from + way * (1.0 / 3) + Vec2{d.elbow_shift / 3, 0},
                  from + way * (2.0 / 3) + Vec2{d.elbow_shift / 3, 0}, to);
  };
  side("underarm_back", {right, low}, {back, 0});
  outline = cap(std::move(outline), back, front, d.cap_height);
  const double back_cap = pattern::arc_length(outline.edges()[2]);
  const double front_cap = pattern::arc_length(outline.edges()[3]);
  outline.notch(0);
  outline.notch(front_cap * 2 / 3);
  side("underarm_front", {-front, 0}, {left, low});
  pattern::Panel panel = piece(id, outline);
  const double third = back_cap / 3;
  for (const double along : {third - 5, third + 5}) {
    const pattern::PanelEdge& edge = edge_of(panel, "cap_back");
    const Vec2 at = pattern::point_at_length(edge, along), next = pattern::point_at_length(edge, along + 1);
    panel.notches.push_back({at, 5, perpendicular(normalized(next - at))});
  }
  return panel;
}

double upper_arm_of(const pattern::Panel& sleeve) {
  return length(edge_of(sleeve, "cap_back").curves.front().p0 -
                edge_of(sleeve, "cap_front").curves.back().p3);
}

}  // namespace toile::draft
