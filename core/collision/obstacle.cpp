#include "core/collision/obstacle.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/base/check.h"

namespace toile::collision {

namespace {

std::vector<std::array<Index, 3>> edges_of_faces(const Surface& surface) {
  std::map<std::array<Index, 2>, Index> edge_between;  // the lesser end first
  for (std::size_t e = 0; e < surface.edges.size(); ++e) {
    const auto [i, j] = surface.edges[e];
    edge_between[{std::min(i, j), std::max(i, j)}] = static_cast<Index>(e);
  }
  std::vector<std::array<Index, 3>> edges;
  edges.reserve(surface.triangles.size());
  const auto between = [&](Index i, Index j) { return edge_between.at({std::min(i, j), std::max(i, j)}); };
  for (const auto& [a, b, c] : surface.triangles)
    edges.push_back({between(a, b), between(b, c), between(c, a)});
  return edges;
}

/// A null vector where there is none.
void lay_normals(Obstacle& obstacle) {
  const Surface& surface = obstacle.surface;
  obstacle.vertex_normals.assign(obstacle.vertices.size(), {});
  obstacle.edge_normals.assign(surface.edges.size(), {});
  obstacle.face_normals.clear();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const Vec3 p = obstacle.vertices[a];
    const Vec3 n = normalized(cross(obstacle.vertices[b] - p, obstacle.vertices[c] - p));
    obstacle.face_normals.push_back(n);
    for (const Index v : {a, b, c}) obstacle.vertex_normals[v] += n;
    for (const Index e : obstacle.edges_of_face[t]) obstacle.edge_normals[e] += n;
  }
  for (Vec3& n : obstacle.vertex_normals) n = normalized(n);
  for (Vec3& n : obstacle.edge_normals) n = normalized(n);
}

/// All that follows from where its vertices are.
void lay(Obstacle& obstacle) {
  const Surface& surface = obstacle.surface;
  const std::vector<Vec3>& x = obstacle.vertices;
  obstacle.boxes.vertices.resize(x.size());
  for (const Index v : surface.vertices)
    obstacle.boxes.vertices[v] = geometry::box_around({x[v]}, obstacle.skin_offset);
  obstacle.boxes.lay_around(surface);
  obstacle.edge_lines.clear();
  for (const auto& [a, b] : surface.edges) obstacle.edge_lines.push_back(edge_line(x[a], x[b], 0));
  lay_normals(obstacle);
}

void lay_groups(geometry::BoxGroups& groups, std::span<const geometry::Box3> boxes) {
  if (groups.empty()) {
    groups = geometry::BoxGroups(boxes);
  } else {
    groups.refit(boxes);
  }
}

}  // namespace

void FeatureBoxes::lay_edge(const Surface& surface, Index e) {
  edges[e] = geometry::join(vertices[surface.edges[e][0]], vertices[surface.edges[e][1]]);
}

void FeatureBoxes::lay_face(const Surface& surface, Index t) {
  const auto& [a, b, c] = surface.triangles[t];
  faces[t] = geometry::join(geometry::join(vertices[a], vertices[b]), vertices[c]);
}

void FeatureBoxes::lay_around(const Surface& surface) {
  edges.resize(surface.edges.size());
  faces.resize(surface.triangles.size());
  for (std::size_t e = 0; e < edges.size(); ++e) lay_edge(surface, static_cast<Index>(e));
  for (std::size_t t = 0; t < faces.size(); ++t) lay_face(surface, static_cast<Index>(t));
  lay_groups(vertex_groups, vertices);
  lay_groups(edge_groups, edges);
  lay_groups(face_groups, faces);
}

void FeatureBoxes::lay_around(const Surface& surface, std::span<const Index> new_vertices,
                              std::span<const Index> new_edges, std::span<const Index> new_faces) {
  for (const Index e : new_edges) lay_edge(surface, e);
  for (const Index t : new_faces) lay_face(surface, t);
  vertex_groups.refit(vertices, new_vertices);
  edge_groups.refit(edges, new_edges);
  face_groups.refit(faces, new_faces);
}

Obstacle make_obstacle(std::span<const Vec3> vertices, std::span<const Tri> triangles, double friction,
                       double skin_offset, double restitution) {
  Obstacle obstacle;
  obstacle.vertices.assign(vertices.begin(), vertices.end());
  obstacle.surface = make_surface(triangles, static_cast<Index>(vertices.size()));
  obstacle.edges_of_face = edges_of_faces(obstacle.surface);
  obstacle.friction = friction;
  obstacle.skin_offset = skin_offset;
  obstacle.restitution = restitution;
  lay(obstacle);
  return obstacle;
}

void move_obstacle(Obstacle& obstacle, std::span<const Vec3> vertices) {
  TOILE_CHECK(vertices.size() == obstacle.vertices.size());
  obstacle.vertices.assign(vertices.begin(), vertices.end());
  lay(obstacle);
}

}  // namespace toile::collision
