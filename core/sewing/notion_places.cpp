#include "core/sewing/notion_places.h"

#include <algorithm>
#include <limits>

namespace toile::sewing {

Vec3 position_of(const ClothPoint& point, std::span<const Vec3> x) {
  Vec3 p;
  for (int i = 0; i < 3; ++i) p += x[point.v[i]] * point.share[i];
  return p;
}

namespace {

/// A point this far beside the mesh, in mean edges, lies on its border: a curved outline is cut by chords.
constexpr double kBeside = 0.1;

struct Nearest {
  Index triangle = kNone;
  std::array<double, 3> share{};
  double distance = std::numeric_limits<double>::max();  ///< m
};

/// The nearest point of the segment ab to p, as a share of b.
double along(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  return std::clamp(dot(p - a, d) / std::max(dot(d, d), 1e-30), 0.0, 1.0);
}

/// The point of a triangle that is nearest to p.
Nearest nearest_on(const std::array<Vec2, 3>& c, Vec2 p) {
  const double area = cross(c[1] - c[0], c[2] - c[0]);
  const double s1 = cross(p - c[0], c[2] - c[0]) / area, s2 = cross(c[1] - c[0], p - c[0]) / area;
  if (s1 >= 0 && s2 >= 0 && s1 + s2 <= 1) return {kNone, {1 - s1 - s2, s1, s2}, 0};
  Nearest best;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const double t = along(p, c[k], c[next]);
    const double distance = length(p - (c[k] + (c[next] - c[k]) * t));
    if (distance >= best.distance) continue;
    best = {kNone, {}, distance};
    best.share[k] = 1 - t;
    best.share[next] = t;
  }
  return best;
}

double mean_edge_of(const mesh::PanelMesh& mesh) {
  double sum = 0;
  for (const Tri& t : mesh.triangles) sum += length(mesh.rest[t[1]] - mesh.rest[t[0]]);
  return mesh.triangles.empty() ? 0 : sum / static_cast<double>(mesh.triangles.size());
}

std::vector<Index> shifted(std::vector<Index> vertices, Index first) {
  for (Index& v : vertices) v += first;
  return vertices;
}

}  // namespace

std::optional<ClothPoint> locate_point(const mesh::PanelMesh& mesh, Index first, Vec2 at) {
  Nearest best;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Tri& v = mesh.triangles[t];
    Nearest here = nearest_on({mesh.rest[v[0]], mesh.rest[v[1]], mesh.rest[v[2]]}, at);
    if (here.distance >= best.distance) continue;
    best = here;
    best.triangle = static_cast<Index>(t);
  }
  if (best.triangle == kNone || best.distance > kBeside * mean_edge_of(mesh)) return std::nullopt;
  const Tri& v = mesh.triangles[best.triangle];
  return ClothPoint{{v[0] + first, v[1] + first, v[2] + first}, best.share};
}

Result<NotionPlaces> locate_notions(const Notions& notions, const mesh::PanelMeshes& meshes,
                                    const GarmentMesh& garment) {
  NotionPlaces places;
  for (const Button& button : notions.buttons) {
    std::array<ClothPoint, 2>& points = places.buttons.emplace_back();
    for (const int side : {0, 1}) {
      const PanelPoint& given = side == 0 ? button.a : button.b;
      const auto point =
          locate_point(meshes.panels[given.panel], garment.first_vertex[given.panel], given.at);
      if (!point) {
        return Error{"button.off_piece", "a point of the button does not lie on its piece; move it there",
                     "button " + button.id + ", side " + (side == 0 ? "a" : "b")};
      }
      points[side] = *point;
    }
  }
  for (const Elastic& elastic : notions.elastics) {
    const mesh::PanelMesh& mesh = meshes.panels[elastic.panel];
    const Index first = garment.first_vertex[elastic.panel];
    VertexChains& chains = places.elastics.emplace_back();
    for (const Index e : elastic.edges) chains.push_back(shifted(mesh.edge_vertices[e], first));
    for (const Index l : elastic.lines) chains.push_back(shifted(mesh.line_vertices[l], first));
  }
  for (const Crease& crease : notions.creases) {
    VertexChains& chains = places.creases.emplace_back();
    const Index first = garment.first_vertex[crease.panel];
    for (const Index e : crease.edges)
      chains.push_back(shifted(meshes.panels[crease.panel].edge_vertices[e], first));
    for (const Index l : crease.lines) {
      chains.push_back(shifted(meshes.panels[crease.panel].line_vertices[l], first));
    }
  }
  return places;
}

}  // namespace toile::sewing
