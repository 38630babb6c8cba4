#include "core/dressing/shoulders.h"

#include <algorithm>
#include <cmath>

#include "core/dressing/staging.h"

namespace toile::dressing {

namespace {

/// Shares of the ridge from the neck to the shoulder's outer end: collars stand nearer to the neck, sleeves
/// begin farther out.
constexpr double kFromNeck = 0.15, kToArm = 1.05, kBeyond = 1.4;
constexpr double kAcross = 0.04, kBelow = 0.01, kWider = 0.02;  // m from the ridge: to front and back, down

/// Cloth is on a shoulder where it crosses the ridge from the neck to the shoulder's outer end within this
/// share of it: straps that have slid hang over the arm's root, beyond 0.85 in what was looked at, others
/// within 0.75.
constexpr double kInnerShoulder = 0.8;
/// m from the straight line between the ridge's ends: below, above (the neck's muscle), and across.
constexpr double kBelowRidge = 0.02, kAboveRidge = 0.06, kAcrossRidge = 0.04;

constexpr double kBackIn = 3e-3, kLowering = 4e-3, kShift = 2e-3;  // m at a time
/// Share of the ridge within which cloth on a shoulder stays there.
constexpr double kStays = 0.6;

/// Where a place is beside the ridge of the shoulder on its side.
struct AtRidge {
  double share = -1;  ///< of the way from the neck to the outer end
  Vec3 off;           ///< m
};

AtRidge at_ridge(const measure::BodyFigure& figure, Vec3 p) {
  const std::size_t side = p.x > figure.middle ? measure::kWearersLeft : measure::kWearersRight;
  const Vec3 neck = figure.neck_side[side], ridge = figure.shoulder[side] - neck;
  if (ridge.x == 0) return {};
  const double share = (p.x - neck.x) / ridge.x;
  return {share, p - (neck + ridge * share)};
}

/// Whether a piece that is none for an arm was placed at the height of that shoulder.
bool placed_above(const sewing::Assembly& assembly, const measure::BodyFigure& figure, std::size_t side) {
  const std::vector<Covers> covers = covers_of(assembly, figure);
  for (std::size_t v = 0; v < assembly.positions.size(); ++v) {
    const Covers part = covers[static_cast<std::size_t>(assembly.garment.panel_of_vertex[v])];
    if (part != Covers::kArm && assembly.positions[v].y >= figure.shoulder[side].y) return true;
  }
  return false;
}

}  // namespace

bool lies_on_shoulder(const measure::BodyFigure& figure, std::size_t side, std::span<const Vec3> x) {
  const Vec3 neck = figure.neck_side[side], ridge = figure.shoulder[side] - neck;
  if (ridge.x == 0) return true;  // no shoulder to slide off
  return std::any_of(x.begin(), x.end(), [&](Vec3 p) {
    const double share = (p.x - neck.x) / ridge.x;
    const Vec3 off = p - (neck + ridge * share);
    return share >= 0 && share <= kInnerShoulder && off.y >= -kBelowRidge && off.y <= kAboveRidge &&
           std::abs(off.z) <= kAcrossRidge;
  });
}

bool has_armhole(std::span<const WornRing> rings, std::size_t side) {
  Enclosure arm;
  arm.times[side == measure::kWearersLeft ? kLeftArm : kRightArm] = 1;
  return std::any_of(rings.begin(), rings.end(), [&](const WornRing& ring) { return ring.around == arm; });
}

int bared_shoulders(const sewing::Assembly& assembly, const measure::BodyFigure& figure,
                    std::span<const WornRing> rings, std::span<const Vec3> x) {
  int bared = 0;
  for (const std::size_t side : {measure::kWearersLeft, measure::kWearersRight})
    bared += has_armhole(rings, side) && placed_above(assembly, figure, side) &&
             !lies_on_shoulder(figure, side, x);
  return bared;
}

bool is_over_shoulder(const measure::BodyFigure& figure, Vec3 p) {
  const AtRidge at = at_ridge(figure, p);
  return at.share > kFromNeck && at.share < kBeyond && std::abs(at.off.z) < kAcross + kWider &&
         at.off.y > -kBelow - kWider;
}

bool goes_over_shoulders(const measure::BodyFigure& figure, std::span<const Vec3> x) {
  return std::any_of(x.begin(), x.end(), [&](Vec3 p) { return is_over_shoulder(figure, p); });
}

std::optional<double> room_over_shoulders(const measure::BodyFigure& figure, const SlimFigure& body,
                                          std::span<const Vec3> x) {
  std::optional<double> least;
  for (const Vec3 p : x) {
    const AtRidge at = at_ridge(figure, p);
    if (at.share < kFromNeck || at.share > kToArm || std::abs(at.off.z) > kAcross || at.off.y < -kBelow)
      continue;
    least = std::min(least.value_or(HUGE_VAL), std::max(0.0, body.clearance(p)));
  }
  return least;
}

double off_centre(const measure::BodyFigure& figure, std::span<const Vec3> x) {
  std::array<double, 2> inner{HUGE_VAL, HUGE_VAL};
  for (const Vec3 p : x) {
    if (!is_over_shoulder(figure, p)) continue;
    double& least = inner[p.x > figure.middle ? measure::kWearersLeft : measure::kWearersRight];
    least = std::min(least, at_ridge(figure, p).share);
  }
  const double left = inner[measure::kWearersLeft], right = inner[measure::kWearersRight];
  const double farther = std::max(left, right);
  if (farther == HUGE_VAL || farther < kStays) return 0;
  return 0.5 * (left - right) * std::abs(figure.shoulder[0].x - figure.neck_side[0].x);
}

OnShoulders::OnShoulders(const sewing::Assembly& assembly, const Wearer& wearer,
                         std::span<const Index> vertex_of, Index count)
    : wearer_(wearer),
      aside_(static_cast<std::size_t>(count), 0),
      hangs_(static_cast<std::size_t>(count), false) {
  const sewing::GarmentMesh& g = assembly.garment;
  const std::vector<Covers> covers = covers_of(assembly, wearer.figure());
  for (Index i = 0; i < g.vertex_count(); ++i) {
    if (covers[static_cast<std::size_t>(g.panel_of_vertex[i])] == Covers::kArm) continue;
    const Index v = vertex_of[i];
    hangs_[v] = true;
    aside_[v] = std::max(aside_[v], std::abs(assembly.positions[i].x - wearer.figure().middle));
  }
}

void OnShoulders::hold_in(std::vector<Vec3>& x) const {
  const double middle = wearer_.figure().middle;
  for (std::size_t v = 0; v < x.size(); ++v) {
    const double out = std::abs(x[v].x - middle) - aside_[v];
    if (!hangs_[v] || out <= 0 || !is_over_shoulder(wearer_.figure(), x[v])) continue;
    x[v].x += std::copysign(std::min(out, kBackIn), middle - x[v].x);
  }
}

void OnShoulders::let_down(std::vector<Vec3>& x) const {
  const double room = room_over_shoulders(wearer_.figure(), wearer_.slim(0), x).value_or(0);
  for (std::size_t v = 0; v < x.size(); ++v)
    if (hangs_[v]) x[v].y -= std::min(kLowering, room);
}

void OnShoulders::centre(std::vector<Vec3>& x) const {
  const measure::BodyFigure& f = wearer_.figure();
  std::vector<Vec3> hanging;
  for (std::size_t v = 0; v < x.size(); ++v)
    if (hangs_[v]) hanging.push_back(x[v]);
  const double back = std::clamp(-off_centre(f, hanging), -kShift, kShift);
  const double from = f.waist, to = std::min(f.armpit[0].y, f.armpit[1].y);
  for (std::size_t v = 0; v < x.size(); ++v)
    if (hangs_[v]) x[v].x += back * std::clamp((x[v].y - from) / (to - from), 0.0, 1.0);
}

}  // namespace toile::dressing
