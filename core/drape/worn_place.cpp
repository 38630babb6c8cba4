#include "core/drape/worn_place.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

#include "core/dressing/shoulders.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::drape {
namespace {

/// Bodices reach at least as high between waist (0) and bust (1); those that only hang on the hips do not.
constexpr double kLowestTop = 0.3;
constexpr double kWiderThanArmhole = 1.15;  // openings for head and arm are wider than this
constexpr double kFarFromArm = 0.15;        // m, from the arm's middle line to the nearest of a sleeve

std::span<const Vec3> panel_of(const sewing::GarmentMesh& garment, std::span<const Vec3> x, std::size_t p) {
  const auto first = static_cast<std::size_t>(garment.first_vertex[p]);
  return x.subspan(first, static_cast<std::size_t>(garment.first_vertex[p + 1]) - first);
}

dressing::Enclosure around(std::initializer_list<dressing::Limb> limbs) {
  dressing::Enclosure these;
  for (const dressing::Limb limb : limbs) these.times[limb] = 1;
  return these;
}

/// The other's armhole, where the head goes through this ring together with one arm alone.
std::optional<dressing::Limb> beside_head(const dressing::WornRing& ring) {
  if (ring.around == around({dressing::kHead, dressing::kLeftArm})) return dressing::kRightArm;
  if (ring.around == around({dressing::kHead, dressing::kRightArm})) return dressing::kLeftArm;
  return std::nullopt;
}

/// What bares one shoulder is open from the neck over the arm, wider than the armhole across by all of a
/// neck. An opening as wide as that armhole is the other armhole, and the head should have one of its own.
bool head_in_armhole(const dressing::WornRing& ring, std::span<const dressing::WornRing> rings) {
  const std::optional<dressing::Limb> other = beside_head(ring);
  return other && std::any_of(rings.begin(), rings.end(), [&](const dressing::WornRing& r) {
           return r.around == around({*other}) && ring.girth < kWiderThanArmhole * r.girth;
         });
}

/// Both arms are in the garment, and neither head nor legs. The border of a jacket that is open in front goes
/// around the arms alone, too, but along the neck; a hem does not.
bool head_in_nothing(const measure::BodyFigure& figure, const dressing::WornRing& ring,
                     std::span<const Vec3> x) {
  if (!(ring.around == around({dressing::kLeftArm, dressing::kRightArm}))) return false;
  const double armpits = std::min(figure.armpit[0].y, figure.armpit[1].y);
  return std::none_of(ring.vertices.begin(), ring.vertices.end(), [&](Index v) { return x[v].y > armpits; });
}

void tell_neck_shut(const DrapeInput& input, const measure::BodyFigure& figure,
                    const sewing::GarmentMesh& garment, std::span<const Vec3> x,
                    std::span<const dressing::WornRing> rings, preflight::Findings& findings) {
  for (const dressing::WornRing& ring : rings) {
    const bool in_armhole = head_in_armhole(ring, rings);
    if (!in_armhole && !head_in_nothing(figure, ring, x)) continue;
    preflight::Concerns about;
    for (const Index v : ring.vertices) {
      preflight::Concern piece = preflight::piece_named(input.pattern.panels[garment.panel_of_vertex[v]].id);
      if (std::find(about.begin(), about.end(), piece) == about.end()) about.push_back(std::move(piece));
    }
    findings.push_back(preflight::found(
        preflight::FindingKind::kNeckShut,
        std::string(in_armhole ? "the head goes through an armhole together with the arm"
                               : "the arms are in the garment, but neither the head nor the legs") +
            ": its neck is sewn shut or too narrow; take the seam there away",
        std::move(about), x[ring.vertices.front()]));
  }
}

/// Whether a piece that is none of a sleeve began at the height of that shoulder.
bool began_on_shoulder(const DrapeInput& input, const measure::BodyFigure& figure, std::size_t side,
                       std::span<const double> tops) {
  for (std::size_t p = 0; p < tops.size(); ++p)
    if (tops[p] >= figure.shoulder[side].y && !seams::words_of(input.pattern.panels[p].id).limb) return true;
  return false;
}

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double t = std::clamp(dot(p - a, along) / std::max(1e-12, dot(along, along)), 0.0, 1.0);
  return length(p - (a + along * t));
}

double distance_to_arms(const measure::BodyFigure& figure, std::span<const Vec3> x) {
  double least = HUGE_VAL;
  for (const measure::ArmLine& arm : figure.arm)
    for (const Vec3 p : x)
      least = std::min({least, distance_to_segment(p, arm.root, arm.elbow),
                        distance_to_segment(p, arm.elbow, arm.wrist),
                        distance_to_segment(p, arm.wrist, arm.tip)});
  return least;
}

double highest_of(std::span<const Vec3> x) {
  double high = -HUGE_VAL;
  for (const Vec3 p : x) high = std::max(high, p.y);
  return high;
}

/// Pieces whose names say for what of the body they are.
void tell_strayed(const DrapeInput& input, const measure::BodyFigure& figure,
                  const sewing::GarmentMesh& garment, std::span<const Vec3> x,
                  preflight::Findings& findings) {
  const double lowest = figure.waist + kLowestTop * (figure.bust - figure.waist);
  for (std::size_t p = 0; p < input.pattern.panels.size(); ++p) {
    const std::string& id = input.pattern.panels[p].id;
    const seams::PieceWords words = seams::words_of(id);
    const std::span<const Vec3> piece = panel_of(garment, x, p);
    const bool low = words.kind == seams::PieceKind::kTorso && highest_of(piece) < lowest;
    const bool off = words.kind == seams::PieceKind::kSleeve && distance_to_arms(figure, piece) > kFarFromArm;
    if (!low && !off) continue;
    findings.push_back(preflight::found(
        preflight::FindingKind::kElsewhere,
        low ? "by its name the piece is for the chest, but it ended below; see to its seams, and to its place"
            : "by its name the piece is for an arm, but none is near; see to its seams, and to its place",
        {preflight::piece_named(id)}, piece.front()));
  }
}

}  // namespace

preflight::Findings out_of_place(const DrapeInput& input, const measure::BodyFigure& figure,
                                 const sewing::GarmentMesh& garment, std::span<const Vec3> x,
                                 std::span<const double> tops, std::span<const dressing::WornRing> rings) {
  preflight::Findings findings;
  for (const std::size_t side : {measure::kWearersLeft, measure::kWearersRight}) {
    const bool left = side == measure::kWearersLeft;
    if (!dressing::has_armhole(rings, side)) continue;
    if (dressing::lies_on_shoulder(figure, side, x) || !began_on_shoulder(input, figure, side, tops))
      continue;
    findings.push_back(preflight::found(preflight::FindingKind::kOffShoulder,
                                        std::string("the garment has slid off the ") +
                                            (left ? "left" : "right") +
                                            " shoulder; it is too wide there, or its neck is",
                                        {}, figure.shoulder[side]));
  }
  tell_strayed(input, figure, garment, x, findings);
  tell_neck_shut(input, figure, garment, x, rings, findings);
  return findings;
}

}  // namespace toile::drape
