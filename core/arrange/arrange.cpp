#include "core/arrange/arrange.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>

#include "core/arrange/arranger.h"
#include "core/preflight/preflight.h"
#include "core/sewing/assembly.h"

namespace toile::arrange {

namespace {

/// What speaks against a start, compared in this order; less is better.
struct Faults {
  int errors = 0;    ///< what hinders the drape
  int warnings = 0;  ///< what may go wrong and another place might mend
  int slides = 0;    ///< threads that must first slide off an arm from below, or pass close to one
  friend auto operator<=>(const Faults&, const Faults&) = default;
};

/// How much a thread has to slide that can come free: through a limb is worse than beside one.
int slide_of(preflight::FindingKind kind) {
  if (kind == preflight::FindingKind::kThreadThroughBody) return 2;
  return kind == preflight::FindingKind::kThreadNearLimb ? 1 : 0;
}

/// `armpit`: m; threads over a shoulder, above it, slide up the shoulder by themselves.
Faults faults_of(const preflight::Findings& findings, double armpit) {
  Faults faults;
  for (const preflight::Finding& f : findings) {
    // What lies in the pattern is there wherever its pieces stand, and tells nothing of this start.
    const bool of_start = preflight::traits_of(f.kind).cause == preflight::Cause::kPlacement;
    if (f.severity == preflight::Severity::kError) ++faults.errors;
    if (f.severity == preflight::Severity::kWarning && !f.repaired && of_start) ++faults.warnings;
    if (f.severity == preflight::Severity::kNote && f.place.y <= armpit) faults.slides += slide_of(f.kind);
  }
  return faults;
}

/// What the pre-flight shifted, put into the placements, so that the start needs no repair.
void keep_shifts(const sewing::Assembly& before, const sewing::Assembly& repaired,
                 std::vector<sewing::Placement>& placements) {
  const sewing::GarmentMesh& g = before.garment;
  for (std::size_t p = 0; p < placements.size(); ++p) {
    const Index first = g.first_vertex[p], end = g.first_vertex[p + 1];
    const Vec3 by = repaired.positions[first] - before.positions[first];
    bool shifted = length(by) > 0;
    for (Index v = first; v < end && shifted; ++v) {
      shifted = length(repaired.positions[v] - before.positions[v] - by) < 1e-6;
    }
    if (!shifted) continue;
    if (auto* rigid = std::get_if<sewing::RigidPlacement>(&placements[p])) rigid->translation += by;
    if (auto* wrapped = std::get_if<sewing::WrappedPlacement>(&placements[p])) wrapped->axis += by;
  }
}

Result<preflight::Findings> look(const ArrangeInput& input, Arrangement& made) {
  preflight::Findings findings;
  for (int round = 0; round < 2; ++round) {
    sewing::Assembly assembly = TRY(sewing::assemble(input.meshes, made.placements, made.attachments));
    const sewing::Assembly before = assembly;
    findings = preflight::run_preflight({input.pattern, input.meshes, input.bodies}, assembly);
    keep_shifts(before, assembly, made.placements);
  }
  return findings;
}

}  // namespace

Result<Arrangement> arrange(const ArrangeInput& input) {
  std::optional<Error> why =
      Error{"arrange.no_body", "there is no body to dress; add one to the project", ""};
  for (const body::Body& body : input.bodies) {
    const Result<measure::BodyFigure> figure = measure::find_figure(body.mesh);
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
      preflight::Findings findings = TRY(look(input, made));
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

}  // namespace toile::arrange
