#include "core/dressing/staging.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/dressing/cut_on_sleeves.h"
#include "core/dressing/long_strips.h"
#include "core/geometry/distance.h"

namespace toile::dressing {

namespace {

constexpr double kNearArm = 0.3;    // m from the arm's line to a sleeve's middle, at most
constexpr double kSidePanel = 2;    // times as far from it as from the armpit: then it is the trunk's
constexpr double kAside = 0.03;     // m beyond the armpit where sleeves begin
constexpr double kTrunkTop = 0.35;  // of the way from waist to armpit, that pieces of the trunk reach
constexpr double kWide = 0.4;       // m from the middle: hands hang in the way of what is wider,
constexpr double kBelowHands = 0.05, kFarOff = 0.8;  // m, from where much wider things are in nobody's way
constexpr double kNarrowed = 0.3;                    // and it is drawn in to this
constexpr double kHips = 1.4;          // armpits' distance from the middle, from where skirts are folded down
constexpr double kHigher = 0.03;       // m, that the middle of what holds a piece lies above the piece's
constexpr double kInsideHands = 0.12;  // m, that they pass hands by
constexpr double kPastWrist = 0.03, kUpArm = 0.15;  // m, that cuffs begin beyond; that sleeves move at most
constexpr double kSleeved = 2;       // times as wide as the armpits, from where a piece has sleeves
constexpr double kNarrowest = 0.35;  // share of its size that a piece keeps: cloth gives way no further

double distance_to_line(Vec3 p, std::initializer_list<Vec3> corners) {
  double least = 1e9;
  for (const Vec3* c = corners.begin(); c + 1 != corners.end(); ++c) {
    const Vec3 d = c[1] - c[0];
    const double t = std::clamp(dot(p - c[0], d) / std::max(1e-12, dot(d, d)), 0.0, 1.0);
    least = std::min(least, length(p - c[0] - d * t));
  }
  return least;
}

bool at_arm(Vec3 p, const measure::BodyFigure& f) {
  const std::size_t side = p.x > f.middle ? 0 : 1;
  const measure::ArmLine& arm = f.arm[side];
  // Side panels of a bodice lie beyond the armpit as well while they are flat, but nearer to it than to the
  // arm.
  const double beyond = std::abs(p.x - f.middle) - std::abs(f.armpit[side].x - f.middle);
  return beyond > kAside && distance_to_line(p, {arm.root, arm.elbow, arm.wrist, arm.tip}) <
                                std::min(kNearArm, kSidePanel * beyond);
}

/// Where a piece is placed.
struct Extent {
  Vec3 middle;
  double low = 1e9, high = -1e9, aside = 0;  ///< m: heights, and farthest from the body's middle plane
};

Extent extent_of(const sewing::Assembly& assembly, std::size_t piece, double middle) {
  const sewing::GarmentMesh& g = assembly.garment;
  Extent e;
  for (Index v = g.first_vertex[piece]; v < g.first_vertex[piece + 1]; ++v) {
    const Vec3 p = assembly.positions[v];
    e.middle += p;
    e.low = std::min(e.low, p.y);
    e.high = std::max(e.high, p.y);
    e.aside = std::max(e.aside, std::max(std::abs(p.x - middle), std::abs(p.z)));
  }
  e.middle = e.middle * (1.0 / std::max<Index>(1, g.first_vertex[piece + 1] - g.first_vertex[piece]));
  return e;
}

/// How much narrower what lies below the waist begins, so that it passes the hands; 1 where it does anyway.
struct Narrowing {
  double share = 1;
  double top = 0;  ///< m, the highest place of those pieces
};

Narrowing narrowing_of(const sewing::Assembly& assembly, std::span<const Covers> covers,
                       const measure::BodyFigure& f) {
  const double hands = std::min(f.arm[0].tip.y, f.arm[1].tip.y) - kBelowHands;
  double widest = 0, top = -1e9;
  bool in_the_way = false;
  for (std::size_t i = 0; i < assembly.positions.size(); ++i) {
    if (covers[static_cast<std::size_t>(assembly.garment.panel_of_vertex[i])] != Covers::kBelow) continue;
    const Vec3 p = assembly.positions[i];
    const double aside = std::max(std::abs(p.x - f.middle), std::abs(p.z));
    widest = std::max(widest, aside);
    top = std::max(top, p.y);
    in_the_way |= aside > (p.y > hands ? kWide : kFarOff);
  }
  return {in_the_way ? std::max(kNarrowest, kNarrowed / widest) : 1, top};
}

/// What hangs from something turns down about the middle of the edge that it hangs by: discs become sectors
/// that close inside the hands. Lengths downwards stay what they are; cloth is drawn together around the body
/// alone.
struct Folding {
  std::vector<std::optional<Vec3>> hangs_by;  ///< of each panel, m
  double share = 1;                           ///< of each place's angle from straight down
};

double angle_from_down(Vec3 from, Vec3 p) {
  return std::atan2(std::hypot(p.x - from.x, p.z - from.z), from.y - p.y);
}

/// Middles of the edges by which pieces below the waist hang from higher ones.
std::vector<std::optional<Vec3>> held_edges(const sewing::Assembly& assembly, std::span<const Covers> covers,
                                            std::span<const Extent> extents) {
  const sewing::GarmentMesh& g = assembly.garment;
  std::vector<Vec3> sum(covers.size());
  std::vector<int> count(covers.size(), 0);
  for (const auto& [i, j] : g.sewn) {
    const bool first_lower = extents[static_cast<std::size_t>(g.panel_of_vertex[i])].middle.y <
                             extents[static_cast<std::size_t>(g.panel_of_vertex[j])].middle.y;
    const Index low = first_lower ? i : j, high = first_lower ? j : i;
    const auto p = static_cast<std::size_t>(g.panel_of_vertex[low]);
    const auto q = static_cast<std::size_t>(g.panel_of_vertex[high]);
    if (covers[p] != Covers::kBelow || extents[q].middle.y - extents[p].middle.y < kHigher) continue;
    sum[p] += assembly.positions[low];
    ++count[p];
  }
  std::vector<std::optional<Vec3>> middles(covers.size());
  for (std::size_t p = 0; p < sum.size(); ++p)
    if (count[p] > 0) middles[p] = sum[p] * (1.0 / count[p]);
  return middles;
}

/// Nothing where what is wide hangs from nothing.
std::optional<Folding> folding_of(const sewing::Assembly& assembly, std::span<const Covers> covers,
                                  const measure::BodyFigure& f) {
  const sewing::GarmentMesh& g = assembly.garment;
  std::vector<Extent> extents;
  for (std::size_t p = 0; p < covers.size(); ++p) extents.push_back(extent_of(assembly, p, f.middle));
  Folding folding{held_edges(assembly, covers, extents), 1};
  double steepest = 1e-6, inside = HUGE_VAL;  // radians: of the cloth, and of what passes the hands
  for (std::size_t p = 0; p < covers.size(); ++p) {
    if (covers[p] != Covers::kBelow) continue;
    if (!folding.hangs_by[p]) {
      if (extents[p].aside > kWide) return std::nullopt;
      continue;
    }
    const Vec3 from = *folding.hangs_by[p];
    for (Index v = g.first_vertex[p]; v < g.first_vertex[p + 1]; ++v)
      steepest = std::max(steepest, angle_from_down(from, assembly.positions[v]));
    for (const measure::ArmLine& arm : f.arm) {
      const double room = std::max(0.0, std::abs(arm.wrist.x - f.middle) - kInsideHands);
      inside = std::min(inside, angle_from_down(from, {from.x + room, arm.tip.y, from.z}));
    }
  }
  folding.share = std::clamp(inside / steepest, kNarrowest, 1.0);
  return folding;
}

Vec3 folded(const std::optional<Vec3>& hangs_by, double share, Vec3 p) {
  if (!hangs_by) return p;
  const Vec3 way = p - *hangs_by;
  const double aside = std::hypot(way.x, way.z), angle = share * angle_from_down(*hangs_by, p);
  const double out = aside > 0 ? length(way) * std::sin(angle) / aside : 0;
  return *hangs_by + Vec3{way.x * out, -length(way) * std::cos(angle), way.z * out};
}

/// How much narrower what lies on the trunk begins, so that its sides close below the arms. What reaches far
/// beyond the armpits is meant to go along the arms.
double narrowing_of_trunk(const sewing::Assembly& assembly, std::span<const Covers> covers,
                          const measure::BodyFigure& f) {
  double widest = 0;
  for (std::size_t i = 0; i < assembly.positions.size(); ++i)
    if (covers[static_cast<std::size_t>(assembly.garment.panel_of_vertex[i])] == Covers::kTrunk)
      widest = std::max(widest, std::abs(assembly.positions[i].x - f.middle));
  const double room = f.armpit[0].x - f.middle;
  return widest > room && widest < kSleeved * room ? room / widest : 1;
}

/// Where an arm's middle line is at `along` metres from its root, measured straight towards the wrist.
Vec3 on_line(const measure::ArmLine& arm, double along) {
  const Vec3 way = arm.along();
  const std::array<Vec3, 4> corners{arm.root, arm.elbow, arm.wrist, arm.tip};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double from = dot(corners[i] - arm.root, way), to = dot(corners[i + 1] - arm.root, way);
    if (along > to && i + 2 < corners.size()) continue;
    return corners[i] + (corners[i + 1] - corners[i]) * ((along - from) / std::max(1e-6, to - from));
  }
  return arm.root;
}

/// What moves pieces for an arm so that its line runs in their middle, and so that cuffs are no farther out
/// than its wrist: hands are in their way. m.
Vec3 to_arm(const std::vector<Vec3>& cloth, const measure::ArmLine& arm) {
  if (cloth.empty()) return {};
  const Vec3 way = arm.along(), across = normalized(cross(way, {0, 0, 1}));
  double longest = 0, sum = 0;
  for (const Vec3 p : cloth) longest = std::max(longest, dot(p - arm.root, way));
  const double up = std::clamp(longest - dot(arm.wrist - arm.root, way) - kPastWrist, 0.0, kUpArm);
  for (const Vec3 p : cloth) sum += dot(on_line(arm, dot(p - arm.root, way) - up) - p, across);
  return across * (sum / static_cast<double>(cloth.size())) - way * up;
}

/// Left, right.
std::array<Vec3, 2> ways_to_arms(const sewing::Assembly& assembly, std::span<const Covers> covers,
                                 const measure::BodyFigure& f) {
  std::array<std::vector<Vec3>, 2> cloth;
  for (std::size_t i = 0; i < assembly.positions.size(); ++i) {
    if (covers[static_cast<std::size_t>(assembly.garment.panel_of_vertex[i])] != Covers::kArm) continue;
    cloth[assembly.positions[i].x > f.middle ? 0 : 1].push_back(assembly.positions[i]);
  }
  return {to_arm(cloth[0], f.arm[0]), to_arm(cloth[1], f.arm[1])};
}

/// Whether a piece stands around the neck, rather than flat before or behind it.
bool is_round(const sewing::Assembly& assembly, std::size_t piece) {
  constexpr double kFlat = 0.03;  // m
  const sewing::GarmentMesh& g = assembly.garment;
  double front = -1e9, back = 1e9;
  for (Index v = g.first_vertex[piece]; v < g.first_vertex[piece + 1]; ++v) {
    front = std::max(front, assembly.positions[v].z);
    back = std::min(back, assembly.positions[v].z);
  }
  return front - back > kFlat;
}

/// How far each piece is lifted, m. What goes around the neck begins under the chin: the head's line turns
/// out through the face (skeleton_of), and what comes above that would never come down. Hoods begin around
/// it.
std::vector<double> lifts_of(const sewing::Assembly& assembly, std::span<const Covers> covers,
                             const measure::BodyFigure& f, double lift) {
  std::vector<double> lifts(covers.size(), lift);
  for (std::size_t p = 0; p < covers.size(); ++p) {
    const double high = extent_of(assembly, p, f.middle).high;
    if (covers[p] == Covers::kNeck && is_round(assembly, p) && high < 0.5 * (f.chin + f.top))
      lifts[p] = std::clamp(f.chin - high, 0.0, lift);
  }
  return lifts;
}

}  // namespace

bool are_along_arms(std::span<const Covers> covers, CutOn sleeves) {
  return sleeves == CutOn::kAlongArms ||
         (sleeves == CutOn::kAlongFreeArms &&
          std::find(covers.begin(), covers.end(), Covers::kArm) == covers.end());
}

std::vector<Covers> covers_of(const sewing::Assembly& assembly, const measure::BodyFigure& f, CutOn sleeves) {
  const double trunk_top = f.waist + kTrunkTop * (f.armpit[0].y - f.waist);
  std::vector<Covers> covers;
  std::vector<std::size_t> wide;
  for (std::size_t p = 0; p + 1 < assembly.garment.first_vertex.size(); ++p) {
    const Extent e = extent_of(assembly, p, f.middle);
    const bool wheel = e.low < f.crotch && e.aside > kWide;  // a circle skirt's reach up beside the trunk
    covers.push_back(at_arm(e.middle, f)            ? Covers::kArm
                     : e.middle.y > f.shoulder[0].y ? Covers::kNeck
                     : e.high < trunk_top || wheel  ? Covers::kBelow
                                                    : Covers::kTrunk);
    if (wheel && covers.back() == Covers::kBelow && e.high >= trunk_top) wide.push_back(p);
  }
  if (!are_along_arms(covers, sleeves)) return covers;
  for (const std::size_t p : wide)
    if (has_cut_on_sleeves(assembly, p, f)) covers[p] = Covers::kTrunk;
  return covers;
}

std::vector<Vec3> staged(const sewing::Assembly& assembly, std::span<const Covers> covers,
                         const measure::BodyFigure& figure, const Staging& staging) {
  std::vector<Vec3> x = assembly.positions;
  const Narrowing narrow =
      staging.below != Wide::kAsPlaced ? narrowing_of(assembly, covers, figure) : Narrowing{};
  const std::optional<Folding> folding =
      staging.below == Wide::kFolded ? folding_of(assembly, covers, figure) : std::nullopt;
  const Vec3 top{figure.middle, narrow.top, 0}, waist{figure.middle, figure.waist, 0};
  const bool on_trunk = std::find(covers.begin(), covers.end(), Covers::kTrunk) != covers.end();
  const std::vector<double> lifts =
      lifts_of(assembly, covers, figure, on_trunk ? staging.lift : staging.lift_others);
  const double trunk = staging.trunk_narrow ? narrowing_of_trunk(assembly, covers, figure) : 1;
  const std::array<Vec3, 2> to_arms = ways_to_arms(assembly, covers, figure);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto piece = static_cast<std::size_t>(assembly.garment.panel_of_vertex[i]);
    const Covers part = covers[piece];
    if (part == Covers::kArm && staging.arms_centred) {
      x[i] += to_arms[x[i].x > figure.middle ? 0 : 1];
      continue;
    }
    if (part == Covers::kTrunk) x[i].x = figure.middle + (x[i].x - figure.middle) * trunk;
    if (part == Covers::kBelow && narrow.share < 1)
      x[i] = folding ? folded(folding->hangs_by[piece], folding->share, x[i])
                     : waist + (x[i] - top) * narrow.share;
    x[i].y += lifts[piece];
  }
  if (are_along_arms(covers, staging.sleeves)) lay_along_arms(assembly, covers, figure, x);
  lay_on_stitches(assembly, covers, x);
  return x;
}

}  // namespace toile::dressing
