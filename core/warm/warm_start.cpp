#include "core/warm/warm_start.h"

#include <algorithm>
#include <cmath>

#include "core/base/snapped.h"
#include "core/dressing/clearance.h"
#include "core/dressing/untangle.h"
#include "core/dressing/wearer.h"
#include "core/mesh/flat_locator.h"
#include "core/sewing/assembly.h"
#include "core/warm/flat_map.h"

namespace toile::warm {

namespace {

/// Sewn vertices this close are one: their mean moves none farther than contact keeps layers apart, or the
/// start is not clear.
constexpr double kJoined = 1e-3;  // m
/// Ten times what the exact count of crossings rounds to.
constexpr double kLeastGap = 10e-6;  // m
constexpr double kMovedOut = 0.05;   // m, that cloth is moved out of a body at most
constexpr int kUntangling = 60;      // passes

const HungPiece* piece_of(const HungGarment& hung, const std::string& id) {
  const auto found =
      std::find_if(hung.pieces.begin(), hung.pieces.end(), [&](const HungPiece& p) { return p.id == id; });
  return found == hung.pieces.end() ? nullptr : &*found;
}

/// Puts the vertices and triangles of one piece, from these on, where it hung.
void hang_piece(const HungPiece& before, const pattern::Panel& panel, const mesh::PanelMesh& now,
                std::size_t first_vertex, std::size_t first_triangle, WarmStart& start) {
  if (before.rest == now.rest && before.triangles == now.triangles) {
    std::copy(before.positions.begin(), before.positions.end(),
              start.positions.begin() + static_cast<std::ptrdiff_t>(first_vertex));
    std::copy(before.preloads.begin(), before.preloads.end(),
              start.preloads.begin() + static_cast<std::ptrdiff_t>(first_triangle));
    return;
  }
  std::vector<std::string> edges;
  for (const pattern::PanelEdge* edge : pattern::edges_of(panel)) edges.push_back(edge->id);
  const std::vector<Vec2> places = places_before(before, now, edges);
  const mesh::FlatLocator flat(before.rest, before.triangles);
  for (std::size_t v = 0; v < places.size(); ++v) {
    const mesh::FlatPlace place = flat.at(places[v]);
    if (place.triangle == kNone) continue;
    for (std::size_t k = 0; k < 3; ++k)
      start.positions[first_vertex + v] +=
          before.positions[before.triangles[place.triangle][k]] * place.share[k];
  }
  for (std::size_t t = 0; t < now.triangles.size(); ++t) {
    const auto& [a, b, c] = now.triangles[t];
    const mesh::FlatPlace place = flat.at((places[a] + places[b] + places[c]) * (1.0 / 3));
    if (place.triangle != kNone) start.preloads[first_triangle + t] = before.preloads[place.triangle];
  }
}

/// Joins sewn vertices where they lie together.
void join(const sewing::GarmentMesh& garment, WarmStart& start) {
  const std::size_t n = start.positions.size();
  std::vector<Vec3> mean(n);
  std::vector<int> count(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    mean[garment.weld[i]] += start.positions[i];
    ++count[garment.weld[i]];
  }
  std::vector<double> spread(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Index least = garment.weld[i];
    const double off = length(start.positions[i] - mean[least] * (1.0 / count[least]));
    spread[least] = std::max(spread[least], off);
  }
  start.joined.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Index least = garment.weld[i];
    start.joined[i] = spread[least] <= kJoined;
    if (count[least] > 1 && start.joined[i]) start.positions[i] = mean[least] * (1.0 / count[least]);
    if (!start.joined[i]) start.widest = std::max(start.widest, 2 * spread[least]);
  }
}

/// The cloth with joined vertices as one, as contact takes it.
struct Sewn {
  sewing::JoinedVertices joined;
  collision::Surface surface;
  double spacing = 0;  ///< m, mean edge
  std::vector<Vec3> x;
};

Sewn sewn(const sewing::GarmentMesh& garment, const WarmStart& start) {
  Sewn cloth;
  cloth.joined = sewing::joined_vertices(garment, start.joined);
  const std::vector<Index>& of = cloth.joined.vertex_of;
  std::vector<Index> classes(static_cast<std::size_t>(cloth.joined.count));
  cloth.x.resize(classes.size());
  for (std::size_t i = 0; i < of.size(); ++i) {
    classes[of[i]] = of[garment.weld[i]];
    cloth.x[of[i]] = start.positions[i];
  }
  std::vector<Tri> triangles;
  for (const auto& [a, b, c] : garment.triangles) {
    triangles.push_back({of[a], of[b], of[c]});
    cloth.spacing += length(garment.rest[b] - garment.rest[a]);
  }
  cloth.spacing /= static_cast<double>(std::max<std::size_t>(1, triangles.size()));
  cloth.surface = collision::make_surface(triangles, cloth.joined.count, classes);
  return cloth;
}

struct Crossings {
  std::size_t solids = 0, cloth = 0;
};

Crossings crossings_of(const Sewn& cloth, const Surroundings& around) {
  Crossings found;
  for (const collision::CrossingBody& solid : around.solids)
    found.solids += collision::body_crossings(cloth.surface, cloth.x, solid).size();
  found.cloth = collision::self_crossings(cloth.surface, cloth.x).size();
  return found;
}

bool clear(const Sewn& cloth, const Surroundings& around) {
  const Crossings found = crossings_of(cloth, around);
  return found.solids + found.cloth == 0 &&
         dressing::least_gap(cloth.surface, around.obstacles, cloth.x) >= kLeastGap;
}

/// Moves cloth out of the person and out of itself; true when that went well.
bool cleared(Sewn& cloth, const Surroundings& around) {
  if (clear(cloth, around)) return true;
  const Crossings found = crossings_of(cloth, around);
  if (found.solids + found.cloth > 0) {
    if (!around.person) return false;
    const dressing::Wearer wearer(*around.person);
    const dressing::SlimFigure whole = wearer.slim(0);
    if (found.solids > 0)
      for (Vec3& p : cloth.x) p = whole.moved_out(p, kMovedOut);
    dressing::untangle(cloth.surface, whole, wearer.crossing(), cloth.spacing, kUntangling, cloth.x);
  }
  dressing::open_gaps(cloth.surface, around.obstacles, cloth.x);
  return clear(cloth, around);
}

}  // namespace

Result<WarmStart> go_on_from(const HungGarment& hung, const pattern::Pattern& pattern,
                             const mesh::PanelMeshes& meshes, const sewing::GarmentMesh& garment,
                             const Surroundings& around) {
  WarmStart start;
  start.positions.resize(garment.rest.size());
  start.preloads.resize(garment.triangles.size());
  std::size_t triangle = 0;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const HungPiece* before = piece_of(hung, pattern.panels[p].id);
    if (before == nullptr)
      return Error{"warm.piece", "the piece did not hang before", "piece " + pattern.panels[p].id};
    hang_piece(*before, pattern.panels[p], meshes.panels[p],
               static_cast<std::size_t>(garment.first_vertex[p]), triangle, start);
    triangle += meshes.panels[p].triangles.size();
  }
  join(garment, start);
  Sewn cloth = sewn(garment, start);
  if (!cleared(cloth, around))
    return Error{"warm.crosses", "as it hung, the cloth would lie within cloth or a body", ""};
  for (std::size_t i = 0; i < start.positions.size(); ++i)
    start.positions[i] = snapped(cloth.x[cloth.joined.vertex_of[i]]);
  return start;
}

}  // namespace toile::warm
