#include <cmath>

#include "core/base/aabb.h"
#include "core/preflight/check_sides.h"
#include "core/preflight/start_field.h"

namespace toile::preflight {

namespace {

constexpr double kMuchShorter = 0.8;  ///< of the thread's length now
constexpr double kFlat = 0.97;        ///< how much of a piece's area faces one way
constexpr double kClear = 1e-3;       // m

/// The vertices of a piece that are sewn to other pieces, with their partners.
struct Ties {
  std::vector<Index> mine, theirs;
  int seams = 0;
};

Ties ties_of(const sewing::GarmentMesh& g, Index piece) {
  Ties t;
  Index last = kNone;
  for (std::size_t k = 0; k < g.sewn.size(); ++k) {
    const Index p = g.panel_of_vertex[g.sewn[k][0]], q = g.panel_of_vertex[g.sewn[k][1]];
    if ((p == piece) == (q == piece)) continue;
    t.mine.push_back(g.sewn[k][p == piece ? 0 : 1]);
    t.theirs.push_back(g.sewn[k][p == piece ? 1 : 0]);
    t.seams += g.seam_of_sewn[k] != last;
    last = g.seam_of_sewn[k];
  }
  return t;
}

/// A piece's own axes in space: along u, along v, out of the cloth; nothing when it is not flat.
struct Axes {
  Vec3 centre, axis[3];
};

bool axes_of(const sewing::Assembly& assembly, Index piece, Axes& out) {
  const sewing::GarmentMesh& g = assembly.garment;
  Vec3 along_u, facing;
  double area = 0;
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    if (g.panel_of_triangle[t] != piece) continue;
    const auto [a, b, c] = g.triangles[t];
    const Vec3 x1 = assembly.positions[b] - assembly.positions[a],
               x2 = assembly.positions[c] - assembly.positions[a];
    const Vec2 r1 = g.rest[b] - g.rest[a], r2 = g.rest[c] - g.rest[a];
    along_u += x1 * r2.y - x2 * r1.y;  // the gradient along u times twice the area
    const Vec3 n = cross(x1, x2);
    facing += n;
    area += length(n);
  }
  if (length(facing) < kFlat * area || area == 0) return false;
  Aabb3 box;
  for (Index v = g.first_vertex[piece]; v < g.first_vertex[piece + 1]; ++v) box.add(assembly.positions[v]);
  out.centre = box.middle();
  out.axis[2] = normalized(facing);
  out.axis[0] = normalized(along_u - out.axis[2] * dot(along_u, out.axis[2]));
  out.axis[1] = cross(out.axis[2], out.axis[0]);
  return true;
}

/// Half a turn about `axis` through `centre`.
Vec3 half_turn(Vec3 p, Vec3 centre, Vec3 axis) {
  const Vec3 d = p - centre;
  return centre + axis * (2 * dot(d, axis)) - d;
}

struct Turn {
  Index piece = kNone;
  int axis = 0;
  Axes axes;
  double before = 0, after = 0;  ///< m of thread
};

Turn best_turn(const sewing::Assembly& assembly, Index piece) {
  Turn best{piece, 0, {}, 0, 1e9};
  const Ties ties = ties_of(assembly.garment, piece);
  if (ties.seams < 2 || !axes_of(assembly, piece, best.axes)) return {};
  const auto thread = [&](int axis) {
    double sum = 0;
    for (std::size_t i = 0; i < ties.mine.size(); ++i) {
      const Vec3 p = assembly.positions[ties.mine[i]];
      sum += length((axis < 0 ? p : half_turn(p, best.axes.centre, best.axes.axis[axis])) -
                    assembly.positions[ties.theirs[i]]);
    }
    return sum;
  };
  best.before = thread(-1);
  // Top and bottom swapped looks the same as seams sewn upside down: that is left to untwist_seams.
  for (int k = 1; k < 3; ++k) {
    if (const double after = thread(k); after < best.after) {
      best.after = after;
      best.axis = k;
    }
  }
  return best.after < kMuchShorter * best.before ? best : Turn{};
}

void turn(const Turn& t, sewing::Assembly& assembly) {
  const sewing::GarmentMesh& g = assembly.garment;
  constexpr double kGrid = 0x1p26;  // as all starts
  const auto snapped = [](double x) { return std::nearbyint(x * kGrid) / kGrid; };
  for (Index v = g.first_vertex[t.piece]; v < g.first_vertex[t.piece + 1]; ++v) {
    const Vec3 p = half_turn(assembly.positions[v], t.axes.centre, t.axes.axis[t.axis]);
    assembly.positions[v] = {snapped(p.x), snapped(p.y), snapped(p.z)};
  }
}

/// Number of things that the piece is nearer to than a millimetre.
int conflicts_of(const sewing::Assembly& assembly, std::span<const BodyProbe> probes, Index piece) {
  const StartField field(assembly, probes);
  int count = 0;
  for (const Opponent& o : field.neighbours(piece, {}, kClear)) {
    count += field.nearness(piece, {}, o, kClear, kClear).gap < kClear;
  }
  return count;
}

}  // namespace

void turn_pieces(const PreflightInput& input, std::span<const BodyProbe> probes, sewing::Assembly& assembly,
                 Findings& findings) {
  std::vector<bool> seen(input.pattern.panels.size(), false);
  for (std::size_t round = 0; round < input.pattern.panels.size(); ++round) {
    // The piece that gains most is the one that stands wrong; of two that gain alike, the later one.
    Turn worst;
    for (Index p = 0; p < static_cast<Index>(input.pattern.panels.size()); ++p) {
      const Turn t = seen[p] ? Turn{} : best_turn(assembly, p);
      if (t.piece != kNone && t.before - t.after >= worst.before - worst.after - 1e-9) worst = t;
    }
    if (worst.piece == kNone) return;
    seen[worst.piece] = true;
    Finding f = found(FindingKind::kTurned, "", {piece_named(input.pattern.panels[worst.piece].id)},
                      worst.axes.centre);
    f.message = "the piece stands the wrong way round for its seams: its threads measure " +
                length_text(worst.before) + " in all, and " + length_text(worst.after) +
                " after half a turn" + (worst.axis == 2 ? " in its own plane" : " that swaps left and right");
    const int before = conflicts_of(assembly, probes, worst.piece);
    sewing::Assembly turned = assembly;
    turn(worst, turned);
    if (conflicts_of(turned, probes, worst.piece) <= before) {
      assembly = std::move(turned);
      f.repaired = true;
      f.message += ", which was made for this drape";
    } else {
      f.message += "; turn it, clear of the others and the body";
    }
    findings.push_back(std::move(f));
  }
}

}  // namespace toile::preflight
