#include "core/drape/fit_start.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "core/base/aabb.h"
#include "core/base/units.h"
#include "core/drape/left_open.h"
#include "core/drape/worn_part.h"

namespace toile::drape {
namespace {

constexpr int kMostReductions = 2;
constexpr int kMostRefusals = 4;
/// Less of the cloth's area than this is no drape of the garment any more: a waistband without its bodice.
constexpr double kLeastPart = 0.5;

double area_of(const mesh::PanelMesh& panel) {
  double area = 0;
  for (const Tri& t : panel.triangles)
    area += std::abs(cross(panel.rest[t[1]] - panel.rest[t[0]], panel.rest[t[2]] - panel.rest[t[0]]));
  return 0.5 * area;
}

double area_of(const DrapeStart& start, const std::vector<bool>& out) {
  double area = 0;
  for (std::size_t p = 0; p < start.meshes.panels.size(); ++p)
    if (out.empty() || !out[p]) area += area_of(start.meshes.panels[p]);
  return area;
}

/// Marks the panels of `input` that `part` does not have.
void mark_missing(const DrapeInput& input, const DrapeInput& part, std::vector<bool>& out) {
  std::size_t next = 0;  // the part's panels are in the order of the whole's
  for (std::size_t p = 0; p < out.size(); ++p) {
    const bool kept =
        next < part.pattern.panels.size() && part.pattern.panels[next].id == input.pattern.panels[p].id;
    if (kept) ++next;
    out[p] = !kept;
  }
}

/// Of the input, where panel numbers of a part of it are given.
void mark_at_fault(const std::vector<Index>& at_fault, std::vector<bool>& out) {
  std::vector<std::size_t> panel_of;
  for (std::size_t p = 0; p < out.size(); ++p)
    if (!out[p]) panel_of.push_back(p);
  for (const Index p : at_fault) out[panel_of[p]] = true;
}

/// Marks the pieces that errors about where pieces stand name: of two that get in each other's way, or that a
/// seam joins which would stay open, the smaller. False where no such error is left.
bool mark_refused(const DrapeInput& input, const DrapeStart& whole, const preflight::Findings& findings,
                  std::vector<bool>& out) {
  const pattern::Pattern& pattern = input.pattern;
  const auto panel_named = [&](const std::string& id) {
    const auto at = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                 [&](const pattern::Panel& panel) { return panel.id == id; });
    return at == pattern.panels.end() ? kNone : static_cast<Index>(at - pattern.panels.begin());
  };
  bool any = false;
  for (const preflight::Finding& f : findings) {
    if (f.severity != preflight::Severity::kError ||
        preflight::traits_of(f.kind).cause != preflight::Cause::kPlacement)
      continue;
    std::vector<Index> panels;
    for (const preflight::Concern& about : f.about) {
      if (about.thing == preflight::Concern::Thing::kPiece) panels.push_back(panel_named(about.id));
      if (about.thing != preflight::Concern::Thing::kSeam) continue;
      for (const pattern::Seam& seam : pattern.seams)
        if (seam.id == about.id) panels = {seam.a.front().panel, seam.b.front().panel};
    }
    std::erase(panels, kNone);
    if (panels.empty() || std::any_of(panels.begin(), panels.end(), [&](Index p) { return bool(out[p]); }))
      continue;
    const auto area = [&](Index p) { return area_of(whole.meshes.panels[p]); };
    out[area(panels.front()) < area(panels.back()) ? panels.front() : panels.back()] = true;
    any = true;
  }
  return any;
}

/// Work that the machine does not do must not be taken for work that cannot be done.
void tell_given_up(preflight::Findings& findings) {
  findings.push_back(preflight::found(preflight::FindingKind::kGivenUp,
                                      "putting the garment on was given up before all ways to do so were "
                                      "tried, since it cost too much work; a "
                                      "larger particle distance leaves time for more of them",
                                      {}, {}));
  preflight::sort_by_severity(findings);
}

/// Without these panels and what nothing holds on then; nothing where too little would remain.
std::optional<DrapeInput> reduced_by(const DrapeInput& input, const DrapeStart& whole,
                                     std::vector<bool>& out) {
  if (std::find(out.begin(), out.end(), false) == out.end()) return std::nullopt;
  const DrapeInput worn = worn_part(without_panels(input, whole, out));
  mark_missing(input, worn, out);
  if (worn.pattern.seams.empty() || area_of(whole, out) < kLeastPart * area_of(whole, {}))
    return std::nullopt;
  return without_panels(input, whole, out);
}

}  // namespace

DrapeInput without_panels(const DrapeInput& input, const DrapeStart& start, const std::vector<bool>& out) {
  std::vector<Index> kept;
  for (std::size_t p = 0; p < out.size(); ++p)
    if (!out[p]) kept.push_back(static_cast<Index>(p));
  DrapeInput part = with_panels(input, kept);
  std::size_t left = input.left_out.size();
  const std::vector<Index>& first = start.placed.garment.first_vertex;
  for (std::size_t p = 0; p < out.size(); ++p) {
    if (!out[p]) continue;
    LeftOut& piece = part.left_out[left++];
    piece.tried = true;
    piece.place = bounding_box(std::span(start.placed.positions)
                                   .subspan(static_cast<std::size_t>(first[p]),
                                            static_cast<std::size_t>(first[p + 1] - first[p])))
                      .middle();
  }
  return part;
}

std::optional<FittedStart> without_refused(const DrapeInput& input, DrapeStart& start,
                                           const RunContext& context) {
  std::vector<bool> out(input.pattern.panels.size(), false);
  preflight::Findings findings = start.findings;
  for (int k = 0; k < kMostRefusals && mark_refused(input, start, findings, out); ++k) {
    std::optional<DrapeInput> part = reduced_by(input, start, out);
    const double square_mm = metres_from_mm(1) * metres_from_mm(1);  // m²
    if (!part || square_mm * most_together(part->pattern) < kLeastPart * area_of(start, {}))
      return std::nullopt;
    Result<DrapeStart> less = prepare_start(*part, context);
    if (!less) return std::nullopt;
    if (!preflight::first_error(less->findings)) {
      start = std::move(*less);
      return FittedStart{true, std::move(out), std::move(part)};
    }
    findings = std::move(less->findings);
  }
  return std::nullopt;
}

FittedStart fit_start(const DrapeInput& input, DrapeStart& start, const RunContext& context,
                      dressing::Effort effort) {
  FittedStart fitted;
  std::optional<PutOnTries> tries = dress_start(input, start, context, kSewnInPlace, effort);
  if (tries && tries->gave_up && !tries->on) tell_given_up(start.findings);
  fitted.last_start = !may_put_on(input, start) || (tries && !tries->on);
  if (!tries || tries->on || !preflight::first_error(start.findings)) return fitted;
  std::vector<bool> out(input.pattern.panels.size(), false);
  for (int k = 0; k < kMostReductions && !tries->at_fault.empty() && !context.cancelled(); ++k) {
    mark_at_fault(tries->at_fault, out);
    std::optional<DrapeInput> part = reduced_by(input, start, out);
    if (!part) break;
    Result<DrapeStart> less = prepare_start(*part, context);
    if (!less) break;
    tries = dress_start(*part, *less, context, tries->nearest - 1, tries->effort);
    if (!preflight::first_error(less->findings)) {
      fitted = {!may_put_on(*part, *less), std::move(out), std::move(part)};
      start = std::move(*less);
      return fitted;
    }
    if (!tries) break;
  }
  return without_refused(input, start, context).value_or(std::move(fitted));
}

}  // namespace toile::drape
