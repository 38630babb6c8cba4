#include "core/body/mannequin/polygonise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace toile::mannequin {
namespace {

constexpr int kBlock = 4, kSmallBlock = 2;  // cells per side of the blocks that are skipped as a whole
constexpr double kNearBlock = 0.60;         // of a block's diagonal; 0.5 would do for an exact distance
constexpr double kEdgeMargin = 0.03;  // keeps crossings off the lattice points, so that no triangle vanishes

// Corner i of a cube lies at (i & 1, i >> 1 & 1, i >> 2); edge 4a + k runs along axis a.
struct CubeEdge {
  int low, axis;  // its lower corner
};
constexpr CubeEdge kEdges[12] = {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {0, 1}, {1, 1},
                                 {4, 1}, {5, 1}, {0, 2}, {1, 2}, {2, 2}, {3, 2}};
// Corners of the faces, counter-clockwise from outside.
constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                              {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

int edge_between(int a, int b) {
  const int low = std::min(a, b), step = std::abs(a - b), axis = step == 1 ? 0 : step == 2 ? 1 : 2;
  for (int e = 4 * axis; e < 4 * axis + 4; ++e)
    if (kEdges[e].low == low) return e;
  return -1;
}

/// How the surface runs through a cube whose inner corners are the bits of `inside`: loops from edge to edge,
/// counter-clockwise from outside. Inner corners across a face from each other are kept apart, which both
/// cubes of the face see alike.
struct CubeCase {
  std::int8_t next[12];  ///< the edge that follows an edge, or −1
  bool twice = false;    ///< whether a loop may visit a face twice
};

CubeCase cube_case(int inside) {
  CubeCase c{};
  std::fill(std::begin(c.next), std::end(c.next), std::int8_t{-1});
  const auto in = [&](int corner) { return (inside >> corner & 1) != 0; };
  for (const auto& face : kFaces) {
    int runs = 0;
    for (int i = 0; i < 4; ++i) {
      if (in(face[i]) || !in(face[(i + 1) % 4])) continue;
      int j = (i + 1) % 4;  // a run of inner corners starts here
      const int enters = edge_between(face[i], face[j]);
      while (in(face[(j + 1) % 4])) j = (j + 1) % 4;
      c.next[enters] = static_cast<std::int8_t>(edge_between(face[j], face[(j + 1) % 4]));
      ++runs;
    }
    c.twice = c.twice || runs > 1;
  }
  return c;
}

const std::array<CubeCase, 256>& cube_cases() {
  static const std::array<CubeCase, 256> cases = [] {
    std::array<CubeCase, 256> all;
    for (int i = 0; i < 256; ++i) all[static_cast<size_t>(i)] = cube_case(i);
    return all;
  }();
  return cases;
}

struct Lattice {
  Vec3 low;
  double cell;
  int n[3];  // points per axis
  std::vector<double> values;

  std::int64_t index(int x, int y, int z) const {
    return (static_cast<std::int64_t>(z) * n[1] + y) * n[0] + x;
  }
  std::int64_t stride(int axis) const {
    return axis == 0 ? 1 : axis == 1 ? n[0] : static_cast<std::int64_t>(n[0]) * n[1];
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
      : surface_(surface), lattice_(make_lattice(box)), marched_(lattice_.values.size(), 0) {}

  geometry::TriangleMesh run() {
    for (int z = 0; z + kBlock < lattice_.n[2]; z += kBlock)
      for (int y = 0; y + kBlock < lattice_.n[1]; y += kBlock)
        for (int x = 0; x + kBlock < lattice_.n[0]; x += kBlock)
          if (is_near(x, y, z, kBlock)) march_block(x, y, z);
    return std::move(mesh_);
  }

 private:
  /// Whether the surface may pass through the block of `cells` per side.
  bool is_near(int x, int y, int z, int cells) {
    const double half = cells / 2.0 * lattice_.cell;
    const double v = surface_(lattice_.point(x, y, z) + Vec3{half, half, half}).value;
    return std::abs(v) < kNearBlock * std::sqrt(3.0) * cells * lattice_.cell;
  }

  void march_block(int x0, int y0, int z0) {
    for (int z = z0; z < z0 + kBlock; z += kSmallBlock)
      for (int y = y0; y < y0 + kBlock; y += kSmallBlock)
        for (int x = x0; x < x0 + kBlock; x += kSmallBlock)
          if (is_near(x, y, z, kSmallBlock)) visit({x, y, z});
  }

  using Place = std::array<int, 3>;

  // Marches a small block once, and then those beside it that the surface goes on into: `value` may be far
  // from the distance here and there.
  void visit(const Place& first) {
    std::vector<Place> waiting{first};
    while (!waiting.empty()) {
      const Place at = waiting.back();
      waiting.pop_back();
      char& done = marched_[static_cast<size_t>(lattice_.index(at[0], at[1], at[2]))];
      if (done != 0) continue;
      done = 1;
      march_cubes(at[0], at[1], at[2]);
      for (int axis = 0; axis < 3; ++axis) {
        for (int side : {-kSmallBlock, kSmallBlock}) {
          Place beside = at;
          beside[static_cast<size_t>(axis)] += side;
          const int to = beside[static_cast<size_t>(axis)];
          if (to >= 0 && to + kSmallBlock < lattice_.n[axis] && is_crossed(at, axis, side > 0))
            waiting.push_back(beside);
        }
      }
    }
  }

  // Whether the surface meets a face of a small block that has been marched.
  bool is_crossed(const Place& at, int axis, bool far) const {
    int inside = 0, points = 0;
    for (int i = 0; i <= kSmallBlock; ++i) {
      for (int j = 0; j <= kSmallBlock; ++j, ++points) {
        const int across = far ? kSmallBlock : 0;
        const Place d = axis == 0   ? Place{across, i, j}
                        : axis == 1 ? Place{i, across, j}
                                    : Place{i, j, across};
        inside +=
            lattice_.values[static_cast<size_t>(lattice_.index(at[0] + d[0], at[1] + d[1], at[2] + d[2]))] <
            0;
      }
    }
    return inside > 0 && inside < points;
  }

  void march_cubes(int x0, int y0, int z0) {
    for (int z = z0; z < z0 + kSmallBlock; ++z)
      for (int y = y0; y < y0 + kSmallBlock; ++y)
        for (int x = x0; x < x0 + kSmallBlock; ++x) march_cube(x, y, z);
  }

  void march_cube(int x, int y, int z) {
    std::int64_t corner[8];
    int inside = 0;
    for (int c = 0; c < 8; ++c) {
      const int cx = x + (c & 1), cy = y + (c >> 1 & 1), cz = z + (c >> 2);
      corner[c] = lattice_.index(cx, cy, cz);
      inside |= (value_at(surface_, lattice_, cx, cy, cz) < 0) << c;
    }
    if (inside == 0 || inside == 255) return;
    const CubeCase& way = cube_cases()[static_cast<size_t>(inside)];
    bool seen[12] = {};
    for (int e = 0; e < 12; ++e) {
      if (way.next[e] < 0 || seen[e]) continue;
      loop_.clear();
      for (int at = e; !seen[at]; at = way.next[at]) {
        seen[at] = true;
        loop_.push_back(crossing(corner[kEdges[at].low], kEdges[at].axis));
      }
      fill_loop(way.twice);
    }
  }

  // Triangles from the first corner; from the middle where a chord could lie in a face, and two cubes draw
  // the same.
  void fill_loop(bool from_middle) {
    const size_t n = loop_.size();
    if (from_middle && n > 3) {
      Vec3 sum;
      for (Index v : loop_) sum += mesh_.vertices[static_cast<size_t>(v)];
      const auto middle = static_cast<Index>(mesh_.vertices.size());
      mesh_.vertices.push_back(sum * (1.0 / static_cast<double>(n)));
      for (size_t i = 0; i < n; ++i) mesh_.triangles.push_back({middle, loop_[i], loop_[(i + 1) % n]});
      return;
    }
    for (size_t i = 1; i + 1 < n; ++i) mesh_.triangles.push_back({loop_[0], loop_[i], loop_[i + 1]});
  }

  Index crossing(std::int64_t low, int axis) {
    const auto [it, is_new] =
        vertex_of_edge_.try_emplace(3 * low + axis, static_cast<Index>(mesh_.vertices.size()));
    if (is_new) {
      const std::int64_t high = low + lattice_.stride(axis);
      const double va = lattice_.values[low], vb = lattice_.values[high];
      const double s = std::clamp(va / (va - vb), kEdgeMargin, 1 - kEdgeMargin);
      const Vec3 p = lattice_.point(low);
      mesh_.vertices.push_back(p + (lattice_.point(high) - p) * s);
    }
    return it->second;
  }

  const ImplicitSurface& surface_;
  Lattice lattice_;
  std::vector<char> marched_;                               ///< by a small block's first point
  std::unordered_map<std::int64_t, Index> vertex_of_edge_;  // looked up only, never walked
  std::vector<Index> loop_;
  geometry::TriangleMesh mesh_;
};

}  // namespace

geometry::TriangleMesh polygonise(const ImplicitSurface& surface, const GridBox& box) {
  return Marcher(surface, box).run();
}

}  // namespace toile::mannequin
