#include "core/body/polygonise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace toile {
namespace {

constexpr int kBlock = 4;             // cells per side of the blocks that are skipped as a whole
constexpr double kNearBlock = 0.75;   // of a block's diagonal; 0.5 would do for an exact distance
constexpr double kEdgeMargin = 0.03;  // keeps crossings off the lattice points, so that no triangle vanishes

struct Lattice {
  Vec3 low;
  double cell;
  int n[3];  // points per axis
  std::vector<double> values;

  std::int64_t index(int x, int y, int z) const {
    return (static_cast<std::int64_t>(z) * n[1] + y) * n[0] + x;
  }
  Vec3 point(int x, int y, int z) const { return low + Vec3{x * cell, y * cell, z * cell}; }
  Vec3 point(std::int64_t i) const {
    const auto x = static_cast<int>(i % n[0]), y = static_cast<int>(i / n[0] % n[1]);
    return point(x, y, static_cast<int>(i / n[0] / n[1]));
  }
};

double value_at(const ImplicitSurface& surface, Lattice& lattice, int x, int y, int z) {
  double& v = lattice.values[lattice.index(x, y, z)];
  if (std::isnan(v)) v = surface(lattice.point(x, y, z)).value;
  return v;
}

Lattice make_lattice(const GridBox& box) {
  Lattice l{box.low, box.cell, {}, {}};
  const Vec3 size = box.high - box.low;
  const double sizes[3] = {size.x, size.y, size.z};
  std::size_t count = 1;
  for (int a = 0; a < 3; ++a) {
    const int blocks = static_cast<int>(std::ceil(sizes[a] / (box.cell * kBlock)));
    l.n[a] = blocks * kBlock + 1;
    count *= l.n[a];
  }
  l.values.assign(count, std::numeric_limits<double>::quiet_NaN());
  return l;
}

class Marcher {
 public:
  Marcher(const ImplicitSurface& surface, const GridBox& box)
      : surface_(surface), lattice_(make_lattice(box)) {}

  TriangleMesh run() {
    for (int z = 0; z + kBlock < lattice_.n[2]; z += kBlock)
      for (int y = 0; y + kBlock < lattice_.n[1]; y += kBlock)
        for (int x = 0; x + kBlock < lattice_.n[0]; x += kBlock)
          if (is_near(x, y, z)) march_block(x, y, z);
    return std::move(mesh_);
  }

 private:
  bool is_near(int x, int y, int z) {
    double least = std::numeric_limits<double>::max();
    for (int c = 0; c < 8; ++c) {
      const double v = value_at(surface_, lattice_, x + kBlock * (c & 1), y + kBlock * (c >> 1 & 1),
                                z + kBlock * (c >> 2));
      least = std::min(least, std::abs(v));
    }
    return least < kNearBlock * std::sqrt(3.0) * kBlock * lattice_.cell;
  }

  void march_block(int x0, int y0, int z0) {
    for (int z = z0; z < z0 + kBlock; ++z)
      for (int y = y0; y < y0 + kBlock; ++y)
        for (int x = x0; x < x0 + kBlock; ++x) march_cube(x, y, z);
  }

  // Six tetrahedra around the cube's main diagonal, all positively oriented; neighbours agree on faces.
  void march_cube(int x, int y, int z) {
    static constexpr int kTets[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                        {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    std::int64_t corner[8];
    int inside = 0;
    for (int c = 0; c < 8; ++c) {
      const int cx = x + (c & 1), cy = y + (c >> 1 & 1), cz = z + (c >> 2);
      corner[c] = lattice_.index(cx, cy, cz);
      inside += value_at(surface_, lattice_, cx, cy, cz) < 0;
    }
    if (inside == 0 || inside == 8) return;
    for (const auto& t : kTets) march_tet({corner[t[0]], corner[t[1]], corner[t[2]], corner[t[3]]});
  }

  void march_tet(std::array<std::int64_t, 4> t) {
    // Bring the inner corners to the front by swaps; an odd number of them turns the tetrahedron over.
    int inside = 0;
    bool odd = false;
    for (int i = 0; i < 4; ++i) {
      if (lattice_.values[t[i]] >= 0) continue;
      if (i != inside) std::swap(t[i], t[inside]), odd = !odd;
      ++inside;
    }
    if (inside == 1) add(odd, crossing(t[0], t[1]), crossing(t[0], t[2]), crossing(t[0], t[3]));
    if (inside == 3) add(odd, crossing(t[0], t[3]), crossing(t[1], t[3]), crossing(t[2], t[3]));
    if (inside == 2) {
      const Index a = crossing(t[0], t[2]), b = crossing(t[0], t[3]), c = crossing(t[1], t[3]),
                  d = crossing(t[1], t[2]);
      add(odd, a, b, c), add(odd, a, c, d);
    }
  }

  void add(bool odd, Index a, Index b, Index c) {
    if (odd) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  Index crossing(std::int64_t a, std::int64_t b) {
    if (a > b) std::swap(a, b);
    const auto total = static_cast<std::uint64_t>(lattice_.values.size());
    const auto [it, is_new] = vertex_of_edge_.try_emplace(static_cast<std::uint64_t>(a) * total + b,
                                                          static_cast<Index>(mesh_.vertices.size()));
    if (is_new) {
      const double va = lattice_.values[a], vb = lattice_.values[b];
      const double s = std::clamp(va / (va - vb), kEdgeMargin, 1 - kEdgeMargin);
      const Vec3 p = lattice_.point(a);
      mesh_.vertices.push_back(p + (lattice_.point(b) - p) * s);
    }
    return it->second;
  }

  const ImplicitSurface& surface_;
  Lattice lattice_;
  std::unordered_map<std::uint64_t, Index> vertex_of_edge_;  // looked up only, never walked
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh polygonise(const ImplicitSurface& surface, const GridBox& box) {
  return Marcher(surface, box).run();
}

}  // namespace toile
