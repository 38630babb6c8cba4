#include "core/body/measure/mesh_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/aabb.h"
#include "core/base/disjoint_sets.h"
#include "core/geometry/bvh.h"

namespace toile::measure {
namespace {

// Some 7 mm each on a grown-up, about an edge of its mesh: most triangles then lie in one or two bins.
constexpr size_t kBins = 256;

constexpr size_t kGroup = 32;  // triangles of PlaneCutter's groups

/// Gathers the crossed edges of a few triangles; equal edges become one point. `Height` gives a vertex's
/// height by its index.
template <typename Height>
class CutBuilder {
 public:
  CutBuilder(const geometry::TriangleMesh& mesh, Height height, double level)
      : mesh_(mesh), height_(std::move(height)), level_(level) {}

  void add(const Tri& t) {
    std::uint64_t ends[2];
    int found = 0;
    for (int c = 0; c < 3 && found < 2; ++c) {
      const Index a = std::min(t[c], t[(c + 1) % 3]), b = std::max(t[c], t[(c + 1) % 3]);
      // A vertex in the plane counts as above it for all its edges alike: the line never breaks there.
      if ((height_(a) < level_) == (height_(b) < level_)) continue;
      // The edge by its vertices: both its triangles name the same point.
      ends[found++] = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
    }
    if (found == 2) segments_.push_back({ends[0], ends[1]});
  }

  MeshCut take() {
    std::vector<std::uint64_t> edges;
    for (const auto& s : segments_) edges.insert(edges.end(), s.begin(), s.end());
    // By vertices and not by triangles, so that points come in one order whichever triangles were looked at.
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const auto place = [&](std::uint64_t e) {
      return static_cast<Index>(std::lower_bound(edges.begin(), edges.end(), e) - edges.begin());
    };
    DisjointSets parts(edges.size());
    for (const auto& s : segments_) parts.join(place(s[0]), place(s[1]));
    MeshCut cut;
    cut.points.reserve(edges.size());
    for (std::uint64_t e : edges) cut.points.push_back(on_edge(e));
    number_parts(parts, cut);
    return cut;
  }

 private:
  Vec3 on_edge(std::uint64_t e) const {
    const auto a = static_cast<Index>(e >> 32), b = static_cast<Index>(e & 0xffffffffu);
    const double s = (level_ - height_(a)) / (height_(b) - height_(a));
    return mesh_.vertices[a] + (mesh_.vertices[b] - mesh_.vertices[a]) * s;
  }

  static void number_parts(DisjointSets& parts, MeshCut& cut) {
    std::vector<Index> number(cut.points.size(), kNone);
    for (Index i = 0; i < static_cast<Index>(number.size()); ++i) {
      Index& n = number[parts.root(i)];
      if (n == kNone) n = cut.part_count++;
      cut.part.push_back(n);
    }
  }

  const geometry::TriangleMesh& mesh_;
  Height height_;
  double level_;
  std::vector<std::array<std::uint64_t, 2>> segments_;
};

std::vector<Index> all_or(std::span<const Index> triangles, size_t count) {
  std::vector<Index> out(triangles.begin(), triangles.end());
  if (!out.empty()) return out;
  out.resize(count);
  std::iota(out.begin(), out.end(), 0);
  return out;
}

/// Of vertices over the plane, in lengths of its normal.
auto height_over(const geometry::TriangleMesh& mesh, Vec3 origin, Vec3 normal) {
  return [&mesh, origin, normal](Index v) { return dot(normal, mesh.vertices[v] - origin); };
}

}  // namespace

MeshCutter::MeshCutter(const geometry::TriangleMesh& mesh, Vec3 direction, std::span<const Index> triangles)
    : mesh_(mesh), bins_(kBins) {
  height_.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices) height_.push_back(dot(direction, p));
  const std::vector<Index> chosen = all_or(triangles, mesh.triangles.size());
  const auto range = [&](Index t) {
    const Tri& k = mesh.triangles[t];
    return std::minmax({height_[k[0]], height_[k[1]], height_[k[2]]});
  };
  low_ = HUGE_VAL;
  high_ = -HUGE_VAL;
  for (Index t : chosen) {
    low_ = std::min(low_, range(t).first);
    high_ = std::max(high_, range(t).second);
  }
  if (chosen.empty() || !(high_ > low_)) {
    low_ = high_ = 0;
    return;
  }
  step_ = (high_ - low_) / kBins;
  for (Index t : chosen) {
    const auto [a, b] = range(t);
    for (size_t i = bin(a); i <= bin(b); ++i) bins_[i].push_back(t);
  }
}

size_t MeshCutter::bin(double height) const {
  return static_cast<size_t>(std::clamp((height - low_) / step_, 0.0, static_cast<double>(kBins - 1)));
}

MeshCut MeshCutter::at(double height) const {
  if (!(height >= low_ && height <= high_)) return {};
  CutBuilder builder(
      mesh_, [this](Index v) { return height_[v]; }, height);
  for (Index t : bins_[bin(height)]) builder.add(mesh_.triangles[t]);
  return builder.take();
}

PlaneCutter::PlaneCutter(const geometry::TriangleMesh& mesh) : mesh_(mesh) {
  const std::vector<Vec3>& x = mesh.vertices;
  std::vector<geometry::Box3> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const Tri& t : mesh.triangles) boxes.push_back(geometry::box_around({x[t[0]], x[t[1]], x[t[2]]}, 0));
  std::vector<Index> order = all_or({}, mesh.triangles.size());
  geometry::part_by_place(order, boxes, kGroup, [&](std::span<const Index> members) {
    Aabb3 box;
    for (const Index t : members)
      for (const Index v : mesh.triangles[t]) box.add(x[v]);
    order_.insert(order_.end(), members.begin(), members.end());
    groups_.push_back({box.middle(), length(box.size()) / 2, order_.size()});
  });
}

MeshCut PlaneCutter::cut(Vec3 origin, Vec3 normal) const {
  CutBuilder builder(mesh_, height_over(mesh_, origin, normal), 0);
  const double stretch = length(normal);
  size_t at = 0;
  for (const Group& group : groups_) {
    const double off = std::abs(dot(normal, group.centre - origin));
    // A little more than the ball: rounding must not lose a triangle that touches the plane.
    if (off <= stretch * (group.radius * (1 + 1e-9) + 1e-9))
      for (size_t i = at; i < group.end; ++i) builder.add(mesh_.triangles[order_[i]]);
    at = group.end;
  }
  return builder.take();
}

MeshCut plane_cut(const geometry::TriangleMesh& mesh, Vec3 origin, Vec3 normal,
                  std::span<const Index> triangles) {
  CutBuilder builder(mesh, height_over(mesh, origin, normal), 0);
  if (triangles.empty())
    for (const Tri& t : mesh.triangles) builder.add(t);
  else
    for (const Index t : triangles) builder.add(mesh.triangles[t]);
  return builder.take();
}

}  // namespace toile::measure
