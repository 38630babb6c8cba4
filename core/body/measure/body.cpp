// The tape's way over a standing body: middle, armpit and crotch, which all the rest is found from; the other
// tapes go on from there.

#include <algorithm>
#include <cmath>

#include "core/body/measure/arm_tape.h"
#include "core/body/measure/cut_points.h"
#include "core/body/measure/leg_tape.h"
#include "core/body/measure/measures.h"
#include "core/body/measure/mesh_cut.h"
#include "core/body/measure/neck_tape.h"
#include "core/body/measure/trunk_levels.h"
#include "core/body/measure/trunk_tape.h"

namespace toile::measure {
namespace {

// Shares of the stature.
constexpr double kRibs = 0.66;         // below a grown-up's armpit, above any waist that matters here
constexpr double kLowRibs = 0.60;      // the same of small children, who have arms at the former
constexpr double kArmsBroaden = 1.35;  // the trunk's breadth grows so much where arms join it

/// x of the plane of symmetry.
double middle_plane(const MeshCutter& level, double stature) {
  double least = HUGE_VAL, middle = 0;  // breadth: at one of the levels an arm may have joined the trunk
  for (const double share : {kRibs, kLowRibs}) {
    const std::vector<Vec3> ribs = middle_points(level.at(share * stature), 0);
    const double x = middle_of(ribs).x;
    double breadth = 0;
    for (const Vec3& p : ribs) breadth = std::max(breadth, std::abs(p.x - x));
    if (!ribs.empty() && breadth < least) {
      least = breadth;
      middle = x;
    }
  }
  return middle;
}

/// Upwards from the ribs, to where arms join the trunk.
Vec3 armpit_of(const TrunkLevels& levels) {
  const std::vector<TrunkLevel>& trunk = levels.all();
  std::size_t ribs = levels.index_of(kRibs * levels.stature());
  const std::size_t low_ribs = levels.index_of(kLowRibs * levels.stature());
  if (trunk[ribs].half > kArmsBroaden * trunk[low_ribs].half) ribs = low_ribs;
  std::size_t i = ribs;
  while (i + 1 < trunk.size() && trunk[i + 1].half < kArmsBroaden * trunk[ribs].half) ++i;
  double low = trunk[i].y, high = low + levels.step();
  for (int round = 0; round < 5; ++round) {
    const double mid = (low + high) / 2;
    (levels.at(mid).half < kArmsBroaden * trunk[ribs].half ? low : high) = mid;
  }
  const TrunkLevel last = levels.at(low);
  return {levels.middle() + last.half, low, (last.front + last.back) / 2};
}

/// The lowest point of the trunk in the middle plane.
Result<Vec3> crotch_of(const geometry::TriangleMesh& mesh, double middle, double stature) {
  const MeshCut cut = plane_cut(mesh, {middle, 0, 0}, {1, 0, 0});
  Vec3 crotch{0, HUGE_VAL, 0};
  for (const Vec3& p : cut.points)
    if (p.y > 0.25 * stature && p.y < crotch.y) crotch = p;
  if (crotch.y < 0.6 * stature) return crotch;
  return Error{"body.not_a_body", "There is no crotch to be found.", ""};
}

}  // namespace

Result<BodyMeasures> measure_body(const geometry::TriangleMesh& standing) {
  if (standing.triangles.empty()) return Error{"body.not_a_body", "The mesh has no triangles.", ""};
  const MeshCutter level(standing, {0, 1, 0});
  const double stature = level.high();
  BodyMeasures measures;
  BodyPoints& points = measures.points;
  measures.take(Measure::kHeight, stature, stature);
  points.middle = middle_plane(level, stature);
  const TrunkLevels levels(level, stature, points.middle);
  points.armpit = armpit_of(levels);
  points.armpit_height = points.armpit.y;
  points.crotch = TRY(crotch_of(standing, points.middle, stature));
  measures.take(Measure::kInseam, points.crotch.y, points.crotch.y,
                {points.crotch, {points.crotch.x, 0, points.crotch.z}});
  measure_neck_and_back(standing, levels, measures);
  TRY(measure_trunk(levels, measures));
  measure_arm(standing, stature, measures);
  measure_leg(levels, measures);
  return measures;
}

}  // namespace toile::measure
