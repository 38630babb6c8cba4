#include "core/body/measure/leg_tape.h"

#include "core/body/measure/cut_points.h"
#include "core/geometry/convex_hull.h"

namespace toile::measure {
namespace {

constexpr double kThighBelowCrotch = 0.008;          // of the stature
constexpr double kCalfLow = 0.30, kCalfHigh = 0.62;  // of the crotch's height

}  // namespace

void measure_leg(const TrunkLevels& levels, BodyMeasures& measures) {
  const double middle = levels.middle(), crotch = measures.points.crotch.y;
  const auto leg_at = [&](double y) {
    std::vector<Vec3> one;
    for (const Vec3& q : levels.points_at(y))
      if (q.x >= middle) one.push_back(q);
    return one;
  };
  const auto girth = [&](double y) { return geometry::hull_perimeter(flat(leg_at(y))); };
  const double thigh = crotch - kThighBelowCrotch * levels.stature();
  measures.take(Measure::kThigh, girth(thigh), thigh, taut_loop(leg_at(thigh), {0, 1, 0}));
  double most = 0, place = 0;
  for (double y = kCalfLow * crotch; y <= kCalfHigh * crotch; y += 2 * levels.step())
    if (const double g = girth(y); g > most) {
      most = g;
      place = y;
    }
  measures.take(Measure::kCalf, most, place, taut_loop(leg_at(place), {0, 1, 0}));
}

}  // namespace toile::measure
