#include "core/preflight/check_layers.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/geometry/bvh.h"
#include "core/geometry/distance.h"

namespace toile::preflight {

namespace {

constexpr double kReach = 0.1;    // m, outwards: what lies farther away is no layer over this one
constexpr double kNearest = 0.4;  // m, from the body: what is farther has no outside

/// Nearest points of the bodies.
class Skin {
 public:
  explicit Skin(std::span<const body::Body> bodies) {
    std::vector<geometry::Box3> boxes;
    for (const body::Body& body : bodies) {
      for (const Tri& t : body.mesh.triangles) {
        const std::vector<Vec3>& x = body.mesh.vertices;
        corners_.push_back({x[t[0]], x[t[1]], x[t[2]]});
        boxes.push_back(geometry::box_around({x[t[0]], x[t[1]], x[t[2]]}, 0));
      }
    }
    tree_ = geometry::Bvh(boxes);
  }

  std::optional<Vec3> nearest(Vec3 p) const {
    for (double reach = kNearest / 16; reach <= kNearest; reach *= 2) {
      double best = reach;
      std::optional<Vec3> found;
      tree_.query(geometry::box_around({p}, reach), [&](Index t) {
        const auto& [a, b, c] = corners_[t];
        const geometry::TrianglePoint w = geometry::closest_on_triangle(p, a, b, c);
        const Vec3 q = a * w.a + b * w.b + c * w.c;
        if (length(q - p) < best) {
          best = length(q - p);
          found = q;
        }
      });
      if (found) return found;
    }
    return std::nullopt;
  }

 private:
  std::vector<std::array<Vec3, 3>> corners_;
  geometry::Bvh tree_;
};

/// Whether the segment passes through the triangle.
bool passes(Vec3 from, Vec3 to, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 d = to - from, e1 = b - a, e2 = c - a, p = cross(d, e2);
  const double det = dot(e1, p);
  if (det == 0) return false;
  const Vec3 s = from - a, q = cross(s, e1);
  const double u = dot(s, p) / det, v = dot(d, q) / det, t = dot(e2, q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < 1;
}

/// How often a lower piece was seen from a higher one, towards the body and away from it.
struct Sight {
  int towards = 0, away = 0;
  Vec3 place;  ///< m, the first vertex that saw it away from the body
};

class Watch {
 public:
  Watch(const PreflightInput& input, const sewing::Assembly& assembly) : input_(input), assembly_(assembly) {
    std::vector<geometry::Box3> boxes;
    for (const Tri& t : assembly.garment.triangles) {
      boxes.push_back(geometry::box_around({x(t[0]), x(t[1]), x(t[2])}, 0));
    }
    cloth_ = geometry::Bvh(boxes);
  }

  /// By (lower piece, higher piece).
  std::map<std::pair<Index, Index>, Sight> look() {
    const Skin skin(input_.bodies);
    const sewing::GarmentMesh& g = assembly_.garment;
    int lowest = layer(0);
    for (std::size_t p = 0; p < input_.pattern.panels.size(); ++p) {
      lowest = std::min(lowest, layer(static_cast<Index>(p)));
    }
    for (Index v = 0; v < g.vertex_count(); ++v) {
      if (layer(g.panel_of_vertex[v]) == lowest) continue;
      const auto foot = skin.nearest(x(v));
      if (!foot || *foot == x(v)) continue;
      look_along(v, *foot, false);
      look_along(v, x(v) + normalized(x(v) - *foot) * kReach, true);
    }
    return std::move(sights_);
  }

 private:
  Vec3 x(Index v) const { return assembly_.positions[v]; }
  int layer(Index panel) const { return input_.pattern.panels[panel].layer; }

  void look_along(Index v, Vec3 to, bool away) {
    const sewing::GarmentMesh& g = assembly_.garment;
    const Index higher = g.panel_of_vertex[v];
    cloth_.query(geometry::box_around({x(v), to}, 0), [&](Index t) {
      const Index lower = g.panel_of_triangle[t];
      if (layer(lower) >= layer(higher)) return;
      const Tri& c = g.triangles[t];
      if (!passes(x(v), to, x(c[0]), x(c[1]), x(c[2]))) return;
      Sight& sight = sights_[{lower, higher}];
      if (away && sight.away == 0) sight.place = x(v);
      ++(away ? sight.away : sight.towards);
    });
  }

  const PreflightInput& input_;
  const sewing::Assembly& assembly_;
  geometry::Bvh cloth_;
  std::map<std::pair<Index, Index>, Sight> sights_;
};

}  // namespace

void check_layers(const PreflightInput& input, const sewing::Assembly& assembly, Findings& findings) {
  const std::vector<pattern::Panel>& panels = input.pattern.panels;
  const bool one = std::all_of(panels.begin(), panels.end(),
                               [&](const pattern::Panel& p) { return p.layer == panels.front().layer; });
  if (one || input.bodies.empty()) return;
  for (const auto& [pair, sight] : Watch(input, assembly).look()) {
    if (sight.away <= sight.towards) continue;
    const pattern::Panel &lower = panels[pair.first], &higher = panels[pair.second];
    findings.push_back(found(FindingKind::kLayerInside,
                             "the piece is of layer " + std::to_string(higher.layer) +
                                 ", but starts nearer to the body than piece " + lower.id + " of layer " +
                                 std::to_string(lower.layer) + "; place it farther out, or change the layers",
                             {piece_named(higher.id)}, sight.place));
  }
}

}  // namespace toile::preflight
