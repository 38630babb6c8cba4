#include "core/draft/curtain.h"

#include <string>

#include "core/base/units.h"
#include "core/draft/lathe.h"

namespace toile::draft {
namespace {

constexpr double kRodRadius = 0.014;    // m
constexpr double kHooksBefore = 0.022;  // m, that the hooks hold the tape before the rod's middle
constexpr double kClothBefore = 0.06;   // m, where the flat cloth begins
constexpr double kSeamOpen = 5;         // mm that a heading begins above its curtain
constexpr double kTapeStiffness = 60;   // N: cord, that hardly gives

/// A strip as wide as the curtain, its lower edge's middle at the origin.
pattern::Panel strip_of(const std::string& id, const CurtainStyle& s, double height) {
  const double half = s.covered * s.fullness / 2;
  Outline out({-half, 0});
  out.line("bottom", {half, 0}).line("right", {half, height});
  out.line("top", {-half, height}).line("left", {-half, 0});
  return piece(id, out);
}

pattern::Panel heading_of(const std::string& id, const CurtainStyle& s) {
  pattern::Panel panel = strip_of(id, s, s.heading);
  const double half = s.covered * s.fullness / 2;
  panel.lines.push_back({"tape", {{-half, s.tape}, {half, s.tape}}, false});
  panel.spacing = 0.012;
  return panel;
}

/// A rod with a knob at each end, along x, its middle at `height`. Metres.
geometry::TriangleMesh rod(double length, double height) {
  constexpr double kKnob = 0.026, kNeck = 0.010;
  const double end = length / 2;
  geometry::TriangleMesh mesh = turned_solid({{0, -end - 0.055},
                                              {kKnob * 0.7, -end - 0.048},
                                              {kKnob, -end - 0.030},
                                              {kKnob * 0.7, -end - 0.012},
                                              {kNeck, -end - 0.006},
                                              {kRodRadius, -end},
                                              {kRodRadius, end},
                                              {kNeck, end + 0.006},
                                              {kKnob * 0.7, end + 0.012},
                                              {kKnob, end + 0.030},
                                              {kKnob * 0.7, end + 0.048},
                                              {0, end + 0.055}},
                                             24);
  for (Vec3& p : mesh.vertices) p = {p.y, height - p.x, p.z};
  return mesh;
}

/// Hooks at equal distances on the tape, the outermost at the curtain's sides, and where the rail has them.
DraftedHooks hooks_of(const std::string& id, double middle, const CurtainStyle& s) {
  DraftedHooks hooks{.id = id + " hook", .piece = id};
  for (int i = 0; i < s.hooks; ++i) {
    const double along = static_cast<double>(i) / (s.hooks - 1) - 0.5;
    hooks.points.push_back({along * s.covered * s.fullness, s.tape});
    hooks.places.push_back(
        {metres_from_mm(middle + along * s.covered), metres_from_mm(s.rail_at), kHooksBefore});
  }
  return hooks;
}

void add_curtain(Garment& g, const std::string& side, const CurtainStyle& s) {
  const std::string curtain = side + " curtain", heading = side + " heading";
  const double way = side == "left" ? -1 : 1;
  const double apart = way * (s.covered * s.fullness / 2 + 10);  // flat they must not touch
  const double foot = s.rail_at - s.tape;                        // of the heading
  g.pattern.panels.push_back(strip_of(curtain, s, s.drop - s.tape));
  g.pattern.panels.push_back(heading_of(heading, s));
  const auto at = [&](double y) { return Vec3{metres_from_mm(apart), metres_from_mm(y), kClothBefore}; };
  g.places.push_back({curtain, at(foot - (s.drop - s.tape) - kSeamOpen), {}});
  g.places.push_back({heading, at(foot), {}});
  sew(g, heading, {{heading, "bottom"}}, {{curtain, "top"}});
  g.interlinings.push_back({heading, "interlining"});
  g.elastics.push_back({heading + " tape", heading, {"tape"}, 1 / s.fullness, kTapeStiffness});
  g.hooks.push_back(hooks_of(heading, way * (s.rail - s.covered) / 2, s));
}

}  // namespace

Garment draft_curtain(const CurtainStyle& s) {
  Garment g{.name = "curtain", .title = "Pair of curtains on a rail"};
  g.cloths = {{"linen", "linen", {0.30, 0.36, 0.30}},
              {"velvet", "velvet", {0.22, 0.03, 0.05}},
              {"chiffon", "silk-chiffon", {0.70, 0.68, 0.62}}};
  for (const std::string side : {"left", "right"}) add_curtain(g, side, s);
  g.solids = {{"rail", rod(metres_from_mm(s.rail), metres_from_mm(s.rail_at))}};
  g.particle_distance_mm = 20;
  g.max_time_s = 12;
  lay_out(g);
  return g;
}

}  // namespace toile::draft
