#include "core/preflight/preflight.h"

#include <algorithm>

#include "core/preflight/check_cloth_threads.h"
#include "core/preflight/check_layers.h"
#include "core/preflight/check_pattern.h"
#include "core/preflight/check_rings.h"
#include "core/preflight/check_sides.h"
#include "core/preflight/check_threads.h"
#include "core/preflight/move_apart.h"

namespace toile::preflight {

namespace {

bool has_error(const Findings& findings, FindingKind kind) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const Finding& f) { return f.severity == Severity::kError && f.kind == kind; });
}

/// The last word: the count that every frame of the drape will go through, on what the repairs left.
void verify(const PreflightInput& in, std::span<const BodyProbe> probes, const sewing::Assembly& assembly,
            Findings& findings) {
  const sewing::GarmentMesh& g = assembly.garment;
  const collision::Surface surface = collision::make_surface(g.triangles, g.vertex_count(), g.weld);
  const auto piece = [&](Index t) { return piece_named(in.pattern.panels[g.panel_of_triangle[t]].id); };
  const auto place = [&](Index t) { return assembly.positions[g.triangles[t][0]]; };
  for (const BodyProbe& probe : probes) {
    const auto crossings = collision::body_crossings(surface, assembly.positions, probe.crossing());
    if (crossings.empty() || has_error(findings, FindingKind::kCrossesBody)) continue;
    findings.push_back(
        found(FindingKind::kCrossesBody,
              "the piece passes through body " + probe.body().id + " where it is placed; move it clear of it",
              {piece(crossings[0][0]), body_named(probe.body().id)}, place(crossings[0][0])));
  }
  const auto crossings = collision::self_crossings(surface, assembly.positions);
  if (crossings.empty() || has_error(findings, FindingKind::kCrossesCloth)) return;
  findings.push_back(found(FindingKind::kCrossesCloth,
                           "two pieces pass through each other where they are placed; move them apart",
                           {piece(crossings[0][0]), piece(crossings[0][1])}, place(crossings[0][0])));
}

}  // namespace

Findings run_preflight(const PreflightInput& input, sewing::Assembly& assembly) {
  Findings findings;
  const std::vector<BodyProbe> probes = make_probes(input.bodies);
  turn_pieces(input, probes, assembly, findings);
  untwist_seams(input, assembly, findings);
  move_apart(input.pattern, probes, assembly, findings);
  verify(input, probes, assembly, findings);
  check_sizes(input, probes, assembly, findings);
  check_layers(input, assembly, findings);
  check_sides(input, probes, assembly, findings);
  check_threads(input, probes, assembly, findings);
  check_cloth_threads(input, assembly, findings);
  check_open_rings(input, assembly, findings);
  check_rings(input, probes, assembly, findings);
  sort_by_severity(findings);
  return findings;
}

}  // namespace toile::preflight
