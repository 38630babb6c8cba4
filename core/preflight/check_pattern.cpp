#include "core/preflight/check_pattern.h"

#include <algorithm>
#include <cmath>

#include "core/base/aabb.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/pattern/curve.h"

namespace toile::preflight {

namespace {

constexpr double kEased = 1.02, kGathered = 1.5;
constexpr double kShortestEdge = 0.5;  ///< particle distances
/// Largest piece against the height of the largest body: beyond these it is no garment for it.
constexpr double kHuge = 3, kTiny = 0.03;
constexpr double kLikeFactor = 0.06;  ///< relative; a ratio that near to a factor between units is one
constexpr double kFarAway = 1.5;      ///< body heights from the bodies' boxes, beside 1 m

struct UnitSlip {
  double factor;
  const char* words;
};
/// What lengths are wrong by when a file's unit is taken for another.
constexpr UnitSlip kSlips[] = {
    {10, "centimetres taken for millimetres"}, {25.4, "inches taken for millimetres"},
    {2.54, "inches taken for centimetres"},    {39.37, "metres taken for inches"},
    {1000, "metres taken for millimetres"},    {100, "metres taken for centimetres"}};

std::string ratio_text(double ratio) { return fixed_text(ratio, ratio < 10 ? 2 : 1); }

const UnitSlip* slip_like(double ratio) {
  for (const UnitSlip& slip : kSlips) {
    if (std::abs(ratio / slip.factor - 1) < kLikeFactor) return &slip;
  }
  return nullptr;
}

Vec3 centre_of(const sewing::Assembly& assembly, Index panel) {
  const sewing::GarmentMesh& g = assembly.garment;
  Vec3 sum;
  for (Index v = g.first_vertex[panel]; v < g.first_vertex[panel + 1]; ++v) sum += assembly.positions[v];
  return sum * (1.0 / std::max<Index>(1, g.first_vertex[panel + 1] - g.first_vertex[panel]));
}

/// The longer side of the flat piece's box, m.
double extent_of(const mesh::PanelMesh& mesh) {
  const Vec2 size = bounding_box(mesh.rest).size();
  return std::max(size.x, size.y);
}

/// The garment against the bodies.
void check_scale(const PreflightInput& in, std::span<const BodyProbe> probes,
                 const sewing::Assembly& assembly, Findings& findings) {
  double tallest = 0;
  for (const BodyProbe& probe : probes) tallest = std::max(tallest, length(probe.box().size()));
  if (!(tallest > 0)) return;
  double largest = 0;
  Index at = kNone;
  for (std::size_t p = 0; p < in.meshes.panels.size(); ++p) {
    const double extent = extent_of(in.meshes.panels[p]);
    if (extent > largest) {
      largest = extent;
      at = static_cast<Index>(p);
    }
  }
  if (at == kNone || (largest < kHuge * tallest && largest > kTiny * tallest)) return;
  const bool huge = largest >= kHuge * tallest;
  Finding f =
      found(FindingKind::kScale, "", {piece_named(in.pattern.panels[at].id)}, centre_of(assembly, at));
  f.message = "the largest piece measures " + length_text(largest) + (huge ? ", far more" : ", far less") +
              " than the body's " + length_text(tallest);
  std::string hints;
  for (const UnitSlip& slip : kSlips) {
    const double then = huge ? largest / slip.factor : largest * slip.factor;
    if (then < 0.2 * tallest || then > 1.2 * tallest) continue;
    hints += (hints.empty() ? "" : " or ") + ratio_text(slip.factor);
  }
  f.message += hints.empty() ? "; see to the unit of its file"
                             : "; a factor of " + hints +
                                   " between units would explain it: see to the unit of its file";
  findings.push_back(f);
}

/// A piece whose seams all differ by the same factor, one that two units differ by.
void check_partners(const PreflightInput& in, const sewing::Assembly& assembly, Findings& findings) {
  struct Span {
    double low = 1e9, high = 0;
  };
  const auto side_only = [](const std::vector<pattern::SeamEdge>& side, Index p) {
    return std::all_of(side.begin(), side.end(), [&](const pattern::SeamEdge& e) { return e.panel == p; });
  };
  for (Index p = 0; p < static_cast<Index>(in.pattern.panels.size()); ++p) {
    Span ratio;
    int seams = 0;
    for (const mesh::MatchedSeam& m : in.meshes.seams) {
      const pattern::Seam& seam = in.pattern.seams[m.seam];
      const bool on_a = side_only(seam.a, p), on_b = side_only(seam.b, p);
      if (on_a == on_b) continue;
      const double r = on_a ? m.length_a / m.length_b : m.length_b / m.length_a;
      ratio.low = std::min(ratio.low, r);
      ratio.high = std::max(ratio.high, r);
      ++seams;
    }
    if (seams < 2 || ratio.high > ratio.low * 1.05) continue;
    const double mean = 0.5 * (ratio.low + ratio.high);
    const UnitSlip* slip = slip_like(mean > 1 ? mean : 1 / mean);
    if (slip == nullptr) continue;
    findings.push_back(found(FindingKind::kScale,
                             "all seams of the piece are " + ratio_text(mean > 1 ? mean : 1 / mean) +
                                 " times as " + (mean > 1 ? "long" : "short") +
                                 " as what they are sewn to, as of " + slip->words +
                                 "; see to the unit of its file",
                             {piece_named(in.pattern.panels[p].id)}, centre_of(assembly, p)));
  }
}

void check_places(const PreflightInput& in, std::span<const BodyProbe> probes,
                  const sewing::Assembly& assembly, Findings& findings) {
  if (probes.empty()) return;
  for (Index p = 0; p < static_cast<Index>(in.pattern.panels.size()); ++p) {
    const Vec3 c = centre_of(assembly, p);
    double least = 1e9;
    for (const BodyProbe& probe : probes) {
      const auto& [lo, hi] = probe.box();
      const Vec3 out{std::max({lo.x - c.x, c.x - hi.x, 0.0}), std::max({lo.y - c.y, c.y - hi.y, 0.0}),
                     std::max({lo.z - c.z, c.z - hi.z, 0.0})};
      least = std::min(least, length(out) - kFarAway * length(hi - lo));
    }
    if (least < 1) continue;
    findings.push_back(
        found(FindingKind::kFar,
              "the piece is placed far from every body; its place is in metres, not in millimetres",
              {piece_named(in.pattern.panels[p].id)}, c));
  }
}

void check_edges(const PreflightInput& in, const sewing::Assembly& assembly, Findings& findings) {
  for (std::size_t p = 0; p < in.pattern.panels.size(); ++p) {
    const auto edges = pattern::edges_of(in.pattern.panels[p]);
    const double spacing = pattern::spacing_on(in.pattern.panels[p], in.particle_distance);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const double long_m = metres_from_mm(pattern::arc_length(*edges[e]));
      if (long_m >= kShortestEdge * spacing) continue;
      const Index v = in.meshes.panels[p].edge_vertices[e].front();
      findings.push_back(
          found(FindingKind::kShortEdge,
                "the edge measures " + length_text(long_m) + ", less than half the particle distance of " +
                    length_text(spacing) +
                    ", and will read as overstretched; join it to its neighbour, or take smaller particles",
                {piece_named(in.pattern.panels[p].id), edge_named(edges[e]->id)},
                assembly.positions[assembly.garment.first_vertex[p] + v]));
    }
  }
}

void check_lengths(const PreflightInput& in, const sewing::Assembly& assembly, Findings& findings) {
  for (const mesh::MatchedSeam& m : in.meshes.seams) {
    const double longer = std::max(m.length_a, m.length_b), shorter = std::min(m.length_a, m.length_b);
    const double ratio = longer / shorter;
    if (ratio <= kEased) continue;
    Finding f = found(FindingKind::kLengthDifference, "", {seam_named(in.pattern.seams[m.seam].id)},
                      place_of_seam(assembly, m.seam));
    const std::string lengths = length_text(longer) + " are sewn to " + length_text(shorter);
    if (ratio > kMostGathered) {
      f.kind = FindingKind::kLengthRatio;
      f.severity = Severity::kError;
      f.message = lengths + ", 1:" + ratio_text(ratio) +
                  "; more than 1:3 cannot be gathered: see to the edges and units";
    } else if (ratio > kGathered) {
      f.severity = Severity::kWarning;
      f.message = lengths + ", a gather of 1:" + ratio_text(ratio) + "; if it is none, see to the edges";
    } else {
      f.message = lengths + ", " + length_text(longer - shorter) + " are eased in";
    }
    findings.push_back(std::move(f));
  }
}

}  // namespace

Vec3 place_of_seam(const sewing::Assembly& assembly, Index seam) {
  Vec3 sum;
  int count = 0;
  for (std::size_t k = 0; k < assembly.garment.sewn.size(); ++k) {
    if (assembly.garment.seam_of_sewn[k] != seam) continue;
    for (const Index v : assembly.garment.sewn[k]) {
      sum += assembly.positions[v];
      ++count;
    }
  }
  return count > 0 ? sum * (1.0 / count) : sum;
}

void check_sizes(const PreflightInput& input, std::span<const BodyProbe> probes,
                 const sewing::Assembly& assembly, Findings& findings) {
  check_scale(input, probes, assembly, findings);
  check_partners(input, assembly, findings);
  check_places(input, probes, assembly, findings);
  check_edges(input, assembly, findings);
  check_lengths(input, assembly, findings);
}

}  // namespace toile::preflight
