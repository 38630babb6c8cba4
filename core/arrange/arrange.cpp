#include "core/arrange/arrange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/arrange/arranger.h"
#include "core/preflight/preflight.h"
#include "core/sewing/assembly.h"

namespace toile {

namespace {

/// Less is better: what hinders the drape, what may go wrong, and threads that must first slide off an arm
/// from below or pass close to one. Those over a shoulder slide up it by themselves.
using Faults = std::array<std::ptrdiff_t, 3>;

Faults faults_of(const Findings& findings, double armpit) {
  Faults faults{0, 0, 0};
  for (const Finding& f : findings) {
    // These lie in the pattern, wherever its pieces stand.
    const bool of_pattern =
        f.code == "ring.tight" || f.code == "edge.short" || f.code.starts_with("seam.length");
    if (f.severity == Severity::kError) ++faults[0];
    if (f.severity == Severity::kWarning && !f.repaired && !of_pattern) ++faults[1];
    if (f.severity != Severity::kNote || f.place.y > armpit) continue;
    if (f.code == "seam.thread_through_body") faults[2] += 2;
    if (f.code == "seam.thread_near_limb") ++faults[2];
  }
  return faults;
}

/// What the pre-flight shifted, put into the placements, so that the start needs no repair.
void keep_shifts(const Assembly& before, const Assembly& repaired, std::vector<Placement>& placements) {
  const GarmentMesh& g = before.garment;
  for (std::size_t p = 0; p < placements.size(); ++p) {
    const Index first = g.first_vertex[p], end = g.first_vertex[p + 1];
    const Vec3 by = repaired.positions[first] - before.positions[first];
    bool shifted = length(by) > 0;
    for (Index v = first; v < end && shifted; ++v) {
      shifted = length(repaired.positions[v] - before.positions[v] - by) < 1e-6;
    }
    if (!shifted) continue;
    if (auto* rigid = std::get_if<RigidPlacement>(&placements[p])) rigid->translation += by;
    if (auto* wrapped = std::get_if<WrappedPlacement>(&placements[p])) wrapped->axis += by;
  }
}

Result<Findings> look(const ArrangeInput& input, Arrangement& made) {
  Findings findings;
  for (int round = 0; round < 2; ++round) {
    Assembly assembly = TRY(assemble(input.meshes, made.placements, made.attachments));
    const Assembly before = assembly;
    findings = run_preflight({input.pattern, input.meshes, input.bodies}, assembly);
    keep_shifts(before, assembly, made.placements);
  }
  return findings;
}

}  // namespace

Result<Arrangement> arrange(const ArrangeInput& input) {
  std::optional<Error> why =
      Error{"arrange.no_body", "there is no body to dress; add one to the project", ""};
  for (const Body& body : input.bodies) {
    const Result<BodyFigure> figure = find_figure(body.mesh);
    if (!figure) {
      why = figure.error();
      why->where = "body " + body.id;
      continue;
    }
    const BodyStand stand(body.mesh, *figure);
    Arranger arranger = TRY(Arranger::make(input, stand));
    std::optional<Arrangement> best;
    Faults fewest{};
    // Higher or lower on the body, and farther out along the arms: the start with the fewest faults is taken,
    // the first of several.
    for (const ArrangeTrial& trial : arranger.trials()) {
      Arrangement made = arranger.place(trial);
      Findings findings = TRY(look(input, made));
      made.findings = std::move(findings);
      const Faults faults = faults_of(made.findings, stand.figure().armpit[0].y);
      if (!best || faults < fewest) {
        fewest = faults;
        best = std::move(made);
      }
      if (fewest == Faults{}) break;
    }
    return std::move(*best);
  }
  return *why;
}

}  // namespace toile
