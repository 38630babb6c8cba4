#include "core/paper/particles.h"

#include <algorithm>

#include "core/material/coefficients.h"
#include "core/material/ellipse.h"
#include "core/mesh/topology.h"
#include "core/paper/bend.h"

namespace toile::paper {

namespace {

constexpr double kQuarterTurn = 1.57079632679489661923;

/// How the links of a garment lie on their cloth.
class Weave {
 public:
  Weave(const sewing::GarmentMesh& garment, std::span<const Vec2> warps,
        std::span<const material::Fabric> fabrics, std::span<const Index> fabric_of_panel, double load)
      : garment_(garment), warps_(warps), fabrics_(fabrics), fabric_of_panel_(fabric_of_panel), load_(load) {}

  const material::Fabric& fabric_at(Index v) const {
    return fabrics_[fabric_of_panel_[garment_.panel_of_vertex[v]]];
  }
  /// Radians from the warp, 0 to π.
  double angle(Index a, Index b) const {
    const Vec2 d = normalized(garment_.rest[b] - garment_.rest[a]);
    return arc_cosine(dot(d, warps_[garment_.panel_of_vertex[a]]));
  }
  double stiffness(Index a, Index b) const { return bending_across(fabric_at(a), angle(a, b)); }
  double elasticity(Index a, Index b) const { return elasticity_along(fabric_at(a), angle(a, b), load_); }

 private:
  const sewing::GarmentMesh& garment_;
  std::span<const Vec2> warps_;
  std::span<const material::Fabric> fabrics_;
  std::span<const Index> fabric_of_panel_;
  double load_;
};

std::vector<double> weights_of(const sewing::GarmentMesh& garment, const Weave& weave) {
  std::vector<double> mass(garment.rest.size(), 0);
  for (const Tri& t : garment.triangles) {
    const Vec2 a = garment.rest[t[0]];
    const double area = 0.5 * std::abs(cross(garment.rest[t[1]] - a, garment.rest[t[2]] - a));
    for (const Index v : t) mass[v] += area / 3 * weave.fabric_at(v).areal_mass;
  }
  for (double& m : mass) m = m > 0 ? 1 / m : 0;
  return mass;
}

/// Links of far-off parts of the list by turns: neighbours in it share a particle, and the processor would
/// wait for the one before it could begin with the next.
std::vector<Link> by_turns(const std::vector<Link>& links) {
  constexpr std::size_t kParts = 8;
  const std::size_t each = (links.size() + kParts - 1) / kParts;
  std::vector<Link> mixed;
  for (std::size_t k = 0; k < each; ++k) {
    for (std::size_t at = k; at < links.size(); at += each) mixed.push_back(links[at]);
  }
  return mixed;
}

std::vector<Link> links_of(const sewing::GarmentMesh& garment, const Weave& weave) {
  std::vector<Link> links;
  for (const mesh::MeshEdge& e : mesh::edges_of(garment.triangles, garment.vertex_count())) {
    const double rest = length(garment.rest[e.v1] - garment.rest[e.v0]);
    links.push_back({e.v0, e.v1, rest, weave.elasticity(e.v0, e.v1)});
  }
  return by_turns(links);
}

double flat_angle(const sewing::GarmentMesh& garment, Index apex, Index a, Index b) {
  const auto lifted = [&](Index v) { return Vec3{garment.rest[v].x, garment.rest[v].y, 0}; };
  return angle_between(lifted(apex), lifted(a), lifted(b));
}

Fans fans_of(const sewing::GarmentMesh& garment, const Weave& weave) {
  Fans fans;
  std::vector<Index> count(garment.rest.size(), 0);
  for (const Tri& t : garment.triangles)
    for (const Index v : t) ++count[garment.weld[v]];

  std::vector<Index> fan_of_least(garment.rest.size(), kNone);
  fans.first.push_back(0);
  for (std::size_t v = 0; v < count.size(); ++v) {
    if (garment.weld[v] != static_cast<Index>(v)) continue;
    fan_of_least[v] = static_cast<Index>(fans.first.size()) - 1;
    fans.first.push_back(fans.first.back() + count[v]);
  }
  for (const Index least : garment.weld) fans.of.push_back(fan_of_least[least]);

  fans.angles.resize(3 * garment.triangles.size());
  fans.flat.assign(fans.first.size() - 1, 0);
  std::vector<Index> next(fans.first.begin(), fans.first.end() - 1);
  for (const Tri& t : garment.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index apex = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3], fan = fans.of[apex];
      const double flat = flat_angle(garment, apex, a, b);
      const double stiffness = (weave.stiffness(apex, a) + weave.stiffness(apex, b)) / 2;
      fans.angles[next[fan]++] = {apex, a, b, flat, stiffness};
      fans.flat[fan] += flat;
    }
  }
  return fans;
}

std::vector<std::vector<Index>> sewn_of(const sewing::GarmentMesh& garment) {
  std::vector<std::vector<Index>> members(garment.rest.size());
  for (Index v = 0; v < garment.vertex_count(); ++v) members[garment.weld[v]].push_back(v);
  std::erase_if(members, [](const std::vector<Index>& m) { return m.size() < 2; });
  return members;
}

}  // namespace

double bending_across(const material::Fabric& fabric, double angle) {
  const double warp = material::bending_coefficient(fabric.bend_warp, fabric.areal_mass);
  const double weft = material::bending_coefficient(fabric.bend_weft, fabric.areal_mass);
  return material::elliptical(warp, weft, angle + kQuarterTurn);
}

double elasticity_along(const material::Fabric& fabric, double angle, double load) {
  const auto under_load = [load](double stretch, double limit) {
    return std::min(load / stretch, material::elasticity_of(stretch, limit));
  };
  return material::elliptical(under_load(fabric.stretch_warp, fabric.limit_warp),
                              under_load(fabric.stretch_weft, fabric.limit_weft), angle);
}

Particles make_particles(const sewing::GarmentMesh& garment, std::span<const Vec2> warps,
                         std::span<const material::Fabric> fabrics, std::span<const Index> fabric_of_panel,
                         double load) {
  const Weave weave(garment, warps, fabrics, fabric_of_panel, load);
  return {garment.triangles,        weights_of(garment, weave), garment.weld,
          links_of(garment, weave), fans_of(garment, weave),    sewn_of(garment)};
}

}  // namespace toile::paper
