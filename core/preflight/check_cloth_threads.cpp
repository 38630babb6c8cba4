#include "core/preflight/check_cloth_threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "core/preflight/body_probe.h"
#include "core/preflight/check_threads.h"

namespace toile::preflight {

namespace {

/// m, how far aside a thread is tried.
constexpr double kAsideOfCloth[] = {0.005, 0.01, 0.02, 0.03, 0.045, 0.065, 0.1, 0.15};
constexpr double kNoWayOff = 0.2;
constexpr double kNearEdge = 0.02;  ///< m; what is nearer to an edge slides off it

struct SeamThread {
  Vec3 a, b;
};

/// A piece where it stands, as something to run into.
body::Body body_of_piece(const sewing::Assembly& assembly, Index piece) {
  const sewing::GarmentMesh& g = assembly.garment;
  const Index first = g.first_vertex[piece];
  body::Body body;
  body.mesh.vertices.assign(assembly.positions.begin() + first,
                            assembly.positions.begin() + g.first_vertex[piece + 1]);
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    if (g.panel_of_triangle[t] != piece) continue;
    const Tri& v = g.triangles[t];
    body.mesh.triangles.push_back({v[0] - first, v[1] - first, v[2] - first});
  }
  return body;
}

/// A line exactly along an edge of triangles passes through no triangle's inside, and sheets and threads are
/// often built on the same planes: a twin a tenth of a millimetre aside is asked, too.
bool meets_cloth(const BodyProbe& probe, Vec3 a, Vec3 b) {
  constexpr Vec3 kTwin{1.13e-4, 1.71e-4, 0.93e-4};
  return probe.meets(a, b) || probe.meets(a + kTwin, b + kTwin);
}

struct WayOff {
  double distance = kNoWayOff;  ///< m
  Vec3 way;
};

WayOff way_off(const BodyProbe& probe, const SeamThread& t) {
  const PlaneFrame f = make_plane_frame({}, t.b - t.a);
  WayOff best;
  for (int k = 0; k < kWays; ++k) {
    const double angle = 2 * std::numbers::pi * k / kWays;
    const Vec3 way = f.u * std::cos(angle) + f.v * std::sin(angle);
    for (const double d : kAsideOfCloth) {
      if (d >= best.distance) break;
      if (!meets_cloth(probe, t.a + way * d, t.b + way * d)) best = {d, way};
    }
  }
  return best;
}

/// What there is to say of one seam's threads and one piece that the seam does not join.
std::optional<Finding> look(const std::vector<SeamThread>& threads, const BodyProbe& probe,
                            const std::string& seam, const std::string& piece) {
  std::vector<SeamThread> through;
  for (const SeamThread& t : threads) {
    if (meets_cloth(probe, t.a, t.b)) through.push_back(t);
  }
  if (through.empty()) return std::nullopt;
  WayOff worst{0, {}};
  Vec3 place = (through[0].a + through[0].b) * 0.5;
  const std::size_t looked_at = std::min(kLookedAt, through.size());
  for (std::size_t i = 0; i < looked_at; ++i) {
    const SeamThread& t = through[i * (through.size() - 1) / std::max<std::size_t>(1, looked_at - 1)];
    const WayOff off = way_off(probe, t);
    if (off.distance > worst.distance) {
      worst = off;
      place = (t.a + t.b) * 0.5;
    }
  }
  Finding f = found(FindingKind::kThreadThroughCloth, "", {seam_named(seam), piece_named(piece)}, place);
  f.message = std::to_string(through.size()) + " of " + std::to_string(threads.size()) +
              " threads run through piece " + piece + ", which the seam does not join";
  if (worst.distance <= kNearEdge) {
    f.message += "; they can slide off its edge";
    return f;
  }
  f.severity = Severity::kWarning;
  f.message += ", and it may keep the seam open; move piece " + piece;
  f.message += worst.distance < kNoWayOff
                   ? " by about " + length_text(worst.distance) + " away from " + way_text(worst.way)
                   : std::string(" out of the way");
  return f;
}

/// Radians of the piece's own cloth around each vertex of the flat garment.
std::vector<double> angles_around(const sewing::GarmentMesh& g) {
  std::vector<double> angle(static_cast<std::size_t>(g.vertex_count()), 0);
  for (const Tri& t : g.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Vec2 p = g.rest[t[k]], q = g.rest[t[(k + 1) % 3]] - p, r = g.rest[t[(k + 2) % 3]] - p;
      angle[t[k]] += std::abs(std::atan2(cross(q, r), dot(q, r)));
    }
  }
  return angle;
}

}  // namespace

void check_cloth_threads(const PreflightInput& input, const sewing::Assembly& assembly, Findings& findings) {
  const sewing::GarmentMesh& g = assembly.garment;
  const auto pieces = static_cast<Index>(input.pattern.panels.size());
  std::vector<body::Body> bodies;
  bodies.reserve(input.pattern.panels.size());
  for (Index p = 0; p < pieces; ++p) bodies.push_back(body_of_piece(assembly, p));
  const std::vector<BodyProbe> probes = make_probes(bodies);
  for (Index s = 0; s < static_cast<Index>(input.pattern.seams.size()); ++s) {
    std::vector<SeamThread> threads;
    std::set<Index> joined;
    for (std::size_t k = 0; k < g.sewn.size(); ++k) {
      if (g.seam_of_sewn[k] != s) continue;
      const auto [i, j] = g.sewn[k];
      threads.push_back({assembly.positions[i], assembly.positions[j]});
      joined.insert(g.panel_of_vertex[i]);
      joined.insert(g.panel_of_vertex[j]);
    }
    for (Index p = 0; p < pieces; ++p) {
      if (joined.contains(p)) continue;
      auto finding = look(threads, probes[p], input.pattern.seams[s].id, input.pattern.panels[p].id);
      if (finding) findings.push_back(std::move(*finding));
    }
  }
}

void check_open_rings(const PreflightInput& input, const sewing::Assembly& assembly, Findings& findings) {
  constexpr double kThrough = 0.75 * std::numbers::pi;  // a piece that runs on across has no corner there
  const sewing::GarmentMesh& g = assembly.garment;
  const std::vector<double> angle = angles_around(g);
  // Of every piece, the vertices where its own edge runs on and two others are sewn to each other.
  std::vector<std::set<Index>> across(input.pattern.panels.size());
  std::vector<Vec3> place(input.pattern.panels.size());
  for (std::size_t k = 0; k < g.sewn.size(); ++k) {
    const auto [i, j] = g.sewn[k];
    for (const std::array<Index, 2> pair : {std::array{i, j}, std::array{j, i}}) {
      const Index v = pair[0];
      const Index piece = g.panel_of_vertex[v];
      if (angle[v] < kThrough) continue;
      for (std::size_t m = 0; m < g.sewn.size(); ++m) {
        const auto [p, q] = g.sewn[m];
        if (g.weld[p] != g.weld[v] || p == v || q == v) continue;
        if (g.panel_of_vertex[p] == piece || g.panel_of_vertex[q] == piece) continue;
        if (g.panel_of_vertex[p] == g.panel_of_vertex[q] || angle[p] >= kThrough || angle[q] >= kThrough)
          continue;
        if (across[piece].empty()) place[piece] = assembly.positions[v];
        across[piece].insert(g.seam_of_sewn[m]);
      }
    }
  }
  for (std::size_t p = 0; p < across.size(); ++p) {
    if (across[p].empty()) continue;
    std::string seams;
    for (const Index s : across[p]) seams += (seams.empty() ? "" : ", ") + input.pattern.seams[s].id;
    findings.push_back(
        found(FindingKind::kOnOpenRing,
              "it is sewn on across " + seams +
                  ", open itself when the threads begin to pull; place the pieces so that the threads "
                  "there are short, or it may close last",
              {piece_named(input.pattern.panels[p].id)}, place[p]));
  }
}

}  // namespace toile::preflight
