#include "core/draft/house.h"

#include <string>

#include "core/base/units.h"
#include "core/draft/arc.h"
#include "core/draft/lathe.h"
#include "core/draft/outline.h"

namespace toile::draft {
namespace {

pattern::Panel trapezoid(const std::string& id, double top, double bottom, double height) {
  Outline out({-bottom / 2, 0});
  out.line("bottom", {bottom / 2, 0}).line("right", {top / 2, height});
  out.line("top", {-top / 2, height}).line("left", {-bottom / 2, 0});
  return piece(id, out);
}

/// Two tables' legs would hide nothing more: a top on a column on a foot. Metres.
geometry::TriangleMesh table(double radius, double height) {
  constexpr double kThick = 0.028, kRound = 0.006, kColumn = 0.045, kFoot = 0.24;
  const double low = height - kThick;
  return turned_solid({{0, 0},
                       {kFoot, 0},
                       {kFoot, 0.02},
                       {kColumn * 1.5, 0.05},
                       {kColumn, 0.12},
                       {kColumn, low - 0.06},
                       {kColumn * 1.6, low},
                       {radius * 0.5, low},
                       {radius - kRound, low},
                       {radius, low + kRound},
                       {radius, height - kRound},
                       {radius - kRound * 0.3, height - kRound * 0.3},
                       {radius - kRound, height},
                       {radius * 0.66, height},
                       {radius * 0.33, height},
                       {0, height}},
                      96);
}

}  // namespace

Garment draft_trapezoids() {
  constexpr double kTop = 360, kBottom = 720, kHeight = 620;  // mm
  constexpr double kApart = 0.74, kRows = 0.85, kUp = 1.5;    // m
  constexpr double kRadius = 0.17;  // m: the corners then hang 30 cm apart, and cloth falls between them
  Garment g{.name = "trapezoids", .title = "Six fabrics, hung by two corners"};
  g.cloths = {
      {"chiffon", "silk-chiffon", {0.55, 0.36, 0.40}}, {"poplin", "poplin", {0.50, 0.52, 0.60}},
      {"jersey", "single-jersey", {0.10, 0.22, 0.28}}, {"flannel", "wool-flannel", {0.20, 0.21, 0.22}},
      {"denim", "denim-14oz", {0.03, 0.06, 0.15}},     {"felt", "felt", {0.45, 0.10, 0.05}}};
  int count = 0;
  for (const Cloth& cloth : g.cloths) {
    pattern::Panel panel = trapezoid(cloth.id, kTop, kBottom, kHeight);
    panel.fabric = cloth.id;
    g.pattern.panels.push_back(panel);
    const int row = count / 3;
    const Vec3 at{(count % 3 - 1) * kApart, kUp - row * kRows, 0};
    g.bent.push_back({{cloth.id, {0, kHeight}}, at, kRadius});
    g.holds.push_back({cloth.id + " corners", cloth.id, {{-kTop / 2, kHeight}, {kTop / 2, kHeight}}});
    ++count;
  }
  g.particle_distance_mm = 18;
  lay_out(g);
  return g;
}

Garment draft_tablecloth() {
  constexpr double kRadius = 450, kOverhang = 300, kTableHeight = 0.74;  // mm, mm, m
  Garment g{.name = "tablecloth", .title = "Round tablecloth"};
  g.cloths = {{"linen", "linen", {0.62, 0.58, 0.50}},
              {"poplin", "poplin", {0.60, 0.63, 0.68}},
              {"velvet", "velvet", {0.20, 0.02, 0.05}}};
  Outline out({kRadius + kOverhang, 0});
  add_arc(out, "hem_a", {}, kRadius + kOverhang, 0, kPi);
  add_arc(out, "hem_b", {}, kRadius + kOverhang, kPi, 2 * kPi);
  g.pattern.panels = {piece("cloth", out)};
  g.places = {{"cloth", {0, kTableHeight + 0.004, 0}, kLying}};
  g.solids = {{"table", table(metres_from_mm(kRadius), kTableHeight)}};
  lay_out(g);
  return g;
}

Garment draft_cushion() {
  constexpr double kSide = 420, kApart = 0.05, kOffFloor = 0.02;  // mm, m, m
  Garment g{.name = "cushion", .title = "Cushion"};
  g.cloths = {{"canvas", "canvas", {0.45, 0.28, 0.08}},
              {"velvet", "velvet", {0.05, 0.10, 0.16}},
              {"linen", "linen", {0.55, 0.50, 0.42}}};
  g.pattern.panels = {rectangle("top", kSide, kSide), rectangle("bottom", kSide, kSide)};
  // The lower one lies on its right side: what is up on the flat piece comes near.
  g.places = {{"top", {0, kOffFloor + kApart, metres_from_mm(kSide) / 2}, kLying},
              {"bottom", {0, kOffFloor, -metres_from_mm(kSide) / 2}, {90, 0, 0}}};
  sew(g, "near", {{"top", "bottom"}}, {{"bottom", "top"}});
  sew(g, "far", {{"top", "top"}}, {{"bottom", "bottom"}});
  sew(g, "right", {{"top", "right"}}, {{"bottom", "right"}});
  sew(g, "left", {{"top", "left"}}, {{"bottom", "left"}});
  g.solids = {{"bench", box_solid({-0.4, -0.1, -0.4}, {0.4, 0, 0.4}, 0.1)}};
  g.cushions = {{"filling", {"top", "bottom"}, 120}};
  lay_out(g);
  return g;
}

}  // namespace toile::draft
