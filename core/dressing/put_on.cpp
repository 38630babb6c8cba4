#include "core/dressing/put_on.h"

#include <algorithm>
#include <limits>

namespace toile::dressing {

namespace {

/// Cloth that keeps less of its size than this leaves takes long to unfold: another way may do better.
constexpr double kSqueezed = 0.4;  // as Certificate::shrink_p99

/// Where a flat point lies in a triangle, as weights of its corners; how far outside at worst (0: inside).
struct FlatPlace {
  std::array<double, 3> share{};
  double outside = std::numeric_limits<double>::infinity();
};

FlatPlace place_in(const sewing::GarmentMesh& g, const Tri& t, Vec2 p) {
  const Vec2 a = g.rest[t[0]], b = g.rest[t[1]], c = g.rest[t[2]];
  const double area = cross(b - a, c - a);
  if (!(area > 0)) return {};
  FlatPlace place{{cross(b - p, c - p) / area, cross(c - p, a - p) / area, cross(a - p, b - p) / area}, 0};
  for (const double s : place.share) place.outside = std::max(place.outside, -s);
  return place;
}

}  // namespace

std::vector<Vec3> carried_over(const sewing::GarmentMesh& fine, const sewing::GarmentMesh& coarse,
                               std::span<const Vec3> shape) {
  std::vector<std::vector<Tri>> of_panel(coarse.first_vertex.size());
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t)
    of_panel[coarse.panel_of_triangle[t]].push_back(coarse.triangles[t]);
  std::vector<Vec3> x(fine.rest.size());
  for (std::size_t v = 0; v < x.size(); ++v) {
    FlatPlace best;
    const Tri* in = nullptr;
    for (const Tri& t : of_panel[fine.panel_of_vertex[v]]) {
      const FlatPlace place = place_in(coarse, t, fine.rest[v]);
      if (place.outside >= best.outside) continue;
      best = place;
      in = &t;
      if (best.outside == 0) break;
    }
    for (std::size_t k = 0; in != nullptr && k < 3; ++k) x[v] += shape[(*in)[k]] * best.share[k];
  }
  std::vector<Vec3> sum(x.size());
  std::vector<int> count(x.size(), 0);
  for (std::size_t v = 0; v < x.size(); ++v) {
    sum[fine.weld[v]] += x[v];
    ++count[fine.weld[v]];
  }
  for (std::size_t v = 0; v < x.size(); ++v) x[v] = sum[fine.weld[v]] * (1.0 / count[fine.weld[v]]);
  return x;
}

std::optional<Dressed> put_on(const sewing::Assembly& fine, const sewing::Assembly& coarse,
                              const Wearer& wearer, const RunContext& context, std::size_t first) {
  std::optional<Dressed> best;  // the least squeezed
  for (std::size_t number = first; number < dressing_ways().size(); ++number) {
    if (context.cancelled()) return std::nullopt;
    Dressed dressed = dress(coarse, wearer, dressing_ways()[number], context);
    dressed.number = number;
    if (!dressed.certificate.holds()) continue;
    const double squeezed = dressed.certificate.shrink_p99;
    if (best && squeezed >= best->certificate.shrink_p99) continue;
    if (&fine != &coarse) {
      dressed.positions = carried_over(fine.garment, coarse.garment, dressed.positions);
      finish(fine, wearer, dressed);
    }
    if (!dressed.certificate.holds()) continue;
    best = std::move(dressed);
    best->certificate.shrink_p99 = squeezed;
    if (squeezed < kSqueezed) break;
  }
  return best;
}

}  // namespace toile::dressing
