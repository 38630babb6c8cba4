#include "core/dressing/staging.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/distance.h"

namespace toile::dressing {

namespace {

constexpr double kNearArm = 0.3;    // m from the arm's line to a sleeve's middle, at most
constexpr double kAside = 0.03;     // m beyond the armpit where sleeves begin
constexpr double kTrunkTop = 0.35;  // of the way from waist to armpit, that pieces of the trunk reach
constexpr double kWide = 0.4;       // m from the middle: hands hang in the way of what is wider,
constexpr double kBelowHands = 0.05, kFarOff = 0.8;  // m, from where much wider things are in nobody's way
constexpr double kNarrowed = 0.3;                    // and it is drawn in to this
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
  return std::abs(p.x - f.middle) > std::abs(f.armpit[side].x - f.middle) + kAside &&
         distance_to_line(p, {arm.root, arm.elbow, arm.wrist, arm.tip}) < kNearArm;
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

/// Upwards, across each arm's line, from the middle of what is to go around it: left, right. m.
std::array<Vec3, 2> ways_to_arms(const sewing::Assembly& assembly, std::span<const Covers> covers,
                                 const measure::BodyFigure& f) {
  std::array<Vec3, 2> sum{}, way{};
  std::array<double, 2> count{};
  for (std::size_t i = 0; i < assembly.positions.size(); ++i) {
    if (covers[static_cast<std::size_t>(assembly.garment.panel_of_vertex[i])] != Covers::kArm) continue;
    const std::size_t side = assembly.positions[i].x > f.middle ? 0 : 1;
    sum[side] += assembly.positions[i];
    count[side] += 1;
  }
  for (std::size_t side = 0; side < 2; ++side) {
    if (count[side] == 0) continue;
    const Vec3 along = f.arm[side].along();
    const Vec3 across = normalized(cross(along, {0, 0, 1}));
    way[side] = across * dot(f.arm[side].elbow - sum[side] * (1 / count[side]), across);
  }
  return way;
}

}  // namespace

std::vector<Covers> covers_of(const sewing::Assembly& assembly, const measure::BodyFigure& f) {
  const double trunk_top = f.waist + kTrunkTop * (f.armpit[0].y - f.waist);
  std::vector<Covers> covers;
  for (std::size_t p = 0; p + 1 < assembly.garment.first_vertex.size(); ++p) {
    const Extent e = extent_of(assembly, p, f.middle);
    const bool wheel = e.low < f.crotch && e.aside > kWide;  // a circle skirt's reach up beside the trunk
    covers.push_back(at_arm(e.middle, f)            ? Covers::kArm
                     : e.middle.y > f.shoulder[0].y ? Covers::kNeck
                     : e.high < trunk_top || wheel  ? Covers::kBelow
                                                    : Covers::kTrunk);
  }
  return covers;
}

std::vector<Vec3> staged(const sewing::Assembly& assembly, std::span<const Covers> covers,
                         const measure::BodyFigure& figure, const Staging& staging) {
  std::vector<Vec3> x = assembly.positions;
  const Narrowing narrow = staging.below_narrow ? narrowing_of(assembly, covers, figure) : Narrowing{};
  const Vec3 top{figure.middle, narrow.top, 0}, waist{figure.middle, figure.waist, 0};
  const bool on_trunk = std::find(covers.begin(), covers.end(), Covers::kTrunk) != covers.end();
  const double lift = on_trunk ? staging.lift : staging.lift_others;
  const std::array<Vec3, 2> to_arm = ways_to_arms(assembly, covers, figure);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Covers part = covers[static_cast<std::size_t>(assembly.garment.panel_of_vertex[i])];
    if (part == Covers::kArm && staging.arms_centred) {
      x[i] += to_arm[x[i].x > figure.middle ? 0 : 1];
      continue;
    }
    if (part == Covers::kBelow && narrow.share < 1) x[i] = waist + (x[i] - top) * narrow.share;
    x[i].y += lift;
  }
  return x;
}

}  // namespace toile::dressing
