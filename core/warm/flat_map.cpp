#include "core/warm/flat_map.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <map>
#include <optional>

#include "core/mesh/flat_locator.h"
#include "core/mesh/topology.h"

namespace toile::warm {

namespace {

constexpr double kOff = 1e-6;      // share of a triangle by which a point is off the piece
constexpr double kUnmoved = 1e-9;  // m

using Way = std::optional<Vec2>;

double length_of(std::span<const Vec2> rest, const std::vector<Index>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += length(rest[line[i]] - rest[line[i - 1]]);
  return sum;
}

/// Walks along a line of the piece before; asked for places further and further on.
class Walker {
 public:
  Walker(std::span<const Vec2> rest, const std::vector<Index>& line) : rest_(rest), line_(line) {}

  Vec2 at(double along) {
    while (next_ + 1 < line_.size() && passed_ + segment() < along) {
      passed_ += segment();
      ++next_;
    }
    const double l = segment();
    const double share = l > 0 ? std::clamp((along - passed_) / l, 0.0, 1.0) : 0;
    return rest_[line_[next_ - 1]] + (rest_[line_[next_]] - rest_[line_[next_ - 1]]) * share;
  }

 private:
  double segment() const { return length(rest_[line_[next_]] - rest_[line_[next_ - 1]]); }

  std::span<const Vec2> rest_;
  const std::vector<Index>& line_;
  std::size_t next_ = 1;
  double passed_ = 0;
};

Vec2 nearest_on(std::span<const Vec2> rest, const std::vector<HungEdge>& border, Vec2 p) {
  Vec2 best = p;
  double least = 1e18;
  for (const HungEdge& edge : border) {
    for (std::size_t i = 1; i < edge.vertices.size(); ++i) {
      const Vec2 a = rest[edge.vertices[i - 1]], d = rest[edge.vertices[i]] - a;
      const double t = std::clamp(dot(p - a, d) / std::max(1e-18, dot(d, d)), 0.0, 1.0);
      const Vec2 q = a + d * t;
      if (dot(p - q, p - q) >= least) continue;
      least = dot(p - q, p - q);
      best = q;
    }
  }
  return best;
}

/// Of the border's vertices; nothing for those inside.
std::vector<Way> ways_of_border(const HungPiece& before, const mesh::PanelMesh& now,
                                const std::vector<std::string>& edges) {
  std::vector<Way> ways(now.rest.size());
  const mesh::FlatLocator flat(before.rest, before.triangles);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::vector<Index>& line = now.edge_vertices[e];
    const auto known = std::find_if(before.edges.begin(), before.edges.end(),
                                    [&](const HungEdge& edge) { return edge.id == edges[e]; });
    if (known == before.edges.end()) {
      for (const Index v : line) {
        const bool off = flat.at(now.rest[v]).outside > kOff;
        if (!ways[v])
          ways[v] = off ? nearest_on(before.rest, before.edges, now.rest[v]) - now.rest[v] : Vec2{};
      }
      continue;
    }
    const double scale = length_of(before.rest, known->vertices) / std::max(1e-12, length_of(now.rest, line));
    Walker walker(before.rest, known->vertices);
    double along = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i > 0) along += length(now.rest[line[i]] - now.rest[line[i - 1]]);
      ways[line[i]] = walker.at(along * scale) - now.rest[line[i]];
    }
  }
  return ways;
}

/// The mean of its neighbours' at every vertex that has no way yet.
std::vector<Vec2> filled_in(const mesh::PanelMesh& now, const std::vector<Way>& known) {
  std::vector<Index> unknown(known.size(), kNone);
  Index count = 0;
  for (std::size_t v = 0; v < known.size(); ++v)
    if (!known[v]) unknown[v] = count++;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
  const auto join = [&](Index v, Index w) {
    if (unknown[v] == kNone) return;
    entries.emplace_back(unknown[v], unknown[v], 1);
    if (unknown[w] != kNone) {
      entries.emplace_back(unknown[v], unknown[w], -1);
    } else {
      right.row(unknown[v]) += Eigen::RowVector2d(known[w]->x, known[w]->y);
    }
  };
  for (const mesh::MeshEdge& e : mesh::edges_of(now.triangles, static_cast<Index>(now.rest.size()))) {
    join(e.v0, e.v1);
    join(e.v1, e.v0);
  }
  std::vector<Vec2> ways(known.size());
  for (std::size_t v = 0; v < known.size(); ++v) ways[v] = known[v].value_or(Vec2{});
  if (count == 0) return ways;
  Eigen::SparseMatrix<double> laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplacian);
  if (solver.info() != Eigen::Success) return ways;
  const Eigen::MatrixX2d solved = solver.solve(right);
  for (std::size_t v = 0; v < known.size(); ++v)
    if (unknown[v] != kNone) ways[v] = {solved(unknown[v], 0), solved(unknown[v], 1)};
  return ways;
}

}  // namespace

std::vector<Vec2> places_before(const HungPiece& before, const mesh::PanelMesh& now,
                                const std::vector<std::string>& edges) {
  const std::vector<Way> border = ways_of_border(before, now, edges);
  std::vector<Vec2> places = now.rest;
  const bool moved = std::any_of(border.begin(), border.end(),
                                 [](const Way& way) { return way && length(*way) > kUnmoved; });
  if (!moved) return places;
  const std::vector<Vec2> ways = filled_in(now, border);
  for (std::size_t v = 0; v < places.size(); ++v) places[v] = places[v] + ways[v];
  return places;
}

}  // namespace toile::warm
