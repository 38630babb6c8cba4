#include "core/body/mannequin/remesh.h"

#include <algorithm>
#include <cmath>

#include "core/body/mannequin/editable_mesh.h"

namespace toile::mannequin {
namespace {

using Edge = EditableMesh::Edge;

constexpr double kSplitOver = 4.0 / 3, kCollapseUnder = 4.0 / 5;  // of the wanted length
constexpr double kLeastFacing = 0.5;  // cosine between a triangle's normal and the surface's
constexpr double kSliver = 0.35;      // quality below which a triangle must go
constexpr double kSliverFacing = 0.2;
constexpr double kSameSheet = 0.2;   // cosine between normals of neighbours
constexpr double kRelaxation = 0.7;  // of the way to the middle of the neighbours
constexpr double kReach = 0.6;       // of an edge's length: how far a projection may go
constexpr int kNewtonSteps = 6;
constexpr double kArrived = 1e-7;     // of the stature
constexpr double kFirstReach = 0.02;  // of the stature

// 1 for an equilateral triangle, 0 for a line.
double triangle_quality(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  return 2 * std::sqrt(3.0) * length(cross(ab, bc)) / (dot(ab, ab) + dot(bc, bc) + dot(ca, ca));
}

class Remesher {
 public:
  Remesher(geometry::TriangleMesh mesh, const ImplicitSurface& surface, const RemeshSettings& settings)
      : mesh_(std::move(mesh)), surface_(surface), settings_(settings) {
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      mesh_.move(v, project(surface_, mesh_.position(v), kFirstReach));
    }
    fix_length();
  }

  void round() {
    split_long_edges();
    collapse_short_edges();
    even_valences();
    remove_slivers();
    relax();
    // The wanted length follows the count, so that split and collapse end near it.
    const double over = static_cast<double>(mesh_.triangle_count()) / settings_.triangle_count;
    length_ *= std::clamp(std::sqrt(over), 0.93, 1.07);
  }

  void meet_count();
  void even_valences();
  void remove_slivers();
  void relax();
  geometry::TriangleMesh take() const { return mesh_.take(); }

 private:
  double wanted(Vec3 p) const { return length_ * (settings_.fineness ? settings_.fineness(p) : 1); }
  double edge_length(Edge e) const { return length(mesh_.position(e[1]) - mesh_.position(e[0])); }
  /// Length relative to what is wanted there.
  double stretch(Edge e) const {
    const Vec3 &a = mesh_.position(e[0]), &b = mesh_.position(e[1]);
    return length(b - a) / wanted((a + b) * 0.5);
  }
  /// The edge's middle on the surface; not found where that is another sheet than the edge's.
  SurfacePoint middle(Edge e) const {
    const SurfacePoint a = mesh_.at(e[0]), b = mesh_.at(e[1]);
    const double reach = kReach * ::toile::length(b.position - a.position);
    SurfacePoint p = project(surface_, (a.position + b.position) * 0.5, reach);
    p.found = p.found && std::min(dot(p.normal, a.normal), dot(p.normal, b.normal)) > kSameSheet;
    return p;
  }

  double quality(const Tri& t) const {
    return triangle_quality(mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2]));
  }
  bool collapse(Edge e, double longest, double least_facing = kLeastFacing) {
    const SurfacePoint p = middle(e);
    return p.found && mesh_.collapse(e, p, least_facing, longest * wanted(p.position));
  }

  std::vector<Edge> sorted_edges(double low, double high, bool longest_first) const;
  void fix_length();
  void split_long_edges();
  void collapse_short_edges();

  EditableMesh mesh_;
  const ImplicitSurface& surface_;
  const RemeshSettings& settings_;
  double length_ = 0;
};

// The edge length at which equilateral triangles of the wanted sizes would be as many as asked.
void Remesher::fix_length() {
  length_ = 1;
  double area = 0;
  for (Index v = 0; v < mesh_.vertex_count(); ++v) {
    for (Index t : mesh_.fan(v)) {
      const double w = wanted(mesh_.position(v));
      area += ::toile::length(mesh_.normal(t)) / 6 / (w * w);
    }
  }
  length_ = std::sqrt(area / settings_.triangle_count * 4 / std::sqrt(3.0));
}

// Edges whose stretch lies between the limits, worst first; ties by vertex, so that runs repeat.
std::vector<Edge> Remesher::sorted_edges(double low, double high, bool longest_first) const {
  std::vector<std::pair<double, Edge>> found;
  for (const Edge& e : mesh_.edges()) {
    const double s = stretch(e);
    if (s > low && s < high) found.push_back({longest_first ? -s : s, e});
  }
  std::sort(found.begin(), found.end());
  std::vector<Edge> out(found.size());
  std::transform(found.begin(), found.end(), out.begin(), [](const auto& f) { return f.second; });
  return out;
}

void Remesher::split_long_edges() {
  for (const Edge& e : sorted_edges(kSplitOver, HUGE_VAL, true)) {
    if (const SurfacePoint p = middle(e); p.found) mesh_.split(e, p);
  }
}

void Remesher::collapse_short_edges() {
  for (const Edge& e : sorted_edges(0, kCollapseUnder, false)) {
    if (!mesh_.is_live(e[0]) || !mesh_.is_live(e[1]) || !mesh_.has_edge(e)) continue;
    if (stretch(e) >= kCollapseUnder) continue;
    collapse(e, kSplitOver);
  }
}

// Flips where that brings the four valences around an edge nearer to six.
void Remesher::even_valences() {
  for (const Edge& e : mesh_.edges()) {
    if (!mesh_.has_edge(e)) continue;
    const std::array<Index, 2> o = mesh_.across(e);
    const auto off = [&](Index v, int change) { return std::abs(mesh_.valence(v) + change - 6); };
    const int before = off(e[0], 0) + off(e[1], 0) + off(o[0], 0) + off(o[1], 0);
    const int after = off(e[0], -1) + off(e[1], -1) + off(o[0], 1) + off(o[1], 1);
    if (after < before) mesh_.flip(e, kLeastFacing);
  }
}

// Flat triangles: flip their longest edge where that helps, or merge their shortest.
void Remesher::remove_slivers() {
  for (Index t = 0; t < mesh_.triangle_end(); ++t) {
    const Tri k = mesh_.triangle(t);
    if (k[0] == kNone || quality(k) > kSliver) continue;
    Edge longest{k[0], k[1]}, shortest = longest;
    for (int c = 0; c < 3; ++c) {
      const Edge e{k[c], k[(c + 1) % 3]};
      if (edge_length(e) > edge_length(longest)) longest = e;
      if (edge_length(e) < edge_length(shortest)) shortest = e;
    }
    const std::array<Index, 2> o = mesh_.across(longest);
    const double before = std::min(quality(k), quality({longest[1], longest[0], o[1]}));
    const double after = std::min(quality({longest[0], o[1], o[0]}), quality({longest[1], o[0], o[1]}));
    if (after > 2 * before && mesh_.flip(longest, kSliverFacing)) continue;
    collapse(shortest, 2, kSliverFacing);
  }
}

// Moves each vertex towards the middle of its fan, weighted by area over wanted area, along the surface.
// One after the other, so that each sees where its neighbours are, and none folds the surface over.
void Remesher::relax() {
  for (Index v = 0; v < mesh_.vertex_count(); ++v) {
    if (!mesh_.is_live(v)) continue;
    const Vec3 p = mesh_.position(v);
    Vec3 sum, normal;
    double weight = 0;
    for (Index t : mesh_.fan(v)) {
      const Tri& k = mesh_.triangle(t);
      const Vec3 n = mesh_.normal(t);
      const Vec3 centre = (mesh_.position(k[0]) + mesh_.position(k[1]) + mesh_.position(k[2])) * (1.0 / 3);
      const double w = ::toile::length(n) / (wanted(centre) * wanted(centre));
      sum += centre * w;
      weight += w;
      normal += n;
    }
    if (weight <= 0) continue;
    normal = normalized(normal);
    const Vec3 step = (sum * (1 / weight) - p) * kRelaxation;
    const SurfacePoint q = project(surface_, p + step - normal * dot(step, normal), kReach * wanted(p));
    if (!q.found || dot(q.normal, mesh_.at(v).normal) < kSameSheet) continue;
    if (mesh_.least_facing(v, q) >= std::min(mesh_.least_facing(v, mesh_.at(v)), kLeastFacing))
      mesh_.move(v, q);
  }
}

// The last few triangles: one edge at a time, the most stretched or the shortest.
void Remesher::meet_count() {
  for (int pass = 0; pass < 20; ++pass) {
    Index excess = (mesh_.triangle_count() - settings_.triangle_count) / 2;
    if (excess == 0) return;
    for (const Edge& e : sorted_edges(0, HUGE_VAL, excess < 0)) {
      if (excess == 0) break;
      if (!mesh_.is_live(e[0]) || !mesh_.is_live(e[1]) || !mesh_.has_edge(e)) continue;
      if (excess < 0) {
        if (const SurfacePoint p = middle(e); p.found) {
          mesh_.split(e, p);
          ++excess;
        }
      } else {
        excess -= collapse(e, 2);
      }
    }
  }
}

}  // namespace

SurfacePoint project(const ImplicitSurface& surface, Vec3 p, double reach) {
  const Vec3 start = p;
  FieldSample s = surface(p);
  for (int i = 0; i < kNewtonSteps && std::abs(s.value) > kArrived; ++i) {
    p -= s.gradient * (s.value / std::max(dot(s.gradient, s.gradient), 0.1));
    if (length(p - start) > reach) return {start, normalized(s.gradient), false};
    s = surface(p);
  }
  return {p, normalized(s.gradient), std::abs(s.value) < 100 * kArrived};
}

geometry::TriangleMesh remesh(geometry::TriangleMesh mesh, const ImplicitSurface& surface,
                              const RemeshSettings& settings) {
  Remesher r(std::move(mesh), surface, settings);
  for (int i = 0; i < settings.rounds; ++i) r.round();
  r.meet_count();
  for (int i = 0; i < 3; ++i) {
    r.even_valences();
    r.remove_slivers();
    r.meet_count();
    r.relax();
  }
  return r.take();
}

geometry::TriangleMesh refit(geometry::TriangleMesh mesh, const ImplicitSurface& surface,
                             const RemeshSettings& settings, int relaxations) {
  Remesher r(std::move(mesh), surface, settings);
  for (int i = 0; i < relaxations; ++i) r.relax();
  return r.take();
}

}  // namespace toile::mannequin
