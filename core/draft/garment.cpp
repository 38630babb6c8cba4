#include "core/draft/garment.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/check.h"
#include "core/base/units.h"
#include "core/pattern/curve.h"

namespace toile::draft {
namespace {

Index index_of(const Garment& garment, const std::string& piece) {
  const std::vector<pattern::Panel>& panels = garment.pattern.panels;
  const auto found =
      std::find_if(panels.begin(), panels.end(), [&](const pattern::Panel& p) { return p.id == piece; });
  TOILE_CHECK(found != panels.end());
  return static_cast<Index>(found - panels.begin());
}

pattern::SeamEdge seam_edge(const Garment& garment, const EdgeName& name) {
  const Index panel = index_of(garment, name.piece);
  const std::vector<pattern::PanelEdge>& edges = garment.pattern.panels[panel].outline.edges;
  const pattern::PanelEdge& edge = edge_of(garment.pattern.panels[panel], name.edge);
  return {panel, static_cast<Index>(&edge - edges.data()), name.reversed};
}

/// A flat vector where a rotation (degrees about x, then y, then z) brings it.
Vec3 rotated(Vec2 flat, Vec3 degrees) {
  const auto turn = [](double& a, double& b, double angle) {
    const double c = std::cos(radians_from_degrees(angle)), s = std::sin(radians_from_degrees(angle));
    const double before = a;
    a = c * before - s * b;
    b = s * before + c * b;
  };
  Vec3 out{flat.x, flat.y, 0};
  turn(out.y, out.z, degrees.x);
  turn(out.z, out.x, degrees.y);
  turn(out.x, out.y, degrees.z);
  return out;
}

}  // namespace

void sew(Garment& garment, const std::string& id, const std::vector<EdgeName>& a,
         const std::vector<EdgeName>& b, bool same_direction) {
  pattern::Seam seam{id, {}, {}, same_direction};
  for (const EdgeName& name : a) seam.a.push_back(seam_edge(garment, name));
  for (const EdgeName& name : b) seam.b.push_back(seam_edge(garment, name));
  garment.pattern.seams.push_back(std::move(seam));
}

pattern::Panel& panel_of(Garment& garment, const std::string& id) {
  return garment.pattern.panels[index_of(garment, id)];
}

double length_of(const pattern::Panel& panel, const std::vector<std::string>& edges) {
  double sum = 0;
  for (const std::string& edge : edges) sum += pattern::arc_length(edge_of(panel, edge));
  return sum;
}

void lay_out(Garment& garment) {
  std::map<std::string, Vec2> moved;
  for (const pattern::Panel& p : garment.pattern.panels)
    moved[p.id] = -p.outline.edges.front().curves.front().p0;
  lay_out(garment.pattern.panels);
  for (const pattern::Panel& p : garment.pattern.panels)
    moved[p.id] = moved[p.id] + p.outline.edges.front().curves.front().p0;
  for (DraftedButton& button : garment.buttons)
    for (PiecePoint* point : {&button.a, &button.b}) point->at = point->at + moved[point->piece];
  for (BentPlace& place : garment.bent) place.anchor.at = place.anchor.at + moved[place.anchor.piece];
  for (DraftedHold& hold : garment.holds)
    for (Vec2& at : hold.points) at = at + moved[hold.piece];
  for (DraftedHooks& hooks : garment.hooks)
    for (Vec2& at : hooks.points) at = at + moved[hooks.piece];
  for (PiecePlace& place : garment.places)
    place.translation = place.translation - rotated(moved[place.piece] * 1e-3, place.rotation);
}

}  // namespace toile::draft
