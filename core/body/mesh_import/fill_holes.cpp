#include "core/body/mesh_import/fill_holes.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/base/aabb.h"

namespace toile::mesh_import {
namespace {

constexpr std::size_t kLongestRing = 100;  // of a hole that is filled without a vertex in its middle
constexpr double kLeastHole = 1e-12;       // m², area of a hole under which it is a crack
constexpr double kNever = std::numeric_limits<double>::infinity();

using Ring = std::vector<Index>;  ///< vertices, as the filling triangles must run

struct Border {
  Ring ring;
  Index shell = 0;
};

/// The border half-edge at the other end of the fan that begins with border half-edge `h`; kNone when the
/// fan's triangles do not run alike.
Index end_of_fan(const geometry::TriangleMesh& mesh, const HalfEdges& edges, Index h) {
  const Index vertex = start_of(mesh, h);
  for (std::size_t steps = 0; steps < edges.mate.size(); ++steps) {
    const Index last = next_in_triangle(next_in_triangle(h));
    if (edges.mate[last] == kNone) return last;
    h = edges.mate[last];
    if (start_of(mesh, h) != vertex) break;
  }
  return kNone;
}

/// Where several fans meet in a vertex, a hole lies between the end of one and the beginning of another:
/// those that look the same way most, best first.
void match_across(const geometry::TriangleMesh& mesh, const HalfEdges& edges, const std::vector<Index>& out,
                  const std::vector<Index>& in, std::vector<Index>& before) {
  struct Match {
    double cosine;
    Index h, g;
  };
  const Vec3 at = mesh.vertices[start_of(mesh, out.front())];
  std::vector<Match> matches;
  for (const Index h : out) {
    const Index own = end_of_fan(mesh, edges, h);
    for (const Index g : in) {
      if (g == own) continue;
      const Vec3 a = normalized(mesh.vertices[end_of(mesh, h)] - at);
      matches.push_back({dot(a, normalized(mesh.vertices[start_of(mesh, g)] - at)), h, g});
    }
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.cosine > b.cosine; });
  std::vector<Index> used;
  for (const Match& m : matches) {
    if (before[m.h] != kNone || std::find(used.begin(), used.end(), m.g) != used.end()) continue;
    before[m.h] = m.g;
    used.push_back(m.g);
  }
}

/// Of each border half-edge the one that comes before it along the border; kNone where that is not clear.
std::vector<Index> border_before(const geometry::TriangleMesh& mesh, const HalfEdges& edges) {
  constexpr std::size_t kMostFans = 64;
  std::map<Index, std::pair<std::vector<Index>, std::vector<Index>>> at;  // vertex → beginning, ending there
  for (Index h = 0; h < static_cast<Index>(edges.mate.size()); ++h) {
    if (edges.mate[h] != kNone) continue;
    at[start_of(mesh, h)].first.push_back(h);
    at[end_of(mesh, h)].second.push_back(h);
  }
  std::vector<Index> before(edges.mate.size(), kNone);
  for (const auto& [vertex, ends] : at) {
    const auto& [out, in] = ends;
    if (out.size() == 1 && in.size() == 1) before[out.front()] = in.front();
    if (out.size() > 1 && out.size() == in.size() && out.size() <= kMostFans) {
      match_across(mesh, edges, out, in, before);
    }
  }
  return before;
}

/// The borders of all shells, each against its half-edges' own way.
std::vector<Border> borders_of(const geometry::TriangleMesh& mesh, const HalfEdges& edges,
                               const MeshShells& shells) {
  const std::vector<Index> before = border_before(mesh, edges);
  std::vector<Border> borders;
  std::vector<bool> seen(edges.mate.size(), false);
  for (Index h = 0; h < static_cast<Index>(edges.mate.size()); ++h) {
    if (edges.mate[h] != kNone || seen[h]) continue;
    Border border{{}, shells.shell_of[triangle_of(h)]};
    bool closed = false;
    for (Index at = h; at != kNone && !seen[at]; at = before[at]) {
      seen[at] = true;
      border.ring.push_back(end_of(mesh, at));
      closed = before[at] == h;
    }
    std::vector<Index> once = border.ring;
    std::sort(once.begin(), once.end());
    const bool simple = std::adjacent_find(once.begin(), once.end()) == once.end();
    if (!closed || !simple) border.ring.clear();  // no hole that could be filled
    borders.push_back(std::move(border));
  }
  return borders;
}

std::vector<double> diagonals_of(const geometry::TriangleMesh& mesh, const MeshShells& shells) {
  std::vector<Aabb3> boxes(shells.count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Index v : mesh.triangles[t]) boxes[shells.shell_of[t]].add(mesh.vertices[v]);
  }
  std::vector<double> out;
  out.reserve(boxes.size());
  for (const Aabb3& box : boxes) out.push_back(length(box.size()));
  return out;
}

double length_of(const geometry::TriangleMesh& mesh, const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum += length(mesh.vertices[ring[(i + 1) % ring.size()]] - mesh.vertices[ring[i]]);
  }
  return sum;
}

double area_of(const geometry::TriangleMesh& mesh, Index a, Index b, Index c) {
  const Vec3 p = mesh.vertices[a];
  return 0.5 * length(cross(mesh.vertices[b] - p, mesh.vertices[c] - p));
}

using EdgeSet = std::set<std::pair<Index, Index>>;

/// The triangulation of least area of a ring; nothing when each would need an edge that the mesh has already,
/// or an empty triangle.
class LeastFilling {
 public:
  LeastFilling(const geometry::TriangleMesh& mesh, const Ring& ring, const EdgeSet& taken)
      : mesh_(mesh), ring_(ring), taken_(taken), n_(ring.size()) {
    area_.assign(n_ * n_, 0);
    middle_.assign(n_ * n_, 0);
    // Shorter runs first: each is put together of two that are known (G. Barequet and M. Sharir, "Filling
    // gaps in the boundary of a polyhedron", Computer Aided Geometric Design 12, 1995). O(n³) for n corners.
    for (std::size_t span = 2; span < n_; ++span) {
      for (std::size_t i = 0; i + span < n_; ++i) choose(i, i + span);
    }
  }
  std::vector<Tri> triangles() const {
    std::vector<Tri> out;
    if (area_[n_ - 1] < kNever) add(0, n_ - 1, out);
    return out;
  }

 private:
  bool may_cut(std::size_t i, std::size_t j) const {
    // An edge that the mesh has already would get a third triangle.
    if (i + 1 == j || (i == 0 && j + 1 == n_)) return true;
    return !taken_.contains(std::minmax(ring_[i], ring_[j]));
  }
  void choose(std::size_t i, std::size_t j) {
    double best = kNever;
    for (std::size_t k = i + 1; k < j && may_cut(i, j); ++k) {
      const double own = area_of(mesh_, ring_[i], ring_[k], ring_[j]);
      const double area = area_[i * n_ + k] + area_[k * n_ + j] + own;
      if (own > kLeastHole && area < best) {
        best = area;
        middle_[i * n_ + j] = k;
      }
    }
    area_[i * n_ + j] = best;
  }
  void add(std::size_t i, std::size_t j, std::vector<Tri>& out) const {
    if (i + 1 >= j) return;
    const std::size_t k = middle_[i * n_ + j];
    out.push_back({ring_[i], ring_[k], ring_[j]});
    add(i, k, out);
    add(k, j, out);
  }

  const geometry::TriangleMesh& mesh_;
  const Ring& ring_;
  const EdgeSet& taken_;
  std::size_t n_;
  std::vector<double> area_;
  std::vector<std::size_t> middle_;
};

/// Triangles from every side of the ring to a new vertex in its middle; nothing when one would be empty.
std::vector<Tri> fan_filling(geometry::TriangleMesh& mesh, const Ring& ring) {
  Vec3 sum;
  for (const Index v : ring) sum += mesh.vertices[v];
  const auto middle = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.push_back(sum * (1.0 / static_cast<double>(ring.size())));
  std::vector<Tri> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    out.push_back({ring[i], ring[(i + 1) % ring.size()], middle});
    if (area_of(mesh, out.back()[0], out.back()[1], middle) > kLeastHole) continue;
    mesh.vertices.pop_back();
    return {};
  }
  return out;
}

/// Every edge between two vertices of rings of few corners.
EdgeSet edges_among(const geometry::TriangleMesh& mesh, const std::vector<Border>& borders) {
  std::vector<bool> near(mesh.vertices.size(), false);
  for (const Border& border : borders) {
    if (border.ring.size() > kLongestRing) continue;
    for (const Index v : border.ring) near[v] = true;
  }
  EdgeSet edges;
  for (const Tri& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      const Index a = t[c], b = t[(c + 1) % 3];
      if (near[a] && near[b]) edges.insert(std::minmax(a, b));
    }
  }
  return edges;
}

}  // namespace

FilledHoles fill_holes(geometry::TriangleMesh& mesh, const HalfEdges& edges, const MeshShells& shells,
                       double most) {
  const std::vector<Border> borders = borders_of(mesh, edges, shells);
  FilledHoles out;
  if (borders.empty()) return out;
  const std::vector<double> diagonals = diagonals_of(mesh, shells);
  EdgeSet taken = edges_among(mesh, borders);
  for (const Border& border : borders) {
    const bool small = border.ring.size() >= 3 && !shells.one_sided[border.shell] &&
                       length_of(mesh, border.ring) <= most * diagonals[border.shell];
    std::vector<Tri> filling;
    if (small && border.ring.size() <= kLongestRing) {
      filling = LeastFilling(mesh, border.ring, taken).triangles();
    }
    if (small && filling.empty()) filling = fan_filling(mesh, border.ring);
    if (filling.empty()) {
      ++out.left;
      continue;
    }
    for (const Tri& t : filling) {
      for (int c = 0; c < 3; ++c) taken.insert(std::minmax({t[c], t[(c + 1) % 3]}));
    }
    mesh.triangles.insert(mesh.triangles.end(), filling.begin(), filling.end());
    ++out.filled;
    out.triangles += static_cast<int>(filling.size());
  }
  return out;
}

}  // namespace toile::mesh_import
