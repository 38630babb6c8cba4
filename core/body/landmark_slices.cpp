#include "core/body/landmark_slices.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/body/tape.h"

namespace toile {

namespace {

Index first_of(std::vector<Index>& parent, Index i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void grow(BodyCut& cut, Vec3 p) {
  if (cut.points.empty()) cut.low = cut.high = p;
  cut.low = {std::min(cut.low.x, p.x), std::min(cut.low.y, p.y), std::min(cut.low.z, p.z)};
  cut.high = {std::max(cut.high.x, p.x), std::max(cut.high.y, p.y), std::max(cut.high.z, p.z)};
  cut.points.push_back(p);
}

}  // namespace

std::vector<BodyCut> cut_body(const TriangleMesh& mesh, Vec3 origin, Vec3 normal) {
  std::vector<double> side;
  side.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices) side.push_back(dot(p - origin, normal));
  std::vector<Vec3> points;
  std::vector<Index> parent;
  std::map<std::pair<Index, Index>, Index> point_of_edge;
  for (const Tri& t : mesh.triangles) {
    if ((side[t[0]] < 0) == (side[t[1]] < 0) && (side[t[1]] < 0) == (side[t[2]] < 0)) continue;
    Index ends[2] = {kNone, kNone};
    int found = 0;
    for (int c = 0; c < 3 && found < 2; ++c) {
      const Index a = std::min(t[c], t[(c + 1) % 3]), b = std::max(t[c], t[(c + 1) % 3]);
      if ((side[a] < 0) == (side[b] < 0)) continue;
      const auto [it, is_new] = point_of_edge.try_emplace({a, b}, static_cast<Index>(points.size()));
      if (is_new) {
        const double s = side[a] / (side[a] - side[b]);
        points.push_back(mesh.vertices[a] + (mesh.vertices[b] - mesh.vertices[a]) * s);
        parent.push_back(it->second);
      }
      ends[found++] = it->second;
    }
    const Index p = first_of(parent, ends[0]), q = first_of(parent, ends[1]);
    parent[std::max(p, q)] = std::min(p, q);
  }
  std::vector<BodyCut> cuts;
  std::vector<Index> cut_of(points.size(), kNone);
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    const Index r = first_of(parent, i);
    if (cut_of[r] == kNone) cut_of[r] = static_cast<Index>(cuts.size()), cuts.emplace_back();
    grow(cuts[cut_of[r]], points[i]);
  }
  return cuts;
}

double tape_around(const BodyCut& cut, Vec3 normal) {
  const Vec3 n = normalized(normal);
  const Vec3 aside = std::abs(n.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 u = normalized(cross(aside, n)), v = cross(n, u);
  std::vector<Vec2> flat;
  flat.reserve(cut.points.size());
  for (const Vec3& p : cut.points) flat.push_back({dot(p, u), dot(p, v)});
  return hull_perimeter(std::move(flat));
}

BodyCut middle_cut(const TriangleMesh& mesh, double height, double middle) {
  BodyCut out;
  for (const BodyCut& cut : cut_body(mesh, {0, height, 0}, {0, 1, 0})) {
    if (cut.low.x > middle || cut.high.x < middle) continue;
    for (const Vec3& p : cut.points) grow(out, p);
  }
  return out;
}

}  // namespace toile
