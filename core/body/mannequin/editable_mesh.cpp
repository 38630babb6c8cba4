#include "core/body/mannequin/editable_mesh.h"

#include <algorithm>

#include "core/base/check.h"

namespace toile::mannequin {
namespace {

/// The corner of t across its edge ab.
Index third(const Tri& t, Index a, Index b) {
  for (Index v : t)
    if (v != a && v != b) return v;
  return kNone;
}

void erase(std::vector<Index>& list, Index value) { std::erase(list, value); }

}  // namespace

EditableMesh::EditableMesh(geometry::TriangleMesh mesh)
    : positions_(std::move(mesh.vertices)),
      normals_(positions_.size()),
      triangles_(std::move(mesh.triangles)),
      fans_(positions_.size()),
      live_(static_cast<Index>(triangles_.size())) {
  for (Index t = 0; t < live_; ++t)
    // Fans begin in the order of triangles and change by the order of edits alone: what is visited first
    // shows in the mesh, and must not hang on addresses.
    for (Index v : triangles_[t]) fans_[v].push_back(t);
}

Vec3 EditableMesh::normal(Index t) const {
  const Tri& k = triangles_[t];
  return cross(positions_[k[1]] - positions_[k[0]], positions_[k[2]] - positions_[k[0]]);
}

std::vector<EditableMesh::Edge> EditableMesh::edges() const {
  std::vector<Edge> out;
  out.reserve(static_cast<size_t>(live_) * 3 / 2);
  for (Index v = 0; v < vertex_count(); ++v) {
    for (Index t : fans_[v]) {
      for (int c = 0; c < 3; ++c) {
        // In a manifold each edge runs this way in one of its two triangles, so that it is met once.
        if (triangles_[t][c] == v && triangles_[t][(c + 1) % 3] > v)
          out.push_back({v, triangles_[t][(c + 1) % 3]});
      }
    }
  }
  return out;
}

bool EditableMesh::has_edge(Edge e) const { return side(e[0], e[1]) != kNone; }

Index EditableMesh::side(Index from, Index to) const {
  for (Index t : fans_[from]) {
    const Tri& k = triangles_[t];
    for (int c = 0; c < 3; ++c)
      if (k[c] == from && k[(c + 1) % 3] == to) return t;
  }
  return kNone;
}

std::array<Index, 2> EditableMesh::across(Edge e) const {
  return {third(triangles_[side(e[0], e[1])], e[0], e[1]), third(triangles_[side(e[1], e[0])], e[0], e[1])};
}

void EditableMesh::replace(Index t, Index from, Index to) {
  for (Index& v : triangles_[t])
    if (v == from) v = to;
}

Index EditableMesh::split(Edge e, const SurfacePoint& p) {
  const auto m = static_cast<Index>(positions_.size());
  positions_.push_back(p.position);
  normals_.push_back(p.normal);
  fans_.emplace_back();
  const Index sides[2] = {side(e[0], e[1]), side(e[1], e[0])};
  for (Index t : sides) {
    TOILE_CHECK(t != kNone);
    const auto fresh = static_cast<Index>(triangles_.size());
    const Index apex = third(triangles_[t], e[0], e[1]);
    triangles_.push_back(triangles_[t]);
    replace(t, e[1], m);
    replace(fresh, e[0], m);
    erase(fans_[e[1]], t);
    fans_[e[1]].push_back(fresh);
    fans_[apex].push_back(fresh);
    fans_[m].push_back(t);
    fans_[m].push_back(fresh);
  }
  live_ += 2;
  return m;
}

// Cosine between triangle t and its corners' mean normal, were its corner v at p.
double EditableMesh::facing(const Tri& t, Index v, const SurfacePoint& p) const {
  Vec3 q[3], outward;
  for (int c = 0; c < 3; ++c) {
    q[c] = t[c] == v ? p.position : positions_[t[c]];
    outward += t[c] == v ? p.normal : normals_[t[c]];
  }
  return dot(normalized(cross(q[1] - q[0], q[2] - q[0])), normalized(outward));
}

// The least facing around v, were it at p; triangles with `ignored` do not count.
double EditableMesh::fan_facing(Index v, Index ignored, const SurfacePoint& p) const {
  double least = 1;
  for (Index t : fans_[v]) {
    const Tri& k = triangles_[t];
    if (std::find(k.begin(), k.end(), ignored) == k.end()) least = std::min(least, facing(k, v, p));
  }
  return least;
}

double EditableMesh::least_facing(Index v, const SurfacePoint& p) const { return fan_facing(v, kNone, p); }

bool EditableMesh::overstretches(Index v, Vec3 p, double longest) const {
  for (Index t : fans_[v])
    for (Index c : triangles_[t])
      if (c != v && length(positions_[c] - p) > longest) return true;
  return false;
}

// The edge's ends must have two neighbours in common, no more: else merging them would glue sheets.
bool EditableMesh::pinches(Edge e) const {
  int common = 0;
  for (Index t : fans_[e[0]]) {
    const Tri& k = triangles_[t];
    for (int c = 0; c < 3; ++c) {
      if (k[c] != e[0]) continue;
      const Index n = k[(c + 1) % 3];
      if (n != e[1] && has_edge({n, e[1]})) ++common;
    }
  }
  return common != 2;
}

bool EditableMesh::collapse(Edge e, const SurfacePoint& p, double least_facing, double longest) {
  const std::array<Index, 2> apex = across(e);
  // A vertex that keeps two triangles would have them lie on each other.
  if (valence(apex[0]) <= 3 || valence(apex[1]) <= 3 || pinches(e)) return false;
  if (overstretches(e[0], p.position, longest) || overstretches(e[1], p.position, longest)) return false;
  // What faces away already may stay so: else a fold could never be worked out of the mesh.
  const double before = std::min(fan_facing(e[0], kNone, at(e[0])), fan_facing(e[1], kNone, at(e[1])));
  const double after = std::min(fan_facing(e[0], e[1], p), fan_facing(e[1], e[0], p));
  if (after < std::min(least_facing, before)) return false;
  const Index gone[2] = {side(e[0], e[1]), side(e[1], e[0])};
  for (Index t : gone) {
    for (Index v : triangles_[t]) erase(fans_[v], t);
    triangles_[t] = {kNone, kNone, kNone};
  }
  for (Index t : fans_[e[1]]) {
    replace(t, e[1], e[0]);
    fans_[e[0]].push_back(t);
  }
  fans_[e[1]].clear();
  move(e[0], p);
  live_ -= 2;
  return true;
}

bool EditableMesh::flip(Edge e, double least_facing) {
  const Index a = e[0], b = e[1], t0 = side(a, b), t1 = side(b, a);
  const Index c = third(triangles_[t0], a, b), d = third(triangles_[t1], a, b);
  // c and d joined already: the flip would make that edge a second time, with four triangles about it.
  if (c == d || valence(a) <= 3 || valence(b) <= 3 || has_edge({c, d}) || has_edge({d, c})) return false;
  const double before = std::min(facing(triangles_[t0], a, at(a)), facing(triangles_[t1], a, at(a)));
  const double after = std::min(facing({a, d, c}, a, at(a)), facing({b, c, d}, b, at(b)));
  if (after < std::min(least_facing, before)) return false;
  triangles_[t0] = {a, d, c};
  triangles_[t1] = {b, c, d};
  erase(fans_[b], t0);
  erase(fans_[a], t1);
  fans_[c].push_back(t1);
  fans_[d].push_back(t0);
  return true;
}

geometry::TriangleMesh EditableMesh::take() const {
  geometry::TriangleMesh out;
  std::vector<Index> number(positions_.size(), kNone);
  for (size_t v = 0; v < positions_.size(); ++v) {
    if (fans_[v].empty()) continue;
    // In the old order: equal edits give equal bytes.
    number[v] = static_cast<Index>(out.vertices.size());
    out.vertices.push_back(positions_[v]);
  }
  for (const Tri& t : triangles_)
    if (t[0] != kNone) out.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return out;
}

}  // namespace toile::mannequin
