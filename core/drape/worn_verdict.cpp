#include "core/drape/worn_verdict.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/aabb.h"
#include "core/base/disjoint_sets.h"
#include "core/drape/worn_place.h"
#include "core/dressing/certificate.h"
#include "core/pattern/seams/garment_words.h"

namespace toile::drape {

namespace {

/// m that what hangs together may come down by until its parts that are to carry it do.
constexpr double kSlipped = 0.2;
constexpr double kFarDown = 0.3;   // m that a front or a back may, whatever carries the rest
constexpr double kUpperEnd = 0.3;  // m, below the highest place or the neck, whichever is lower
constexpr double kAtWaist = 0.06;  // m below the waist: what goes around it there is worn, wherever it began
constexpr double kDropped = 0.01;  // m above the ankles: what lies under that all around has fallen

/// What of the body a piece is for.
enum class Covers { kLegs, kTrunk, kOther };

preflight::Concerns pieces_of(const DrapeInput& input, const sewing::GarmentMesh& garment,
                              const std::vector<Index>& ring) {
  preflight::Concerns pieces;
  for (const Index v : ring) {
    preflight::Concern piece = preflight::piece_named(input.pattern.panels[garment.panel_of_vertex[v]].id);
    if (std::find(pieces.begin(), pieces.end(), piece) == pieces.end()) pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// A design's own slit looks the same as a seam that nobody told: the person is to see to it.
void tell_slit(const DrapeInput& input, const sewing::GarmentMesh& garment, const dressing::WornRing& ring,
               std::span<const Vec3> x, WornVerdict& verdict) {
  verdict.findings.push_back(preflight::found(
      preflight::FindingKind::kSlit,
      "an opening of " + preflight::length_text(ring.girth) +
          " around has no part of the body in it; if it is none of the design's, sew its sides",
      pieces_of(input, garment, ring.vertices), x[ring.vertices.front()]));
  if (verdict.worn == Worn::kYes) verdict.worn = Worn::kPartly;
}

/// Sewn parts that came down from where they began, by their first panels: how far, m. A hood that falls back
/// and a collar that turns over are the highest of a garment that stays: all that reached up to its upper end
/// must have come down.
///
/// A front or a back that came down by all of the chest has slipped, whatever became of the rest: a strap may
/// still lie on the shoulders.
///
/// `covers`: of each panel what it is for; a part for the waist alone has slipped only below `waist`.
std::vector<std::pair<Index, double>> slipped_parts(const sewing::GarmentMesh& garment,
                                                    std::span<const double> tops,
                                                    std::span<const double> tops_now, double neck,
                                                    const std::vector<Covers>& covers, double waist) {
  DisjointSets parts(tops.size());
  for (const auto& [i, j] : garment.sewn) parts.join(garment.panel_of_vertex[i], garment.panel_of_vertex[j]);
  std::vector<double> began(tops.size(), -HUGE_VAL), least(tops.size(), HUGE_VAL);
  std::vector<double> fell(tops.size(), 0);  // farther than kFarDown
  std::vector<char> at_waist(tops.size(), 1);
  for (std::size_t p = 0; p < tops.size(); ++p) {
    double& top = began[parts.root(static_cast<Index>(p))];
    top = std::max(top, std::min(neck, tops[p]));
  }
  for (std::size_t p = 0; p < tops.size(); ++p) {
    const Index part = parts.root(static_cast<Index>(p));
    const double down = tops[p] - tops_now[p];
    if (tops[p] >= began[part] - kUpperEnd) least[part] = std::min(least[part], down);
    at_waist[part] = at_waist[part] && covers[p] == Covers::kLegs;
    if (covers[p] == Covers::kTrunk && down > kFarDown) fell[part] = std::max(fell[part], down);
  }
  std::vector<double> highest(tops.size(), -HUGE_VAL);
  for (std::size_t p = 0; p < tops.size(); ++p) {
    double& top = highest[parts.root(static_cast<Index>(p))];
    top = std::max(top, tops_now[p]);
  }
  std::vector<std::pair<Index, double>> slipped;
  for (Index p = 0; p < static_cast<Index>(tops.size()); ++p) {
    const double by = least[p] > kSlipped ? least[p] : fell[p];
    if (parts.root(p) == p && by > 0 && !(at_waist[p] && highest[p] > waist - kAtWaist))
      slipped.emplace_back(p, by);
  }
  return slipped;
}

/// Of each panel, as far as names and shapes tell.
std::vector<Covers> covers_of(const pattern::Pattern& pattern) {
  using enum seams::PieceKind;
  std::vector<Covers> covers;
  for (const seams::PieceWords& w : seams::garment_words(pattern)) {
    const bool legs = w.kind == kSkirt || w.kind == kLegs || w.kind == kBand || w.kind == kFrill;
    const bool trunk = (w.kind == kTorso || w.kind == kOther) && w.face != 0;
    covers.push_back(legs ? Covers::kLegs : trunk ? Covers::kTrunk : Covers::kOther);
  }
  return covers;
}

/// Where all of the cloth lies on the ground: its highest place.
std::optional<Vec3> fallen(const measure::BodyFigure& figure, std::span<const Vec3> x) {
  const auto highest = std::max_element(x.begin(), x.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; });
  if (highest->y < figure.leg[0].ankle.y + kDropped) return *highest;
  return std::nullopt;
}

preflight::Finding on_ground(Vec3 at) {
  return preflight::found(preflight::FindingKind::kOnGround, "the garment has fallen to the ground", {}, at);
}

/// Cloth that is laid on somebody, such as a scarf, is no garment that is worn or not, unless it falls. Of
/// several pieces those fall that nothing carries: they end below the crotch.
WornVerdict judge_unsewn(const DrapeInput& input, const measure::BodyFigure& figure,
                         const sewing::GarmentMesh& garment, std::span<const Vec3> x) {
  const std::vector<double> tops = tops_of(garment, x);
  preflight::Concerns down;
  for (std::size_t p = 0; p < tops.size(); ++p)
    if (tops[p] < figure.crotch) down.push_back(preflight::piece_named(input.pattern.panels[p].id));
  WornVerdict verdict;
  if (const std::optional<Vec3> at = fallen(figure, x)) verdict.findings.push_back(on_ground(*at));
  if (tops.size() > 1 && input.notions.buttons.empty() && !down.empty())
    verdict.findings.push_back(
        preflight::found(preflight::FindingKind::kUnsewn,
                         "no seam joins the pieces, and they came down from the body; sew them on the page, "
                         "or make the project with toile project new --accept-seams 0.5",
                         std::move(down), {}));
  if (!verdict.findings.empty()) verdict.worn = Worn::kNo;
  return verdict;
}

bool is_whole(const DrapeInput& input, const std::vector<OpenSeam>& open) {
  return open.empty() && input.left_open.empty() &&
         std::all_of(input.left_out.begin(), input.left_out.end(),
                     [](const LeftOut& piece) { return piece.layer || piece.tied; });
}

}  // namespace

std::vector<double> tops_of(const sewing::GarmentMesh& garment, std::span<const Vec3> x) {
  std::vector<double> tops;
  for (std::size_t p = 0; p + 1 < garment.first_vertex.size(); ++p) {
    const auto first = static_cast<std::size_t>(garment.first_vertex[p]);
    const auto end = static_cast<std::size_t>(garment.first_vertex[p + 1]);
    tops.push_back(bounding_box(x.subspan(first, end - first)).high.y);
  }
  return tops;
}

WornVerdict judge_worn(const DrapeInput& input, const std::optional<dressing::Person>& person,
                       const sewing::GarmentMesh& garment, std::span<const Vec3> x,
                       std::span<const double> tops, const std::vector<OpenSeam>& open) {
  if (!person || x.empty()) return {};
  if (garment.sewn.empty()) return judge_unsewn(input, person->figure, garment, x);
  WornVerdict verdict;
  verdict.worn = is_whole(input, open) ? Worn::kYes : Worn::kPartly;
  const auto add = [&](preflight::FindingKind kind, std::string message, preflight::Concerns about, Vec3 at) {
    verdict.findings.push_back(preflight::found(kind, std::move(message), std::move(about), at));
    verdict.worn = Worn::kNo;
  };
  const dressing::Skeleton skeleton = dressing::skeleton_of(person->figure);
  const std::vector<dressing::WornRing> rings = dressing::worn_rings(garment, x, skeleton);
  for (const dressing::WornRing& ring : rings) {
    if (ring.slit) tell_slit(input, garment, ring, x, verdict);
    if (ring.right) continue;
    add(preflight::FindingKind::kRingOff,
        "the ring of " + preflight::length_text(ring.girth) + " ended around no part of the body",
        pieces_of(input, garment, ring.vertices), x[ring.vertices.front()]);
  }
  const double neck = std::max(person->figure.neck_side[0].y, person->figure.neck_side[1].y);
  for (const auto& [panel, by] : slipped_parts(garment, tops, tops_of(garment, x), neck,
                                               covers_of(input.pattern), person->figure.waist)) {
    add(preflight::FindingKind::kSlipped,
        "what hangs together here slipped " + preflight::length_text(by) +
            " down from where it was put on; something to hold it up is missing, or it is too wide",
        {preflight::piece_named(input.pattern.panels[panel].id)}, x[garment.first_vertex[panel]]);
  }
  for (preflight::Finding& f : out_of_place(input, person->figure, garment, x, tops, rings)) {
    verdict.findings.push_back(std::move(f));
    verdict.worn = Worn::kNo;
  }
  if (const std::optional<Vec3> at = fallen(person->figure, x)) {
    verdict.findings.push_back(on_ground(*at));
    verdict.worn = Worn::kNo;
  }
  return verdict;
}

}  // namespace toile::drape
