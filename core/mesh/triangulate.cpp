#include "core/mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/mesh/grid_triangulation.h"
#include "core/mesh/morton.h"
#include "core/mesh/relax.h"

namespace toile {
namespace {

constexpr double kGrid = 1e-7;      ///< m, step of the integer grid
constexpr double kMargin = 0.5;     ///< particle distances that lattice points keep from the border
constexpr int kRounds = 5;          ///< of adapting points
constexpr int kSmoothings = 6;      ///< in each round
constexpr double kFlatness = 1e-9;  ///< area per squared perimeter under which a piece counts as a line

using Segments = std::vector<std::array<Index, 2>>;

/// The piece on the grid: border points first, then inner ones.
struct GridPiece {
  Vec2 origin;  ///< m, of the grid
  std::vector<GridPoint> points;
  Segments segments;
  Index border = 0;
};

std::string place_name(Vec2 p) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.1f, %.1f) mm", mm_from_metres(p.x), mm_from_metres(p.y));
  return text;
}

GridPoint on_grid(Vec2 p, Vec2 origin) {
  return {std::llround((p.x - origin.x) / kGrid), std::llround((p.y - origin.y) / kGrid)};
}

Vec2 off_grid(const GridPoint& p, Vec2 origin) {
  return {origin.x + static_cast<double>(p.x) * kGrid, origin.y + static_cast<double>(p.y) * kGrid};
}

/// Refuses what has no place on the grid or would need too much memory.
Status check_loops(std::span<const Polygon> loops, double particle_distance) {
  if (loops.empty()) return Error{"mesh.too_few_points", "The piece has no outline.", ""};
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  for (const Polygon& loop : loops) {
    if (loop.size() < 3) {
      return Error{"mesh.too_few_points", "An outline needs three points to enclose anything.", ""};
    }
    for (const Vec2 p : loop) {
      if (!is_finite(p)) return Error{"mesh.not_finite", "An outline has a point that is not a number.", ""};
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  if (std::max(high.x - low.x, high.y - low.y) >= GridTriangulation::kGridExtent * kGrid) {
    return Error{"mesh.piece_too_large", "The piece is larger than 13 m; check the unit of its file.", ""};
  }
  const double particles = particle_estimate(std::fabs(enclosed_area(loops)), particle_distance);
  if (!(particles <= kMaxParticles)) {
    return Error{"mesh.too_many_particles",
                 "The piece would have about " + std::to_string(std::llround(std::min(particles, 1e15))) +
                     " particles; choose a larger particle distance.",
                 ""};
  }
  return {};
}

GridPiece border_on_grid(std::span<const Polygon> loops) {
  GridPiece piece;
  piece.origin = loops[0][0];
  for (const Polygon& loop : loops) {
    for (const Vec2 p : loop) {
      piece.origin = {std::min(piece.origin.x, p.x), std::min(piece.origin.y, p.y)};
    }
  }
  for (const Polygon& loop : loops) {
    const auto first = static_cast<Index>(piece.points.size()), n = static_cast<Index>(loop.size());
    for (Index i = 0; i < n; ++i) {
      piece.points.push_back(on_grid(loop[i], piece.origin));
      piece.segments.push_back({first + i, first + (i + 1) % n});
    }
  }
  piece.border = static_cast<Index>(piece.points.size());
  return piece;
}

Error error_of(const GridConflict& conflict, const GridPiece& piece, std::span<const Polygon> loops) {
  const std::string place = place_name(off_grid(piece.points[conflict.a], piece.origin));
  double perimeter = 0;
  for (const auto& [a, b] : piece.segments) {
    const GridPoint &p = piece.points[a], &q = piece.points[b];
    perimeter += length(Vec2{double(p.x - q.x), double(p.y - q.y)}) * kGrid;
  }
  if (conflict.kind == GridConflict::Kind::kCross) {
    return {"mesh.outline_crosses",
            "The outline, divided by the particle distance, crosses itself near " + place +
                "; mend the outline, or choose a smaller particle distance.",
            ""};
  }
  if (std::fabs(enclosed_area(loops)) <= kFlatness * perimeter * perimeter) {
    return {"mesh.zero_area", "The piece encloses no area; check its outline near " + place + ".", ""};
  }
  if (conflict.kind == GridConflict::Kind::kNotClosed) {
    return {"mesh.outline_winding",
            "The outline must run counter-clockwise, holes clockwise and inside it; see " + place + ".", ""};
  }
  return {"mesh.outline_touches", "The outline touches itself at " + place + "; part it there.", ""};
}

/// Vertices sorted along the Morton curve; triangles start with their least vertex and are sorted.
FlatMesh ordered_mesh(const GridPiece& piece, std::span<const Polygon> loops, std::vector<Tri> triangles) {
  const auto count = static_cast<Index>(piece.points.size());
  const std::vector<Index> order = morton_order(piece.points, count);
  std::vector<Index> rank(count);
  FlatMesh mesh;
  mesh.points.resize(count);
  for (Index i = 0; i < count; ++i) {
    rank[order[i]] = i;
    mesh.points[i] = off_grid(piece.points[order[i]], piece.origin);
  }
  for (const Polygon& loop : loops) {
    for (const Vec2 p : loop) {
      mesh.border.push_back(rank[mesh.border.size()]);
      mesh.points[mesh.border.back()] = p;
    }
  }
  for (Tri& t : triangles) {
    t = {rank[t[0]], rank[t[1]], rank[t[2]]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(triangles.begin(), triangles.end());
  mesh.triangles = std::move(triangles);
  return mesh;
}

void add_lattice(GridPiece& piece, std::span<const Polygon> loops, double particle_distance) {
  for (const Vec2 p : lattice_points(loops, particle_distance, kMargin * particle_distance)) {
    piece.points.push_back(on_grid(p, piece.origin));
  }
}

}  // namespace

double enclosed_area(std::span<const Polygon> loops) {
  double area = 0;
  for (const Polygon& loop : loops) area += signed_area(loop);
  return area;
}

double particle_estimate(double area, double particle_distance) {
  return area / (particle_distance * particle_distance * std::sqrt(0.75));
}

Result<FlatMesh> triangulate(std::span<const Polygon> loops, double particle_distance,
                             const RunContext& context) {
  if (Status status = check_loops(loops, particle_distance); !status) return status.error();
  GridPiece piece = border_on_grid(loops);
  // The border alone first: where it crosses itself, its area says nothing of how many points would fill it.
  if (const auto conflict = GridTriangulation(piece.points).build(piece.segments)) {
    return error_of(*conflict, piece, loops);
  }
  add_lattice(piece, loops, particle_distance);
  const double spacing = particle_distance / kGrid;
  for (int round = 0;; ++round) {
    if (context.cancelled()) return Error{"cancelled", "Meshing was cancelled.", ""};
    GridTriangulation mesh(piece.points);
    if (const auto conflict = mesh.build(piece.segments)) return error_of(*conflict, piece, loops);
    std::vector<Tri> triangles = mesh.inside_triangles();
    const std::vector<double> wanted =
        wanted_lengths(piece.points, triangles, piece.segments, piece.border, spacing);
    const auto count = static_cast<Index>(piece.points.size());
    for (int i = 0; i < kSmoothings; ++i) smooth(mesh, piece.border, count, wanted);
    for (Index v = piece.border; v < count; ++v) piece.points[v] = mesh.point(v);
    triangles = mesh.inside_triangles();
    if (round == kRounds) return ordered_mesh(piece, loops, std::move(triangles));
    const auto inner = adapted_points(piece.points, triangles, piece.segments, piece.border, wanted);
    if (!inner) return ordered_mesh(piece, loops, std::move(triangles));
    piece.points.resize(piece.border);
    piece.points.insert(piece.points.end(), inner->begin(), inner->end());
  }
}

}  // namespace toile
