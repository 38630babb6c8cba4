#include "core/mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/base/aabb.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/mesh/grid_triangulation.h"
#include "core/mesh/morton.h"
#include "core/mesh/relax.h"

namespace toile::mesh {
namespace {

constexpr double kGrid = 1e-7;      ///< m, step of the integer grid
constexpr double kMargin = 0.5;     ///< particle distances that lattice points keep from the border
constexpr int kRounds = 5;          ///< of adapting points
constexpr int kSmoothings = 6;      ///< in each round
constexpr double kFlatness = 1e-9;  ///< area per squared perimeter under which a piece counts as a line

using Segments = std::vector<std::array<Index, 2>>;

/// The piece on the grid: border points first, then those of lines, then inner ones.
struct GridPiece {
  Vec2 origin;  ///< m, of the grid
  std::vector<GridPoint> points;
  Segments segments;  ///< of the border
  Segments links;     ///< of the lines
  std::vector<std::vector<Index>> lines;
  Index border = 0;  ///< points of the border
  Index fixed = 0;   ///< points that stay where they are: the border's and the lines'

  Segments all_segments() const {
    Segments all = segments;
    all.insert(all.end(), links.begin(), links.end());
    return all;
  }
};

std::string place_name(Vec2 p) {
  return "(" + fixed_text(mm_from_metres(p.x), 1) + ", " + fixed_text(mm_from_metres(p.y), 1) + ") mm";
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
  Aabb2 box;
  for (const Polygon& loop : loops) {
    if (loop.size() < 3) {
      return Error{"mesh.too_few_points", "An outline needs three points to enclose anything.", ""};
    }
    for (const Vec2 p : loop) {
      if (!is_finite(p)) return Error{"mesh.not_finite", "An outline has a point that is not a number.", ""};
      box.add(p);
    }
  }
  if (std::max(box.size().x, box.size().y) >= GridTriangulation::kGridExtent * kGrid) {
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
    for (const Vec2 p : loop) piece.origin = least_of(piece.origin, p);
  }
  for (const Polygon& loop : loops) {
    const auto first = static_cast<Index>(piece.points.size()), n = static_cast<Index>(loop.size());
    for (Index i = 0; i < n; ++i) {
      piece.points.push_back(on_grid(loop[i], piece.origin));
      piece.segments.push_back({first + i, first + (i + 1) % n});
    }
  }
  piece.border = piece.fixed = static_cast<Index>(piece.points.size());
  return piece;
}

void add_lines(GridPiece& piece, std::span<const std::vector<Vec2>> lines) {
  std::map<std::pair<std::int64_t, std::int64_t>, Index> known;
  for (Index i = 0; i < piece.border; ++i) known.emplace(std::pair(piece.points[i].x, piece.points[i].y), i);
  const auto index_of = [&](const GridPoint& p) {
    const auto next = static_cast<Index>(piece.points.size());
    const auto [found, fresh] = known.emplace(std::pair(p.x, p.y), next);
    if (fresh) piece.points.push_back(p);
    return found->second;
  };
  for (const std::vector<Vec2>& line : lines) {
    std::vector<Index>& vertices = piece.lines.emplace_back();
    for (const Vec2 p : line) vertices.push_back(index_of(on_grid(p, piece.origin)));
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      piece.links.push_back({vertices[i], vertices[i + 1]});
    }
  }
  piece.fixed = static_cast<Index>(piece.points.size());
}

/// Refuses lines with points that have no place on the grid.
Status check_lines(const GridPiece& piece, std::span<const std::vector<Vec2>> lines) {
  const auto inside = [](std::int64_t i) { return i >= 0 && i <= GridTriangulation::kGridExtent; };
  for (const std::vector<Vec2>& line : lines) {
    for (const Vec2 p : line) {
      if (!is_finite(p)) return Error{"mesh.not_finite", "A line has a point that is not a number.", ""};
      const Vec2 steps = (p - piece.origin) * (1 / kGrid);
      const bool fits = std::abs(steps.x) < 1e15 && std::abs(steps.y) < 1e15;
      const GridPoint g = fits ? on_grid(p, piece.origin) : GridPoint{-1, -1};
      if (inside(g.x) && inside(g.y)) continue;
      return Error{"mesh.line", "The line leaves the piece at " + place_name(p) + "; keep it inside.", ""};
    }
  }
  return {};
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

Error line_error(const GridConflict& conflict, const GridPiece& piece) {
  const std::string place = place_name(off_grid(piece.points[conflict.a], piece.origin));
  const bool outside = conflict.kind == GridConflict::Kind::kOutside;
  return {"mesh.line",
          outside ? "A line lies outside the piece near " + place + "; keep it inside."
                  : "A line meets the outline or another line near " + place +
                        " other than in a common point; part them, or let one end on the other.",
          ""};
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
  for (const std::vector<Index>& line : piece.lines) {
    std::vector<Index>& vertices = mesh.lines.emplace_back();
    for (const Index v : line) vertices.push_back(rank[v]);
  }
  for (Tri& t : triangles) {
    t = {rank[t[0]], rank[t[1]], rank[t[2]]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(triangles.begin(), triangles.end());
  mesh.triangles = std::move(triangles);
  return mesh;
}

void add_lattice(GridPiece& piece, std::span<const Polygon> loops, double particle_distance,
                 std::span<const std::vector<Vec2>> lines) {
  for (const Vec2 p : lattice_points(loops, particle_distance, kMargin * particle_distance, lines)) {
    piece.points.push_back(on_grid(p, piece.origin));
  }
}

}  // namespace

double enclosed_area(std::span<const Polygon> loops) {
  double area = 0;
  for (const Polygon& loop : loops) area += geometry::signed_area(loop);
  return area;
}

double particle_estimate(double area, double particle_distance) {
  return area / (particle_distance * particle_distance * std::sqrt(0.75));
}

Result<FlatMesh> triangulate(std::span<const Polygon> loops, double particle_distance,
                             const RunContext& context, std::span<const std::vector<Vec2>> lines) {
  TRY(check_loops(loops, particle_distance));
  GridPiece piece = border_on_grid(loops);
  // The border alone first: where it crosses itself, its area says nothing of how many points would fill it.
  if (const auto conflict = GridTriangulation(piece.points).build(piece.segments)) {
    return error_of(*conflict, piece, loops);
  }
  TRY(check_lines(piece, lines));
  add_lines(piece, lines);
  if (!piece.links.empty()) {
    if (const auto conflict = GridTriangulation(piece.points).build(piece.segments, piece.links)) {
      return line_error(*conflict, piece);
    }
  }
  const Segments all_segments = piece.all_segments();
  add_lattice(piece, loops, particle_distance, lines);
  const double spacing = particle_distance / kGrid;
  for (int round = 0;; ++round) {
    if (context.cancelled()) return Error{"cancelled", "Meshing was cancelled.", "", ErrorKind::kCancelled};
    GridTriangulation mesh(piece.points);
    if (const auto conflict = mesh.build(piece.segments, piece.links)) {
      return error_of(*conflict, piece, loops);
    }
    std::vector<Tri> triangles = mesh.inside_triangles();
    const std::vector<double> wanted =
        wanted_lengths(piece.points, triangles, all_segments, piece.fixed, spacing);
    const auto count = static_cast<Index>(piece.points.size());
    for (int i = 0; i < kSmoothings; ++i) smooth(mesh, piece.fixed, count, wanted);
    for (Index v = piece.fixed; v < count; ++v) piece.points[v] = mesh.point(v);
    triangles = mesh.inside_triangles();
    if (round == kRounds) return ordered_mesh(piece, loops, std::move(triangles));
    const auto inner = adapted_points(piece.points, triangles, all_segments, piece.fixed, wanted);
    if (!inner) return ordered_mesh(piece, loops, std::move(triangles));
    piece.points.resize(piece.fixed);
    piece.points.insert(piece.points.end(), inner->begin(), inner->end());
  }
}

}  // namespace toile::mesh
