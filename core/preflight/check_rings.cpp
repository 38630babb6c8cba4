#include "core/preflight/check_rings.h"

#include <algorithm>
#include <set>

#include "core/geometry/convex_hull.h"
#include "core/geometry/polygon2.h"
#include "core/sewing/rings.h"

namespace toile::preflight {

namespace {

/// Less is rounding of two tapes.
constexpr double kTight = 0.01;  // relative
/// A ring slips along the body by so much to where it fits: a neck is placed about the shoulders.
constexpr double kSlip = 0.15, kSlipStep = 0.03;  // m

struct Ring {
  std::vector<Index> vertices;  ///< classes in order
  std::vector<Vec3> points;     ///< m, where the start has them
  double girth = 0;             ///< m, of the cloth
  Concerns pieces;              ///< in order of the pattern
  std::set<Index> panels;
};

/// Flat lengths of the garment's border edges by the classes of their ends.
class BorderLengths {
 public:
  explicit BorderLengths(const sewing::GarmentMesh& g) {
    for (const Tri& t : g.triangles) {
      for (int k = 0; k < 3; ++k) {
        const Index i = t[k], j = t[(k + 1) % 3];
        const Index a = std::min(g.weld[i], g.weld[j]), b = std::max(g.weld[i], g.weld[j]);
        edges_.push_back({a, b, length(g.rest[i] - g.rest[j]), g.panel_of_vertex[i]});
      }
    }
    std::sort(edges_.begin(), edges_.end(), [](const Edge& x, const Edge& y) {
      return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.panel < y.panel;
    });
  }
  struct Edge {
    Index a, b;
    double length;
    Index panel;
  };
  const Edge& between(Index v, Index w) const {
    const Index a = std::min(v, w), b = std::max(v, w);
    return *std::lower_bound(
        edges_.begin(), edges_.end(), std::pair(a, b),
        [](const Edge& e, const auto& key) { return e.a != key.first ? e.a < key.first : e.b < key.second; });
  }

 private:
  std::vector<Edge> edges_;
};

Ring measured(const std::vector<Index>& vertices, const sewing::Assembly& assembly,
              const pattern::Pattern& pattern, const BorderLengths& lengths) {
  Ring ring;
  ring.vertices = vertices;
  std::set<Index> pieces;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& edge = lengths.between(vertices[i], vertices[(i + 1) % vertices.size()]);
    ring.girth += edge.length;
    pieces.insert(edge.panel);
    ring.points.push_back(assembly.positions[vertices[i]]);
  }
  for (const Index p : pieces) ring.pieces.push_back(piece_named(pattern.panels[p].id));
  if (pieces.size() < 2) ring.vertices.clear();
  ring.panels = std::move(pieces);
  return ring;
}

/// Newell's normal of a closed line, not of unit length.
Vec3 normal_of(const std::vector<Vec3>& points, Vec3 middle) {
  Vec3 n;
  for (std::size_t i = 0; i < points.size(); ++i) {
    n += cross(points[i] - middle, points[(i + 1) % points.size()] - middle);
  }
  return n;
}

/// The tape around the parts of all bodies that go through the ring, m; 0 when none does.
double girth_within(std::span<const BodyProbe> probes, const PlaneFrame& plane,
                    const std::vector<Vec2>& outline) {
  double widest = 0;
  for (const BodyProbe& probe : probes) {
    std::vector<Vec2> points;
    for (const SlicePart& part : slice_parts(probe.cutter(), plane)) {
      if (geometry::contains(outline, part.centre))
        points.insert(points.end(), part.points.begin(), part.points.end());
    }
    widest = std::max(widest, geometry::hull_perimeter(std::move(points)));
  }
  return widest;
}

/// How far along its axis (m, either way) the ring finds a place where it fits; nothing within kSlip.
std::optional<double> slip_to_fit(const Ring& ring, std::span<const BodyProbe> probes, PlaneFrame plane,
                                  const std::vector<Vec2>& outline) {
  const Vec3 middle = plane.origin;
  for (double slip = kSlipStep; slip <= kSlip; slip += kSlipStep) {
    for (const double along : {slip, -slip}) {
      plane.origin = middle + plane.normal * along;
      const double girth = girth_within(probes, plane, outline);
      if (girth > 0 && girth * (1 - kTight) <= ring.girth) return slip;
    }
  }
  return std::nullopt;
}

/// The plane that a ring lies in about, and its outline there; none where it is too narrow to have one.
struct FlatRing {
  Vec3 middle;
  PlaneFrame plane;
  std::vector<Vec2> outline;
};

std::optional<FlatRing> flattened(const Ring& ring) {
  Vec3 middle;
  for (const Vec3& p : ring.points) middle += p;
  middle = middle * (1.0 / static_cast<double>(ring.points.size()));
  const Vec3 normal = normal_of(ring.points, middle);
  if (!(length(normal) > 1e-6)) return std::nullopt;
  FlatRing flat{middle, make_plane_frame(middle, normal), {}};
  for (const Vec3& p : ring.points) flat.outline.push_back(flat.plane.flat(p));
  return flat;
}

std::optional<Finding> judged(const Ring& ring, std::span<const BodyProbe> probes) {
  const std::optional<FlatRing> flat = flattened(ring);
  if (!flat) return std::nullopt;
  const auto& [middle, plane, outline] = *flat;
  const double girth = girth_within(probes, plane, outline);
  const std::string cloth = "the ring of " + length_text(ring.girth) + " that is sewn here ";
  Finding f =
      found(FindingKind::kRingAroundNothing, cloth + "goes around no part of a body", ring.pieces, middle);
  if (girth == 0) return f;
  if (ring.girth >= (1 - kTight) * girth) return std::nullopt;
  f.kind = FindingKind::kTightRing;
  f.message = cloth + "is " + length_text(girth - ring.girth) + " less than the body's girth of " +
              length_text(girth);
  if (const auto slip = slip_to_fit(ring, probes, plane, outline)) {
    f.message += " where it is placed, but fits " + length_text(*slip) + " further along";
  } else {
    f.severity = Severity::kWarning;
    f.message += " (negative ease): it stretches, or its seams stay open";
  }
  return f;
}

/// The middle of what of a body goes through the ring, m, and how tall and where in the middle that body is.
struct Enclosed {
  Vec3 centre;
  double height = 0, middle = 0;
};

std::optional<Enclosed> enclosed_by(const Ring& ring, std::span<const BodyProbe> probes) {
  const std::optional<FlatRing> flat = flattened(ring);
  if (!flat) return std::nullopt;
  const auto& [middle, plane, outline] = *flat;
  for (const BodyProbe& probe : probes) {
    for (const SlicePart& part : slice_parts(probe.cutter(), plane)) {
      if (!geometry::contains(outline, part.centre)) continue;
      return Enclosed{plane.lifted(part.centre), probe.height(), probe.box().middle().x};
    }
  }
  return std::nullopt;
}

/// Two hems, cuffs or armholes that are alike belong on limbs that mirror each other: not both on one side of
/// the body, and not at heights as far apart as an arm and a leg.
bool on_unlike_limbs(const Enclosed& a, const Enclosed& b) {
  constexpr double kBeside = 0.02, kApart = 0.25;  // of the height
  const double xa = a.centre.x - a.middle, xb = b.centre.x - b.middle;
  const bool one_side = xa * xb > 0 && std::min(std::abs(xa), std::abs(xb)) > kBeside * a.height;
  return one_side || std::abs(a.centre.y - b.centre.y) > kApart * a.height;
}

bool are_alike(const Ring& a, const Ring& b) {
  constexpr double kAlike = 0.02;
  return a.panels.size() == b.panels.size() && std::abs(a.girth - b.girth) <= kAlike * a.girth &&
         std::none_of(a.panels.begin(), a.panels.end(), [&](Index p) { return b.panels.contains(p); });
}

/// Of rings that are alike, each needs one that makes a pair with it.
void check_limbs(const std::vector<Ring>& rings, std::span<const BodyProbe> probes, Findings& findings) {
  std::vector<std::optional<Enclosed>> inside;
  for (const Ring& ring : rings) {
    const bool has_twin =
        std::any_of(rings.begin(), rings.end(), [&](const Ring& r) { return are_alike(r, ring); });
    inside.push_back(has_twin ? enclosed_by(ring, probes) : std::nullopt);
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Enclosed* other = nullptr;
    bool paired = false;
    for (std::size_t j = 0; j < rings.size() && inside[i]; ++j) {
      if (!inside[j] || !are_alike(rings[i], rings[j])) continue;
      paired |= !on_unlike_limbs(*inside[i], *inside[j]);
      if (!other) other = &*inside[j];
    }
    if (paired || !other) continue;
    findings.push_back(found(FindingKind::kRingOnWrongLimb,
                             "this ring of " + length_text(rings[i].girth) +
                                 " and one that is like it go around limbs that are no pair, the other " +
                                 place_text(other->centre) +
                                 "; move the pieces of one to the other side of the body",
                             rings[i].pieces, inside[i]->centre));
  }
}

}  // namespace

void check_rings(const PreflightInput& input, std::span<const BodyProbe> probes,
                 const sewing::Assembly& assembly, Findings& findings) {
  if (probes.empty() || assembly.garment.sewn.empty()) return;
  const BorderLengths lengths(assembly.garment);
  std::vector<Ring> rings;
  for (const auto& vertices : sewing::rings_of(assembly.garment)) {
    Ring ring = measured(vertices, assembly, input.pattern, lengths);
    if (ring.vertices.empty()) continue;
    if (auto finding = judged(ring, probes)) findings.push_back(std::move(*finding));
    rings.push_back(std::move(ring));
  }
  check_limbs(rings, probes, findings);
}

}  // namespace toile::preflight
