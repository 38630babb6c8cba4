#include "core/sewing/folded_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/units.h"

namespace toile::sewing {
namespace {

constexpr double kTurnedOver = 0.75 * kPi;  // from here on a crease begins folded
constexpr double kOnCrease = 1e-9;          // m
constexpr double kStep = 1e-3;              // m, by which the piece's frame is felt for

/// The lines of a crease as pieces of straight line, vertices of the mesh.
std::vector<std::array<Index, 2>> links_of(const mesh::PanelMesh& mesh, const Crease& crease) {
  std::vector<std::array<Index, 2>> links;
  for (const Index line : crease.lines) {
    const std::vector<Index>& chain = mesh.line_vertices[line];
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) links.push_back({chain[i], chain[i + 1]});
  }
  return links;
}

/// The two parts beyond the links, the smaller one first; empty unless they part the mesh in two.
struct Parts {
  std::vector<Tri> smaller, larger;
};

Parts parts_of(const mesh::PanelMesh& mesh, const std::vector<std::array<Index, 2>>& links) {
  std::map<std::pair<Index, Index>, Index> edges;  // to the first triangle; links to none
  for (const auto& [a, b] : links) edges.emplace(std::minmax(a, b), kNone);
  DisjointSets parts(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      const auto [at, fresh] = edges.emplace(std::minmax(a, b), static_cast<Index>(t));
      if (!fresh && at->second != kNone) parts.join(at->second, static_cast<Index>(t));
    }
  }
  std::map<Index, double> areas;
  const auto part_of = [&](std::size_t t) { return parts.root(static_cast<Index>(t)); };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    areas[part_of(t)] += std::abs(cross(mesh.rest[b] - mesh.rest[a], mesh.rest[c] - mesh.rest[a]));
  }
  if (areas.size() != 2) return {};
  const bool first = areas.begin()->second < areas.rbegin()->second;
  const Index smaller = first ? areas.begin()->first : areas.rbegin()->first;
  Parts out;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    (part_of(t) == smaller ? out.smaller : out.larger).push_back(mesh.triangles[t]);
  return out;
}

/// The triangles' vertices, rising, but for those along which they are turned.
std::vector<Index> beyond(const std::vector<Tri>& part, const std::vector<Index>& along) {
  std::set<Index> vertices;
  for (const Tri& t : part) vertices.insert(t.begin(), t.end());
  for (const Index v : along) vertices.erase(v);
  return {vertices.begin(), vertices.end()};
}

/// The vertices of edges that follow one another; empty where they do not.
std::vector<Index> row_of(const mesh::PanelMesh& mesh, const std::vector<Index>& edges) {
  std::vector<Index> row;
  for (const Index e : edges) {
    const std::vector<Index>& next = mesh.edge_vertices[e];
    if (!row.empty() && row.back() != next.front()) return {};
    row.insert(row.end(), next.begin() + (row.empty() ? 0 : 1), next.end());
  }
  return row;
}

Vec2 nearest_on(const mesh::PanelMesh& mesh, const std::vector<std::array<Index, 2>>& links, Vec2 p) {
  Vec2 best;
  double least = std::numeric_limits<double>::max();
  for (const auto& [i, j] : links) {
    const Vec2 a = mesh.rest[i], way = mesh.rest[j] - a;
    const double t = std::clamp(dot(p - a, way) / std::max(1e-30, dot(way, way)), 0.0, 1.0);
    const Vec2 q = a + way * t;
    if (length(p - q) >= least) continue;
    least = length(p - q);
    best = q;
  }
  return best;
}

/// The point turned about the crease, in space; where it comes to tells which way the right side faces there.
Vec3 turned(Vec2 from, Vec2 about, double angle, const Placement& placement) {
  const Vec2 arm = from - about, flat = about + arm * std::cos(angle);
  const std::vector<Vec3> p = place({flat, flat + Vec2{kStep, 0}, flat + Vec2{0, kStep}}, placement);
  const Vec3 right = normalized(cross(p[1] - p[0], p[2] - p[0]));
  return p[0] - right * (length(arm) * std::sin(angle));
}

/// What of the piece is pressed back once the garment is on: all beyond its edges, or beyond a line what
/// hangs free and is larger than what is sewn.
std::vector<PressedBack> pressed_later(const mesh::PanelMesh& mesh, const Crease& crease, const Parts& parts,
                                       const std::vector<bool>& sewn) {
  if (crease.lines.empty()) {
    const std::vector<Index> along = row_of(mesh, crease.edges);
    if (along.empty()) return {};
    return {{along, beyond(mesh.triangles, along), crease.angle < 0}};
  }
  if (crease.lines.size() > 1 || parts.larger.empty()) return {};
  const std::vector<Index>& along = mesh.line_vertices[crease.lines.front()];
  const auto held = [&](const std::vector<Index>& part) {
    return std::any_of(part.begin(), part.end(), [&](Index v) { return sewn[v]; });
  };
  std::vector<Index> fall = beyond(parts.larger, along);
  if (!held(beyond(parts.smaller, along)) || held(fall)) return {};
  return {{along, std::move(fall), crease.angle < 0}};
}

}  // namespace

PlacedPiece placed_folded(const mesh::PanelMesh& mesh, const Placement& placement,
                          const std::vector<Crease>& of_panel, const std::vector<bool>& sewn) {
  PlacedPiece placed{place(mesh.rest, placement), {}, {}};
  const auto sharp = [](const Crease& c) { return std::abs(c.angle) >= kTurnedOver; };
  if (std::count_if(of_panel.begin(), of_panel.end(), sharp) != 1) return placed;
  const Crease& crease = *std::find_if(of_panel.begin(), of_panel.end(), sharp);
  const std::vector<std::array<Index, 2>> links = links_of(mesh, crease);
  const Parts parts = parts_of(mesh, links);
  placed.pressed_back = pressed_later(mesh, crease, parts, sewn);
  if (!placed.pressed_back.empty()) return placed;
  for (const Tri& t : parts.smaller) {
    for (const Index v : t) {
      const Vec2 about = nearest_on(mesh, links, mesh.rest[v]);
      if (length(mesh.rest[v] - about) < kOnCrease) continue;
      placed.positions[v] = turned(mesh.rest[v], about, crease.angle, placement);
    }
  }
  if (!parts.smaller.empty()) placed.turned = links;
  return placed;
}

}  // namespace toile::sewing
