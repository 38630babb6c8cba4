#include "core/dressing/certificate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/dressing/clearance.h"
#include "core/sewing/rings.h"

namespace toile::dressing {

namespace {

/// Rings under this girth are slits, darts' ends and holes, around which nothing need go.
constexpr double kLeastRing = 0.15;    // m
constexpr double kMostStretch = 0.35;  // p99 that the drape takes back at once
constexpr double kMostStrain = 1;      // p99 that it takes back in time, where nothing is caught
constexpr double kNearBody = 0.06;     // m
constexpr double kMostlyOut = 0.6;
constexpr double kOffGround = 2e-3;  // m
/// Cloth around the end of a slit: a whole turn, less what points of pieces leave out. Hems, cuffs, necklines
/// and armholes have no such point.
constexpr double kAroundEnd = 1.6 * std::numbers::pi;

double flat_length(const sewing::GarmentMesh& g, const std::vector<Index>& ring) {
  // Border edges by their classes: a ring's edge has one triangle.
  double sum = 0;
  std::vector<std::array<Index, 2>> wanted;
  wanted.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index a = ring[i], b = ring[(i + 1) % ring.size()];
    wanted.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(wanted.begin(), wanted.end());
  std::vector<bool> found(wanted.size(), false);
  for (const Tri& t : g.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index i = t[k], j = t[(k + 1) % 3];
      const std::array<Index, 2> key{std::min(g.weld[i], g.weld[j]), std::max(g.weld[i], g.weld[j])};
      const auto at = std::lower_bound(wanted.begin(), wanted.end(), key);
      if (at == wanted.end() || *at != key || found[static_cast<std::size_t>(at - wanted.begin())]) continue;
      found[static_cast<std::size_t>(at - wanted.begin())] = true;
      sum += length(g.rest[i] - g.rest[j]);
    }
  }
  return sum;
}

/// Radians of cloth around each class of vertices.
std::vector<double> cloth_angles(const sewing::GarmentMesh& g) {
  std::vector<double> angles(g.weld.size(), 0);
  for (const Tri& t : g.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 a = g.rest[t[(k + 1) % 3]] - g.rest[t[k]], b = g.rest[t[(k + 2) % 3]] - g.rest[t[k]];
      angles[g.weld[t[k]]] += std::abs(std::atan2(cross(a, b), dot(a, b)));
    }
  }
  return angles;
}

}  // namespace

int Certificate::wrong_rings() const {
  return static_cast<int>(
      std::count_if(rings.begin(), rings.end(), [](const WornRing& r) { return !r.right; }));
}

bool Certificate::holds_strained() const {
  return crossings.none() && wrong_rings() == 0 && stretch_p99 < kMostStrain && faces_out > kMostlyOut &&
         lowest > kOffGround && gap >= kLeastGap;
}

bool Certificate::holds() const { return holds_strained() && stretch_p99 < kMostStretch; }

std::vector<WornRing> worn_rings(const sewing::GarmentMesh& garment, std::span<const Vec3> x,
                                 const Skeleton& skeleton) {
  std::vector<WornRing> rings;
  const std::vector<double> angles = cloth_angles(garment);
  for (std::vector<Index>& vertices : sewing::rings_of(garment)) {
    WornRing ring{std::move(vertices), 0, {}, false, true};
    ring.girth = flat_length(garment, ring.vertices);
    if (ring.girth < kLeastRing) continue;
    std::vector<Vec3> line;
    line.reserve(ring.vertices.size());
    for (const Index v : ring.vertices) line.push_back(x[v]);
    const std::optional<Enclosure> around = enclosed_by(line, skeleton);
    if (around) ring.around = *around;
    ring.slit = around && around->nothing() &&
                std::any_of(ring.vertices.begin(), ring.vertices.end(),
                            [&](Index v) { return angles[v] > kAroundEnd; });
    ring.right = ring.slit || (around && !around->nothing() && around->simple());
    rings.push_back(std::move(ring));
  }
  return rings;
}

Certificate certify(const sewing::GarmentMesh& garment, std::span<const Vec3> x, const SlimFigure& body,
                    const collision::CrossingBody& crossing, std::span<const collision::Obstacle> obstacles,
                    const Skeleton& skeleton) {
  Certificate c;
  const collision::Surface surface =
      collision::make_surface(garment.triangles, garment.vertex_count(), garment.weld);
  c.crossings = {static_cast<int>(collision::body_crossings(surface, x, crossing).size()),
                 static_cast<int>(collision::self_crossings(surface, x).size())};
  c.gap = least_gap(surface, obstacles, x);
  c.rings = worn_rings(garment, x, skeleton);
  std::vector<double> stretches;
  stretches.reserve(3 * garment.triangles.size());
  double out = 0, near = 0;
  for (const Tri& t : garment.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index i = t[k], j = t[(k + 1) % 3];
      stretches.push_back(length(x[i] - x[j]) / std::max(1e-9, length(garment.rest[i] - garment.rest[j])) -
                          1);
    }
    const Vec3 middle = (x[t[0]] + x[t[1]] + x[t[2]]) * (1.0 / 3);
    if (body.field->distance(middle) > kNearBody) continue;
    const Vec3 normal = cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
    near += length(normal);
    if (dot(normal, body.field->outwards(middle, 0)) > 0) out += length(normal);
  }
  for (const Vec3& p : x) c.lowest = std::min(c.lowest, p.y - body.floor);
  if (near > 0) c.faces_out = out / near;
  if (!stretches.empty()) {
    std::sort(stretches.begin(), stretches.end());
    c.stretch_p99 = stretches[stretches.size() * 99 / 100];
    c.stretch_max = stretches.back();
    c.shrink_p99 = -stretches[stretches.size() / 100];
  }
  return c;
}

}  // namespace toile::dressing
