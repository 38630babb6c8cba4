#include "core/body/mesh_import/repair.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/aabb.h"
#include "core/body/mesh_import/fill_holes.h"
#include "core/body/mesh_import/half_edges.h"

namespace toile::mesh_import {
namespace {

constexpr double kWeld = 2e-5;       // of the diagonal
constexpr double kHole = 0.35;       // of a shell's diagonal
constexpr double kFlatShell = 0.01;  // of area^1.5: an open shell with less volume than this has no outside
constexpr std::size_t kMostHollows = 64;  // shells looked at for lying within others

/// The vertices of borders, by x.
std::vector<Index> border_vertices(const geometry::TriangleMesh& mesh, const HalfEdges& edges) {
  std::vector<Index> out;
  for (Index h = 0; h < static_cast<Index>(edges.mate.size()); ++h) {
    if (edges.mate[h] == kNone) {
      out.push_back(start_of(mesh, h));
      out.push_back(end_of(mesh, h));
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  // By x, so that a point looks only at those up to its reach farther along; equal ones by number.
  std::stable_sort(out.begin(), out.end(),
                   [&](Index a, Index b) { return mesh.vertices[a].x < mesh.vertices[b].x; });
  return out;
}

/// Lays each border point on the first one within reach; how many.
int weld_borders(geometry::TriangleMesh& mesh) {
  const std::vector<Index> border = border_vertices(mesh, pair_half_edges(mesh));
  if (border.empty()) return 0;
  const double reach = kWeld * length(bounding_box(mesh.vertices).size());
  std::vector<Index> onto(mesh.vertices.size());
  std::iota(onto.begin(), onto.end(), 0);
  int welded = 0;
  for (std::size_t i = 0; i < border.size(); ++i) {
    if (onto[border[i]] != border[i]) continue;
    for (std::size_t j = i + 1; j < border.size(); ++j) {
      const Vec3 way = mesh.vertices[border[j]] - mesh.vertices[border[i]];
      if (way.x > reach) break;
      if (onto[border[j]] == border[j] && length(way) <= reach) {
        onto[border[j]] = border[i];
        ++welded;
      }
    }
  }
  if (welded == 0) return 0;
  for (Tri& t : mesh.triangles) {
    for (Index& v : t) v = onto[v];
  }
  return welded;
}

/// Keeps the triangles for which `keep` holds; how many went.
template <typename Keep>
int drop_triangles(geometry::TriangleMesh& mesh, Keep keep) {
  std::vector<Tri> kept;
  kept.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (keep(t)) kept.push_back(mesh.triangles[t]);
  }
  const auto gone = static_cast<int>(mesh.triangles.size() - kept.size());
  if (gone > 0) mesh.triangles = std::move(kept);
  return gone;
}

int drop_flat(geometry::TriangleMesh& mesh) {
  return drop_triangles(mesh, [&](std::size_t i) {
    const Tri& t = mesh.triangles[i];
    const Vec3 a = mesh.vertices[t[0]];
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] &&
           length(cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a)) > kLeastArea2;
  });
}

/// Of triangles with the same corners, whichever way they run, the first one stays.
int drop_doubled(geometry::TriangleMesh& mesh) {
  std::vector<std::pair<Tri, Index>> sorted;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Tri corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, static_cast<Index>(t));
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> again(mesh.triangles.size(), false);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) again[sorted[i].second] = true;
  }
  return drop_triangles(mesh, [&](std::size_t t) { return !again[t]; });
}

void drop_unused(geometry::TriangleMesh& mesh) {
  std::vector<Index> number(mesh.vertices.size(), kNone);
  for (const Tri& t : mesh.triangles) {
    for (const Index v : t) number[v] = 0;
  }
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    number[v] = static_cast<Index>(kept.size());
    kept.push_back(mesh.vertices[v]);
  }
  mesh.vertices = std::move(kept);
  for (Tri& t : mesh.triangles) {
    for (Index& v : t) v = number[v];
  }
}

void turn_over(Tri& t) { std::swap(t[1], t[2]); }

/// A shell's sums, about its own middle.
struct ShellMass {
  double area = 0, volume = 0;  ///< m², m³; negative when the inner side is outside
  Vec3 middle;                  ///< of the area
  Aabb3 box;                    ///< m
  Index vertex = kNone;         ///< one of its own
};

std::vector<ShellMass> masses_of(const geometry::TriangleMesh& mesh, const MeshShells& shells) {
  std::vector<ShellMass> out(shells.count);
  const auto corner = [&](const Tri& t, int c) { return mesh.vertices[t[c]]; };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Tri& t = mesh.triangles[i];
    ShellMass& s = out[shells.shell_of[i]];
    // About the shell's own middle: far from the origin a volume would lose its digits in cancellation.
    const double area = 0.5 * length(cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)));
    s.area += area;
    s.middle += (corner(t, 0) + corner(t, 1) + corner(t, 2)) * (area / 3);
    s.vertex = t[0];
    for (const Index v : t) s.box.add(mesh.vertices[v]);
  }
  for (ShellMass& s : out) s.middle = s.middle * (1 / s.area);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Tri& t = mesh.triangles[i];
    ShellMass& s = out[shells.shell_of[i]];
    s.volume += dot(corner(t, 0) - s.middle, cross(corner(t, 1) - s.middle, corner(t, 2) - s.middle)) / 6;
  }
  return out;
}

/// How often a closed shell winds around a point.
double winding(const geometry::TriangleMesh& mesh, const MeshShells& shells, Index shell, Vec3 p) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (shells.shell_of[i] != shell) continue;
    const Tri& t = mesh.triangles[i];
    const Vec3 a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p, c = mesh.vertices[t[2]] - p;
    const double la = length(a), lb = length(b), lc = length(c);
    sum += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  constexpr double kTwoPi = 6.283185307179586;
  return sum / kTwoPi;  // atan2 gives half of each solid angle
}

/// Whether a shell that is turned inward is the wall of a hollow: it lies within a closed one that is not.
bool is_hollow(const geometry::TriangleMesh& mesh, const MeshShells& shells,
               const std::vector<ShellMass>& masses, const std::vector<bool>& open, Index shell) {
  for (Index outer = 0; outer < shells.count; ++outer) {
    if (outer == shell || open[outer] || masses[outer].volume <= 0) continue;
    if (!masses[outer].box.contains(masses[shell].box)) continue;
    if (winding(mesh, shells, outer, mesh.vertices[masses[shell].vertex]) > 0.5) return true;
  }
  return false;
}

/// Which shells must be turned over whole, so that their outer side is outside.
std::vector<bool> inside_out(const geometry::TriangleMesh& mesh, const MeshShells& shells,
                             const std::vector<bool>& open) {
  const std::vector<ShellMass> masses = masses_of(mesh, shells);
  std::vector<bool> out(shells.count, false);
  std::size_t looked_at = 0;
  for (Index s = 0; s < shells.count; ++s) {
    if (shells.one_sided[s] || masses[s].volume >= 0) continue;
    if (open[s]) {
      out[s] = -masses[s].volume > kFlatShell * masses[s].area * std::sqrt(masses[s].area);
    } else {
      out[s] = ++looked_at > kMostHollows || !is_hollow(mesh, shells, masses, open, s);
    }
  }
  return out;
}

std::vector<bool> open_shells(const HalfEdges& edges, const MeshShells& shells) {
  std::vector<bool> open(shells.count, false);
  for (Index h = 0; h < static_cast<Index>(edges.mate.size()); ++h) {
    if (edges.mate[h] == kNone) open[shells.shell_of[triangle_of(h)]] = true;
  }
  return open;
}

/// Turns every shell outward; how many of the triangles end up otherwise than they came, given who was turned
/// before. New triangles, at the end, count for none.
int turn_outward(geometry::TriangleMesh& mesh, const std::vector<bool>& turned_before, MeshRepairs& repairs) {
  const HalfEdges edges = pair_half_edges(mesh);
  const MeshShells shells = find_shells(mesh, edges);
  const std::vector<bool> open = open_shells(edges, shells);
  const std::vector<bool> turn = inside_out(mesh, shells, open);
  int turned = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool now = turn[shells.shell_of[t]];
    if (now) turn_over(mesh.triangles[t]);
    if (t < turned_before.size()) turned += now != turned_before[t];
  }
  repairs.shells = shells.count;
  repairs.open_shells = static_cast<int>(std::count(open.begin(), open.end(), true));
  repairs.one_sided = static_cast<int>(std::count(shells.one_sided.begin(), shells.one_sided.end(), true));
  return turned;
}

std::string counted(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

bool repaired(const MeshRepairs& r) {
  return r.welded + r.flat + r.doubled + r.crowded_edges + r.parted_points + r.turned + r.holes > 0;
}

std::vector<std::string> repair_words(const MeshRepairs& r) {
  std::vector<std::string> out;
  const auto say = [&out](int count, std::string sentence) {
    if (count > 0) out.push_back(std::move(sentence));
  };
  say(r.welded,
      counted(r.welded, "border point was", "border points were") + " joined to others in the same place.");
  say(r.flat, counted(r.flat, "triangle without area was", "triangles without area were") + " dropped.");
  say(r.doubled, counted(r.doubled, "triangle that lay on another was", "triangles that lay on others were") +
                     " dropped.");
  say(r.crowded_edges, counted(r.crowded_edges, "edge", "edges") +
                           " with more than two triangles: the surfaces were parted there.");
  say(r.parted_points, counted(r.parted_points, "point was", "points were") +
                           " made where surfaces touched in a point or an edge only.");
  say(r.turned, counted(r.turned, "triangle was", "triangles were") + " turned over, to look outward.");
  say(r.holes, counted(r.holes, "small hole was", "small holes were") + " filled with " +
                   counted(r.hole_triangles, "triangle.", "triangles."));
  say(r.open_borders, "The surface stays open: " + counted(r.open_borders, "border is", "borders are") +
                          " too long for a hole; cloth may get inside.");
  say(r.one_sided, counted(r.one_sided, "part has", "parts have") + " no outer side, as a twisted strip.");
  say(r.shells > 1 ? r.shells : 0, "The mesh is made of " + std::to_string(r.shells) + " separate surfaces.");
  return out;
}

RepairedMesh repair_mesh(geometry::TriangleMesh mesh) {
  MeshRepairs repairs;
  // In this order: borders can be told only without empty triangles, sides only once borders are joined,
  // holes filled only where triangles run alike, and outside is known last, when what can be closed is
  // closed.
  repairs.flat = drop_flat(mesh);
  repairs.welded = weld_borders(mesh);
  if (repairs.welded > 0) repairs.flat += drop_flat(mesh);
  repairs.doubled = drop_doubled(mesh);
  if (repairs.welded + repairs.flat + repairs.doubled > 0) drop_unused(mesh);

  HalfEdges edges = pair_half_edges(mesh);
  repairs.crowded_edges = edges.crowded;
  MeshShells shells = find_shells(mesh, edges);
  repairs.parted_points = split_fans(mesh, edges, shells);
  const std::vector<bool> turned = shells.turned;
  if (std::find(turned.begin(), turned.end(), true) != turned.end()) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (turned[t]) turn_over(mesh.triangles[t]);
    }
    edges = pair_half_edges(mesh);
    shells = find_shells(mesh, edges);
  }
  const FilledHoles holes = fill_holes(mesh, edges, shells, kHole);
  repairs.holes = holes.filled;
  repairs.hole_triangles = holes.triangles;
  repairs.open_borders = holes.left;
  repairs.turned = turn_outward(mesh, turned, repairs);
  return {std::move(mesh), repairs};
}

}  // namespace toile::mesh_import
