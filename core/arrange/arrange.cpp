#include "core/arrange/arrange.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>

#include "core/arrange/arranger.h"
#include "core/arrange/garment_part.h"
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

/// All pieces around the body, `away` (m) farther from it than they need be.
Result<Arrangement> arrange_whole(const ArrangeInput& input, const BodyStand& stand, double away) {
  Arranger arranger = TRY(Arranger::make(input, stand));
  std::optional<Arrangement> best;
  Faults fewest{};
  // Higher or lower on the body, and farther out along the arms: the start with the fewest faults is taken,
  // the first of several.
  for (ArrangeTrial trial : arranger.trials()) {
    trial.away += away;
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

/// Takes over what was made of a part.
void take_part(Arrangement part, const std::vector<Index>& panels, Arrangement& whole) {
  for (std::size_t k = 0; k < panels.size(); ++k) {
    whole.placements[panels[k]] = part.placements[k];
    whole.pieces[panels[k]] = std::move(part.pieces[k]);
  }
  for (sewing::Attachment& a : part.attachments) {
    a.panel = panels[a.panel];
    whole.attachments.push_back(std::move(a));
  }
}

void tell_unplaced(const ArrangeInput& input, Arrangement& made) {
  for (const Index p : made.unplaced)
    made.findings.push_back(preflight::found(
        preflight::FindingKind::kLeftOut,
        "no seam leads from the other pieces to this one, so that nothing tells where it goes and it stays "
        "where it is; sew it, or place it by hand",
        {preflight::piece_named(input.pattern.panels[p].id)}, {}));
  preflight::sort_by_severity(made.findings);
}

/// The start is judged without what has no place in it.
Result<preflight::Findings> look_at_placed(const ArrangeInput& input, const GarmentPart& placed,
                                           Arrangement& made) {
  Arrangement some;
  std::vector<Index> now(input.pattern.panels.size(), kNone);
  for (std::size_t k = 0; k < placed.panels.size(); ++k) {
    now[placed.panels[k]] = static_cast<Index>(k);
    some.placements.push_back(made.placements[placed.panels[k]]);
  }
  some.attachments = made.attachments;
  for (sewing::Attachment& a : some.attachments) a.panel = now[a.panel];
  preflight::Findings findings = TRY(look({placed.pattern, placed.meshes, input.bodies}, some));
  for (std::size_t k = 0; k < placed.panels.size(); ++k)
    made.placements[placed.panels[k]] = some.placements[k];
  return findings;
}

/// Each part that hangs together by seams is arranged as a garment of its own, smaller ones over larger ones.
/// `why`: the whole could not be; it is told where no part can, or what can is the less of the cloth.
Result<Arrangement> arrange_by_parts(const ArrangeInput& input, const BodyStand& stand, const Error& why) {
  constexpr double kOver = 0.04;  // m, from one garment to the next
  constexpr double kLeast = 0.5;  // of the cloth
  Arrangement made;
  made.placements.assign(input.pattern.panels.size(), sewing::RigidPlacement{});
  for (const pattern::Panel& panel : input.pattern.panels) made.pieces.push_back({panel.id, ""});
  double away = 0, placed = 0, all = 0;
  std::vector<Index> panels;
  for (const GarmentPart& part : garment_parts(input.pattern, input.meshes)) {
    all += part.area;
    Result<Arrangement> alone = why;
    if (!part.pattern.seams.empty())
      alone = arrange_whole({part.pattern, part.meshes, input.bodies, input.absent}, stand, away);
    if (!alone) {
      made.unplaced.insert(made.unplaced.end(), part.panels.begin(), part.panels.end());
      continue;
    }
    take_part(std::move(*alone), part.panels, made);
    panels.insert(panels.end(), part.panels.begin(), part.panels.end());
    placed += part.area;
    away += kOver;
  }
  if (placed < kLeast * all) return why;
  std::sort(made.unplaced.begin(), made.unplaced.end());
  std::sort(panels.begin(), panels.end());
  made.findings = TRY(look_at_placed(input, garment_of(input.pattern, input.meshes, panels), made));
  for (const Index p : made.unplaced) made.pieces[p].where = "left where it is, no seam tells its place";
  tell_unplaced(input, made);
  return made;
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
    Result<Arrangement> whole = arrange_whole(input, stand, 0);
    if (whole) return whole;
    return arrange_by_parts(input, stand, whole.error());
  }
  return *why;
}

}  // namespace toile::arrange
