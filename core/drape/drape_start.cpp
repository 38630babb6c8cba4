#include "core/drape/drape_start.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/arrange/arrange.h"
#include "core/base/aabb.h"
#include "core/drape/left_open.h"
#include "core/drape/worn_part.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/preflight/preflight.h"

namespace toile::drape {

namespace {

/// Garments are put on by a mesh of this particle distance where theirs is finer: a shape needs no more.
constexpr double kLeastCoarse = 0.02;  // m
constexpr int kMostCoarse = 6000;      // particles, about
/// Where no way is certified, they are tried by a finer mesh as well: where only crossings are in the way by
/// the cloth's own, or where that is coarser by the one above, if it is so much finer. Large triangles span
/// folds and limbs that they have to get out of.
constexpr double kMuchFiner = 0.8;  // of the cloth's own particle distance

/// Layers worn over each other: which of them is inside is known to contact alone.
bool layered(const pattern::Pattern& pattern) {
  return std::any_of(pattern.panels.begin(), pattern.panels.end(),
                     [&](const pattern::Panel& p) { return p.layer != pattern.panels.front().layer; });
}

/// Whether something about where the pieces stand may keep them from being sewn there: a start that is in
/// order is sewn under contact, which keeps the cloth's shape from the first step on.
bool in_question(const preflight::Findings& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const preflight::Finding& f) {
    return preflight::traits_of(f.kind).cause == preflight::Cause::kPlacement;
  });
}

/// Particle distance at which the garment is put on, m: no finer than a shape needs, and coarser for very
/// large skirts.
double coarse_distance(const mesh::PanelMeshes& meshes) {
  double area = 0;
  for (const mesh::PanelMesh& panel : meshes.panels)
    for (const Tri& t : panel.triangles)
      area += 0.5 * std::abs(cross(panel.rest[t[1]] - panel.rest[t[0]], panel.rest[t[2]] - panel.rest[t[0]]));
  constexpr double kPerVertex = 0.866;  // of the squared distance, where triangles are even
  return std::max(kLeastCoarse, std::sqrt(area / (kPerVertex * kMostCoarse)));
}

std::optional<sewing::Assembly> coarse_assembly(const DrapeInput& input,
                                                const std::vector<sewing::Placement>& placements,
                                                double distance, const RunContext& context) {
  pattern::Pattern pattern = input.pattern;
  for (pattern::Panel& panel : pattern.panels) panel.spacing = std::max(panel.spacing, distance);
  const auto meshes = mesh::make_panel_meshes(pattern, distance, context);
  if (!meshes) return std::nullopt;
  auto assembly = sewing::assemble(*meshes, placements, {}, input.notions);
  if (!assembly) return std::nullopt;
  return std::move(*assembly);
}

/// The garment put on from where `placements` have its pieces, by the ways from number `first` on.
dressing::TriedOn put_on_from(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                              const std::vector<sewing::Placement>& placements,
                              const dressing::Wearer& wearer, std::size_t first, dressing::Effort effort,
                              const RunContext& context) {
  const auto fine = sewing::assemble(meshes, placements, {}, input.notions);
  if (!fine) return {};
  const double distance = coarse_distance(meshes), own = input.settings.particle_distance;
  const auto by_mesh_of = [&](double shape, std::size_t from, dressing::Effort left) {
    const auto other = coarse_assembly(input, placements, shape, context);
    return dressing::put_on(*fine, other ? *other : *fine, wearer, context, from, left);
  };
  const auto by_own_mesh = [&](dressing::Effort left) {
    return dressing::put_on(*fine, *fine, wearer, context, first, left);
  };
  const bool coarser = own < distance;
  const dressing::Effort part = coarser ? effort.half() : effort;
  dressing::TriedOn tried = coarser ? by_mesh_of(distance, first, part) : by_own_mesh(part);
  tried.effort = effort.less(part, tried.effort);
  const bool tangled = coarser && tried.shortfall.rings == 0;
  const bool more_to_try =
      coarser ? tangled || tried.gave_up : !tried.gave_up && own * kMuchFiner >= distance;
  if (tried.on || !more_to_try || context.cancelled()) return tried;
  dressing::TriedOn more =
      tangled ? by_own_mesh(tried.effort) : by_mesh_of(distance, coarser ? tried.next : first, tried.effort);
  // Ways that are one for this garment are passed over: where no other was left, nothing is told.
  if (more.on || (!more.at_fault.empty() && more.shortfall < tried.shortfall)) return more;
  tried.effort = more.effort;
  tried.gave_up = more.gave_up;
  tried.next = more.next;
  return tried;
}

/// Whether pieces stand at `placements` as they do in the start: a garment that was arranged is arranged so
/// again, but for what the mesh's fineness and the document's decimals make of it.
bool stand_alike(const DrapeStart& start, const std::vector<sewing::Placement>& placements,
                 const sewing::Notions& notions) {
  constexpr double kAlike = 5e-3;  // m: less than ways differ by
  const auto anew = sewing::assemble(start.meshes, placements, {}, notions);
  if (!anew) return false;
  const std::vector<Vec3>&x = start.placed.positions, &y = anew->positions;
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](Vec3 p, Vec3 q) { return length(p - q) < kAlike; });
}

/// Where the pieces are arranged (core/arrange), those without a place where they stand; nothing where none
/// can be.
std::optional<std::vector<sewing::Placement>> arranged_anew(const DrapeInput& input,
                                                            const DrapeStart& start) {
  auto anew = arrange::arrange({input.pattern, start.meshes, input.bodies, names_left_out(input)});
  if (!anew) return std::nullopt;
  for (const Index p : anew->unplaced) anew->placements[p] = input.placements[p];
  return std::move(anew->placements);
}

/// Whether most of the cloth is of pieces that stand wholly beside the bodies and face ahead or back, as
/// pieces in rows do: they stand there as they were drawn, and nobody gets dressed from there. Panels of a
/// wide skirt stand as far out, but face the body. What something holds there is meant to be there.
bool lies_beside(const DrapeInput& input, const DrapeStart& start) {
  constexpr double kBeside = 0.1;  // m, farther to the side than any part of a body
  constexpr double kFlat = 0.01;   // m, from front to back
  if (!input.attachments.empty()) return false;
  Aabb<Vec3> bodies;
  for (const body::Body& body : input.bodies)
    for (const Vec3& p : body.mesh.vertices) bodies.add(p);
  const Aabb<Vec3> near = bodies.grown(kBeside);
  const std::vector<Index>& first = start.placed.garment.first_vertex;
  std::size_t beside = 0;
  for (std::size_t p = 0; p + 1 < first.size(); ++p) {
    const auto count = static_cast<std::size_t>(first[p + 1] - first[p]);
    const Aabb<Vec3> piece =
        bounding_box(std::span(start.placed.positions).subspan(static_cast<std::size_t>(first[p]), count));
    const bool ahead = piece.size().z < kFlat;
    if (ahead && (piece.low.x > near.high.x || piece.high.x < near.low.x)) beside += count;
  }
  return 2 * beside > start.placed.positions.size();
}

/// What came of two starts, of which the first was not certified, or is strained: the second, if that is no
/// worse, or tells no less of what kept it from being certified, or came nearer.
PutOnTries nearer_of(PutOnTries first, PutOnTries second) {
  first.effort = second.effort;
  if (first.on && (!second.on || second.strained)) return first;
  first.gave_up = second.gave_up = first.gave_up || second.gave_up;
  if (second.on || first.at_fault.empty()) return second;
  return second.at_fault.empty() || first.shortfall < second.shortfall ? first : second;
}

/// Garments are arranged, put on and judged for somebody who looks along +z.
void tell_turned_body(const std::optional<dressing::Person>& person, preflight::Findings& findings) {
  if (!person || !dressing::looks_back(*person)) return;
  findings.push_back(preflight::found(
      preflight::FindingKind::kBodyTurned,
      "the body looks to the back, along -z, so that the garment goes on back to front; turn it by 180 "
      "degrees about y",
      {preflight::body_named(person->body->id)}, person->figure.neck_front));
  preflight::sort_by_severity(findings);
}

}  // namespace

void begin_on_body(DrapeStart& start) {
  start.assembly = start.placed;
  for (preflight::Finding& f : start.findings) {
    if (preflight::traits_of(f.kind).cause != preflight::Cause::kPlacement) continue;
    f.severity = preflight::Severity::kNote;
    f.repaired = true;
  }
  preflight::sort_by_severity(start.findings);
}

Result<DrapeStart> prepare_start(const DrapeInput& input, const RunContext& context) {
  context.progress("mesh", 0);
  auto meshes = TRY(mesh::make_panel_meshes(input.pattern, input.settings.particle_distance, context));
  context.progress("place", 0);
  auto assembly = TRY(sewing::assemble(meshes, input.placements, input.attachments, input.notions));
  DrapeStart start{std::move(meshes), assembly, std::move(assembly), {}, {}, {}};
  start.person = dressing::find_person(input.bodies);
  start.findings = preflight::run_preflight(
      {input.pattern, start.meshes, input.bodies, input.settings.particle_distance}, start.assembly);
  tell_turned_body(start.person, start.findings);
  tell_left_out(input, start.findings);
  tell_left_open(input, start.meshes, start.placed, start.findings);
  return start;
}

bool may_put_on(const DrapeInput& input, const DrapeStart& start) {
  return input.settings.dress && start.person && !start.placed.garment.sewn.empty() &&
         !layered(input.pattern);
}

PutOnTries put_on_after(int after, const DrapeInput& input, const DrapeStart& start,
                        const RunContext& context, dressing::Effort effort) {
  const auto ways = static_cast<int>(dressing::dressing_ways().size());
  const dressing::Wearer wearer(*start.person);
  std::size_t next = 0;
  const auto from = [&](const std::vector<sewing::Placement>& placements, int before, std::size_t first,
                        dressing::Effort part) {
    dressing::TriedOn tried = put_on_from(input, start.meshes, placements, wearer, first, part, context);
    next = tried.next;
    PutOnTries tries;
    tries.effort = effort = effort.less(part, tried.effort);
    tries.gave_up = tried.gave_up;
    if (tried.on)
      tries.on = PutOn{std::move(tried.on->positions), before + static_cast<int>(tried.on->number) + 1};
    tries.strained = tried.on && !tried.on->certificate.holds();
    tries.nearest = before + static_cast<int>(tried.nearest) + 1;
    tries.shortfall = tried.shortfall;
    tries.at_fault = std::move(tried.at_fault);
    return tries;
  };
  const auto passed_over = [&](int before) { return static_cast<std::size_t>(std::max(0, after - before)); };
  const bool drawn = after == kSewnInPlace && lies_beside(input, start);
  std::optional<std::vector<sewing::Placement>> anew;
  bool alike = false;
  const auto arrange_anew = [&] {
    anew = arranged_anew(input, start);
    alike = anew && stand_alike(start, *anew, input.notions);
  };
  PutOnTries tries;
  tries.effort = effort;
  if (drawn) arrange_anew();
  if (anew && !alike) {
    tries = from(*anew, ways, 0, effort);
    if (tries.well_on() || context.cancelled()) return tries;
    return nearer_of(std::move(tries), from(input.placements, 0, 0, effort));
  }
  if (after < ways) tries = from(input.placements, 0, passed_over(0), effort.half());
  if (tries.well_on() || after >= 2 * ways || context.cancelled()) return tries;
  if (!drawn) arrange_anew();
  if (!anew || (alike && !tries.gave_up)) return tries;
  if (!alike) return nearer_of(std::move(tries), from(*anew, ways, passed_over(ways), effort.half()));
  tries.gave_up = false;  // where they stand so already, the work is for the ways that were not reached
  return nearer_of(std::move(tries), from(input.placements, 0, next, effort.half()));
}

std::optional<PutOnTries> dress_start(const DrapeInput& input, DrapeStart& start, const RunContext& context,
                                      int after, dressing::Effort effort) {
  if (!may_put_on(input, start)) return std::nullopt;
  const bool in_order = !in_question(start.findings) && !lies_beside(input, start);
  if (in_order && start.placed.pressed_back.empty()) return std::nullopt;
  PutOnTries tries = put_on_after(after, input, start, context, effort);
  start.dressed = tries.on;
  if (start.dressed) begin_on_body(start);
  return tries;
}

}  // namespace toile::drape
