#include "core/sewing/attached_places.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace toile::sewing {

Vec3 nearest_on_goal(const std::vector<Vec3>& goal, Vec3 p) {
  Vec3 best = goal.front();
  double least = dot(p - best, p - best);
  for (std::size_t i = 0; goal.size() > 1 && i < goal.size(); ++i) {
    const Vec3 a = goal[i], d = goal[(i + 1) % goal.size()] - a;
    const double squared = dot(d, d);
    if (!(squared > 0)) continue;
    const Vec3 q = a + d * std::clamp(dot(p - a, d) / squared, 0.0, 1.0);
    if (dot(p - q, p - q) < least) {
      least = dot(p - q, p - q);
      best = q;
    }
  }
  return best;
}

namespace {

ClothPoint corner(Index v) { return {{v, v, v}, {1, 0, 0}}; }

/// The attachment's edges one after the other, in vertices of the panel.
std::vector<Index> chain_of(const Attachment& a, const mesh::PanelMesh& mesh) {
  std::vector<Index> chain;
  for (const Index edge : a.edges) {
    const std::vector<Index>& v = mesh.edge_vertices[edge];
    chain.insert(chain.end(), v.begin(), v.end());
  }
  return chain;
}

/// Half way along a chain, by flat length.
ClothPoint middle_of(const std::vector<Index>& chain, const mesh::PanelMesh& mesh, Index first) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const double step = length(mesh.rest[chain[i]] - mesh.rest[chain[i - 1]]);
    along.push_back(along.back() + step);
  }
  const double half = along.back() / 2;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    if (along[i] < half || !(along[i] > along[i - 1])) continue;
    const double t = (half - along[i - 1]) / (along[i] - along[i - 1]);
    return {{chain[i - 1] + first, chain[i] + first, chain[i] + first}, {1 - t, t, 0}};
  }
  return corner(chain.front() + first);
}

/// What of a whole panel lies nearest the mean of its vertices.
ClothPoint middle_of(const mesh::PanelMesh& mesh, Index first) {
  Vec2 mean;
  for (const Vec2 p : mesh.rest) mean = mean + p;
  mean = mean * (1.0 / static_cast<double>(mesh.rest.size()));
  const auto nearest = std::min_element(mesh.rest.begin(), mesh.rest.end(),
                                        [&](Vec2 p, Vec2 q) { return length(p - mean) < length(q - mean); });
  return corner(first + static_cast<Index>(nearest - mesh.rest.begin()));
}

/// Points in the attachment's order.
Result<std::vector<ClothPoint>> points_of(const Attachment& a, const mesh::PanelMesh& mesh, Index first) {
  std::vector<ClothPoint> points;
  for (const Vec2 at : a.points) {
    const auto point = locate_point(mesh, first, at);
    if (!point) {
      return Error{"attachment.off_piece",
                   "a point of the attachment does not lie on its piece; move it there",
                   "attachment " + a.id};
    }
    points.push_back(*point);
  }
  return points;
}

std::vector<Index> held_vertices(const Attachment& a, const std::vector<ClothPoint>& points,
                                 const mesh::PanelMesh& mesh, Index first) {
  std::vector<Index> vertices = chain_of(a, mesh);
  if (a.edges.empty() && a.points.empty()) {
    vertices.resize(mesh.rest.size());
    std::iota(vertices.begin(), vertices.end(), 0);
  }
  for (Index& v : vertices) v += first;
  for (const ClothPoint& p : points) {
    const auto most = std::max_element(p.share.begin(), p.share.end()) - p.share.begin();
    vertices.push_back(p.v[static_cast<std::size_t>(most)]);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<ClothPoint> led_points(const Attachment& a, std::vector<ClothPoint> points,
                                   const mesh::PanelMesh& mesh, Index first) {
  const std::vector<Index> chain = chain_of(a, mesh);
  if (a.goal.size() > 1) {
    for (const Index v : chain) points.push_back(corner(v + first));
  } else if (!chain.empty()) {
    points.push_back(middle_of(chain, mesh, first));
  }
  if (a.edges.empty() && a.points.empty()) points.push_back(middle_of(mesh, first));
  return points;
}

}  // namespace

Status locate_attachments(const std::vector<Attachment>& attachments, const mesh::PanelMeshes& meshes,
                          Assembly& assembly) {
  for (const Attachment& a : attachments) {
    const mesh::PanelMesh& mesh = meshes.panels[a.panel];
    const Index first = assembly.garment.first_vertex[a.panel];
    std::vector<ClothPoint> points = TRY(points_of(a, mesh, first));
    const bool led = a.hold == Attachment::Hold::kGoal;
    assembly.attached.push_back(led ? std::vector<Index>{} : held_vertices(a, points, mesh, first));
    assembly.led.push_back(led ? led_points(a, std::move(points), mesh, first) : std::vector<ClothPoint>{});
  }
  return {};
}

}  // namespace toile::sewing
