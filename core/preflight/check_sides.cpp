#include "core/preflight/check_sides.h"

#include <algorithm>

#include "core/mesh/sewn_part.h"
#include "core/preflight/check_pattern.h"

namespace toile::preflight {

namespace {

constexpr int kSamples = 48;       ///< triangles of a piece that look out for a body
constexpr double kSight = 1.0;     // m
constexpr double kMajority = 0.8;  ///< of those that see one

/// Distance to the nearest body along a way, kSight when there is none.
double sight(std::span<const BodyProbe> probes, Vec3 from, Vec3 way) {
  double least = kSight;
  for (const BodyProbe& probe : probes) {
    const auto hits = probe.hits(from, from + way * kSight);
    if (!hits.empty()) least = std::min(least, hits.front() * kSight);
  }
  return least;
}

/// 1 when the right side looks away from the bodies, -1 when it looks at them, 0 when that is not clear.
int facing_of(const sewing::Assembly& assembly, std::span<const BodyProbe> probes, Index piece) {
  std::vector<Index> triangles;
  for (Index t = 0; t < static_cast<Index>(assembly.garment.triangles.size()); ++t) {
    if (assembly.garment.panel_of_triangle[t] == piece) triangles.push_back(t);
  }
  int outward = 0, inward = 0;
  const std::size_t stride = std::max<std::size_t>(1, triangles.size() / kSamples);
  for (std::size_t i = 0; i < triangles.size(); i += stride) {
    const auto [a, b, c] = assembly.garment.triangles[triangles[i]];
    const std::vector<Vec3>& x = assembly.positions;
    const Vec3 n = normalized(cross(x[b] - x[a], x[c] - x[a])), middle = (x[a] + x[b] + x[c]) * (1.0 / 3);
    const double before = sight(probes, middle, n), behind = sight(probes, middle, -n);
    outward += behind < before;
    inward += before < behind;
  }
  if (outward + inward == 0) return 0;
  const double share = static_cast<double>(outward) / (outward + inward);
  return share >= kMajority ? 1 : share <= 1 - kMajority ? -1 : 0;
}

/// What seams say about the right sides: pieces of one group are joined, `side` tells which of its two sides.
struct Sides {
  std::vector<Index> group;
  std::vector<int> side;         ///< 1 or -1
  std::vector<Index> one_sided;  ///< seams that contradict the others
};

Sides sides_of(const pattern::Pattern& pattern) {
  const auto count = static_cast<Index>(pattern.panels.size());
  Sides s{std::vector<Index>(count, kNone), std::vector<int>(count, 0), {}};
  for (Index root = 0; root < count; ++root) {
    if (s.group[root] != kNone) continue;
    std::vector<Index> open{root};
    s.group[root] = root;
    s.side[root] = 1;
    while (!open.empty()) {
      const Index p = open.back();
      open.pop_back();
      for (const pattern::Seam& seam : pattern.seams) {
        const Index a = seam.a[0].panel, b = seam.b[0].panel;
        if (a == b || (a != p && b != p)) continue;
        const Index q = a == p ? b : a;
        if (s.group[q] == kNone) {
          s.group[q] = root;
          s.side[q] = s.side[p] * side_sign(seam);
          open.push_back(q);
        }
      }
    }
  }
  for (Index k = 0; k < static_cast<Index>(pattern.seams.size()); ++k) {
    const pattern::Seam& seam = pattern.seams[k];
    const Index a = seam.a[0].panel, b = seam.b[0].panel;
    if (s.side[a] * s.side[b] != side_sign(seam)) s.one_sided.push_back(k);
  }
  return s;
}

Vec3 middle_of(const sewing::Assembly& assembly, Index piece) {
  const sewing::GarmentMesh& g = assembly.garment;
  Vec3 sum;
  for (Index v = g.first_vertex[piece]; v < g.first_vertex[piece + 1]; ++v) sum += assembly.positions[v];
  return sum * (1.0 / std::max<Index>(1, g.first_vertex[piece + 1] - g.first_vertex[piece]));
}

}  // namespace

void check_sides(const PreflightInput& input, std::span<const BodyProbe> probes,
                 const sewing::Assembly& assembly, Findings& findings) {
  const Sides sides = sides_of(input.pattern);
  for (const Index k : sides.one_sided) {
    findings.push_back(
        found(FindingKind::kOneSided,
              "with this seam the right side of the cloth meets its wrong side somewhere, whichever way the "
              "pieces are turned; see to its direction",
              {seam_named(input.pattern.seams[k].id)}, place_of_seam(assembly, k)));
  }
  const auto count = static_cast<Index>(input.pattern.panels.size());
  std::vector<int> facing(count);  // what is closed all around, as a cushion is, has no side for the body
  for (const mesh::SewnPart& part : mesh::sewn_parts(input.meshes))
    for (const Index p : part.panels) facing[p] = !part.borders.empty() ? facing_of(assembly, probes, p) : 0;
  Finding winding =
      found(FindingKind::kWindsOtherWay,
            "outlines that wind the other way than those of the pieces that they are sewn to: the wrong side "
            "of the one comes to lie beside the right side of the other",
            {}, {});
  for (Index p = 0; p < count; ++p) {
    int agree = 0, differ = 0, like = 0, other = 0;
    for (Index q = 0; q < count; ++q) {
      if (sides.group[q] != sides.group[p]) continue;
      (sides.side[q] == sides.side[p] ? like : other) += 1;
      if (facing[p] == 0 || facing[q] == 0) continue;
      (facing[q] * sides.side[q] == facing[p] * sides.side[p] ? agree : differ) += 1;
    }
    const Concern piece = piece_named(input.pattern.panels[p].id);
    const Vec3 place = middle_of(assembly, p);
    if (differ > agree || (differ == agree && differ > 0 && facing[p] < 0)) {
      findings.push_back(found(FindingKind::kInsideOut,
                               std::string("the piece shows its ") + (facing[p] < 0 ? "right" : "wrong") +
                                   " side to the body, unlike what it is sewn to; turn the piece over",
                               {piece}, place));
    } else if (other > like || (other == like && sides.side[p] < 0)) {
      if (winding.about.empty()) winding.place = place;
      winding.about.push_back(piece);
    }
  }
  if (!winding.about.empty()) findings.push_back(std::move(winding));
}

}  // namespace toile::preflight
