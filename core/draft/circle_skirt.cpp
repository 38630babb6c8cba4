#include "core/draft/circle_skirt.h"

#include "core/base/units.h"
#include "core/draft/arc.h"
#include "core/draft/dart.h"

namespace toile::draft {

Garment draft_circle_skirt(const Wearer& w, const CircleSkirtStyle& s) {
  const double scale = w.height / 1680, around = w.waist + s.waist_ease * scale;
  const double radius = around / (2 * kPi), hem = radius + s.length * scale;
  Garment g{.name = "circle-skirt", .title = "Circle skirt"};
  g.cloths = {{"twill", "twill", {0.10, 0.20, 0.16}},
              {"charmeuse", "silk-charmeuse", {0.45, 0.12, 0.20}},
              {"flannel", "wool-flannel", {0.22, 0.21, 0.22}}};
  g.pattern.panels = {ring_sector("front", radius, hem, kPi, "side_left", "side_right"),
                      ring_sector("back", radius, hem, kPi, "side_right", "side_left"),
                      strip("waistband", "waist", around, s.band_height * scale)};
  g.interlinings = {{"waistband", "interlining"}};
  for (const std::string side : {"side_left", "side_right"})
    sew(g, side, {{"front", side}}, {{"back", side}});
  sew(g, "waistband", {{"waistband", "waist"}}, {{"back", "waist"}, {"front", "waist"}});
  sew(g, "waistband_end", {{"waistband", "end_a"}}, {{"waistband", "end_b"}});
  g.girths = {{"waist", w.waist, around}};
  g.max_time_s = 12;
  lay_out(g);
  return g;
}

}  // namespace toile::draft
