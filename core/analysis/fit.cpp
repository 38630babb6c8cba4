#include "core/analysis/fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/analysis/girth.h"
#include "core/base/aabb.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/body/measure/lines.h"
#include "core/body/measure/measures.h"
#include "core/dressing/person.h"

namespace toile::analysis {
namespace {

/// Less is how exactly one sews and measures.
constexpr double kExact = 0.005;  // m
/// Pressure of clothes that nobody minds, Pa. Estimated: a waistband that just fits presses with 0.7 to 1.2
/// kPa (Japanese Journal of Physiological Anthropology 12(1), p. 1), one cut 5 % shorter with 2.3 kPa, and
/// above 4.7 kPa women complained (Sen'i Gakkaishi 47(6), 1991, p. 282).
constexpr double kComfort = 1500;
/// What gives by as much at that pressure is cut narrower than the body; of other cloth nobody would wish it.
constexpr double kStretchCloth = 0.1;

enum class Part { kTrunk, kArm, kLeg };

/// A waistband lies above or below the waist, a short sleeve or hem ends where it ends.
constexpr double kTrunkReach = 0.04, kLimbReach = 0.06, kStep = 0.005;  // m
constexpr double kBelowCrotch = 0.03;                                   // m, where a thigh's girth is taken
/// A skirt or trousers sit below the waist until the hips hold them.
constexpr double kSlip = 0.12;  // m

/// A girth, and how far its plane may be shifted to where the garment has one. m.
struct Place {
  const char* name;  ///< also of body_line
  Part part = Part::kTrunk;
  double up = 0;  ///< from that line
  double reach_down = is_limb() ? kLimbReach : kTrunkReach;

  bool is_limb() const { return part != Part::kTrunk; }
  double reach_up() const { return is_limb() ? kLimbReach : kTrunkReach; }
};

std::vector<Place> places_on(const measure::BodyFigure& f) {
  // body_line has the thigh at its middle.
  const auto thigh_up = [&](int side) {
    return 0.5 * length(f.leg[side].top - f.leg[side].knee) - kBelowCrotch;
  };
  return {{"upper_arm_left", Part::kArm},
          {"upper_arm_right", Part::kArm},
          {"bust"},
          {"waist", Part::kTrunk, 0, kSlip},
          {"hip"},
          {"thigh_left", Part::kLeg, thigh_up(measure::kWearersLeft)},
          {"thigh_right", Part::kLeg, thigh_up(measure::kWearersRight)}};
}

/// Newell's normal.
Vec3 normal_of(const std::vector<Vec3>& loop) {
  Vec3 n;
  for (std::size_t i = 0; i < loop.size(); ++i)
    n += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  return normalized(n);
}

Vec3 middle_of(const std::vector<Vec3>& loop) {
  Vec3 sum;
  for (const Vec3& p : loop) sum += p;
  return sum * (1.0 / static_cast<double>(loop.size()));
}

/// For a limb the other one, or for an arm the trunk: where the plane meets the upright through the crotch.
std::optional<Vec3> other_part(const Place& place, Vec3 inside, Vec3 normal, const measure::BodyFigure& f) {
  if (!place.is_limb()) return std::nullopt;
  if (place.part == Part::kLeg)
    return Vec3{2 * f.middle - inside.x, inside.y, inside.z} +
           normal * (-dot(normal, Vec3{2 * (f.middle - inside.x), 0, 0}));
  if (std::abs(normal.y) < 0.1) return std::nullopt;
  const Vec3 axis{f.middle, 0, (f.leg[0].top.z + f.leg[1].top.z) / 2};
  return axis + Vec3{0, dot(normal, inside - axis) / normal.y, 0};
}

/// Both legs, or an arm with the trunk, are no limb.
bool holds_middle(const std::vector<Vec3>& loop, double middle) {
  const auto [low, high] =
      std::minmax_element(loop.begin(), loop.end(), [](Vec3 a, Vec3 b) { return a.x < b.x; });
  return low->x < middle && high->x > middle;
}

/// The trunk's levels where the tape has them, so that girths are those which bodies and patterns are made
/// to.
void take_levels(const geometry::TriangleMesh& mesh, measure::BodyFigure& figure) {
  const auto taken = measure::measure_body(mesh);
  if (!taken) return;  // in another pose: the figure's own
  figure.bust = taken->points.bust_height;
  figure.waist = taken->points.waist_height;
  figure.hip = taken->points.hip_height;
}

class Tailor {
 public:
  Tailor(const drape::DrapeInput& input, const drape::DrapeResult& result, const dressing::Person& person)
      : input_(input), result_(result), person_(person), cutter_(person.body->mesh) {
    for (const Vec3& p : result.positions) box_.add(p);
  }

  /// The nearest line to where it should be of which `taken` says that it may be.
  template <typename Taken>
  std::optional<FitLine> line(const Place& place, Taken taken) const {
    const int up = steps(place.reach_up()), down = steps(place.reach_down);
    for (int i = 0; i <= std::max(up, down); ++i) {
      if (i <= up)
        if (auto found = line_at(place, i * kStep); found && taken(*found)) return found;
      if (i > 0 && i <= down)
        if (auto found = line_at(place, -i * kStep); found && taken(*found)) return found;
    }
    return std::nullopt;
  }

 private:
  std::optional<FitLine> line_at(const Place& place, double shifted) const {
    const auto loop = measure::body_line(cutter_, person_.figure, place.name, place.up + shifted);
    if (!loop || (place.is_limb() && holds_middle(*loop, person_.figure.middle))) return std::nullopt;
    const Vec3 inside = middle_of(*loop), normal = normal_of(*loop);
    if (!meets_cloth(inside, normal)) return std::nullopt;
    const auto girth =
        girth_around(input_, result_, {inside, normal, other_part(place, inside, normal, person_.figure)});
    if (!girth) return std::nullopt;
    return judged(place, shifted, measure::length_of_loop(*loop), inside, *girth);
  }

  static int steps(double reach) { return static_cast<int>(std::lround(reach / kStep)); }

  bool meets_cloth(Vec3 inside, Vec3 normal) const {
    const Vec3 half = box_.size() * 0.5;
    const double reach =
        std::abs(normal.x) * half.x + std::abs(normal.y) * half.y + std::abs(normal.z) * half.z;
    return std::abs(dot(normal, box_.middle() - inside)) <= reach;
  }

  FitLine judged(const Place& place, double shifted, double body, Vec3 inside, const GarmentGirth& g) const {
    FitLine line;
    line.place = place.name;
    line.shifted = shifted;
    line.body = body;
    line.garment = g.flat;
    line.worn = g.worn;
    line.at = inside;
    line.way = g.way;
    for (const Index p : g.panels) line.pieces.push_back(input_.pattern.panels[p].id);
    // Tension of a ring under pressure: p r.
    const double give = kComfort * body / (2 * kPi) * g.compliance;
    const double taken = give >= kStretchCloth ? g.flat * (1 + give) : g.flat;
    if (taken < body - kExact) {
      line.fit = Fit::kTooTight;
      line.tight_by = body - taken;
    } else if (g.flat < body - kExact) {
      line.fit = Fit::kStretched;
    }
    return line;
  }

  const drape::DrapeInput& input_;
  const drape::DrapeResult& result_;
  const dressing::Person& person_;
  measure::PlaneCutter cutter_;
  Aabb3 box_;
};

/// Seams between sleeves and the rest. A bust's girth is taken below them: at their height a level way runs
/// around the armhole's hollow, or out into the sleeve.
class Armholes {
 public:
  Armholes(const drape::DrapeInput& input, const drape::DrapeResult& result)
      : input_(input), result_(result) {}

  void add_sleeve(const FitLine& around_arm) {
    const sewing::GarmentMesh& g = result_.garment;
    const std::set<std::string> sleeve(around_arm.pieces.begin(), around_arm.pieces.end());
    const auto of_sleeve = [&](Index v) {
      return sleeve.contains(input_.pattern.panels[g.panel_of_vertex[v]].id);
    };
    for (const auto& [a, b] : g.sewn)
      if (of_sleeve(a) != of_sleeve(b)) places_.push_back(result_.positions[a]);
  }

  bool far_from(const std::vector<Vec3>& way) const {
    return std::none_of(way.begin(), way.end(), [&](Vec3 p) {
      return std::any_of(places_.begin(), places_.end(), [&](Vec3 q) { return length(p - q) < kBelow; });
    });
  }

 private:
  static constexpr double kBelow = 0.02;  // m
  const drape::DrapeInput& input_;
  const drape::DrapeResult& result_;
  std::vector<Vec3> places_;  // m
};

std::string centimetres(double m) { return fixed_text(100 * m, 1) + " cm"; }

/// "upper arm left"
std::string words_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Told from where it changes what a girth means.
constexpr double kTold = 0.02;  // m
std::string where_text(double shifted) {
  if (std::abs(shifted) < kTold - 1e-9) return "";
  return " (taken " + centimetres(std::abs(shifted)) + (shifted > 0 ? " above)" : " below)");
}

}  // namespace

std::string_view word_of(Fit fit) {
  switch (fit) {
    case Fit::kTooTight:
      return "too_tight";
    case Fit::kStretched:
      return "stretched";
    case Fit::kFits:
      break;
  }
  return "fits";
}

std::vector<FitLine> fit_table(const drape::DrapeInput& input, const drape::DrapeResult& result) {
  std::vector<FitLine> table;
  if (result.worn == drape::Worn::kNobody || result.positions.empty()) return table;
  std::optional<dressing::Person> person = dressing::find_person(result.bodies);
  if (!person) return table;
  take_levels(person->body->mesh, person->figure);
  const Tailor tailor(input, result, *person);
  Armholes armholes(input, result);
  for (const Place& place : places_on(person->figure)) {
    auto line =
        tailor.line(place, [&](const FitLine& l) { return place.is_limb() || armholes.far_from(l.way); });
    if (!line) line = tailor.line(place, [](const FitLine&) { return true; });
    if (!line) continue;
    if (place.part == Part::kArm) armholes.add_sleeve(*line);
    table.push_back(std::move(*line));
  }
  return table;
}

std::string fit_text(const FitLine& line) {
  const std::string place = words_of(line.place) + where_text(line.shifted) + " ";
  switch (line.fit) {
    case Fit::kTooTight:
      return place + centimetres(line.tight_by) + " too tight";
    case Fit::kStretched:
      return place + centimetres(-line.ease()) + " narrower than the body, the cloth stretches by " +
             fixed_text(100 * (line.body / line.garment - 1), 0) + " %";
    case Fit::kFits:
      break;
  }
  return place + centimetres(std::max(0.0, line.ease())) + " of ease";
}

preflight::Findings find_too_tight(const std::vector<FitLine>& table) {
  preflight::Findings findings;
  for (const FitLine& line : table) {
    if (line.fit != Fit::kTooTight) continue;
    preflight::Concerns about;
    for (const std::string& piece : line.pieces) about.push_back(preflight::piece_named(piece));
    findings.push_back(preflight::found(preflight::FindingKind::kTooTight,
                                        fit_text(line) + ": the pieces measure " + centimetres(line.garment) +
                                            " around a body of " + centimetres(line.body) +
                                            "; make them wider there, or take cloth that stretches",
                                        std::move(about), line.at));
  }
  return findings;
}

}  // namespace toile::analysis
