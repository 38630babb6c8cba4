#include "core/project/create/front_sides.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/curve.h"
#include "core/pattern/seams/roles.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::create {
namespace {

constexpr double kAgree = 8;  // mm, that the sides of front and back may differ by

}  // namespace

const seams::SeamRun& beside(const seams::SeamModel& m, const seams::SeamRun& run, bool after) {
  return after ? m.runs[run.next] : seams::run_before(m, run);
}

bool begins_side(const seams::SeamModel& m, const seams::SeamRun& run) {
  return seams::begins_at_hem(m, run) && std::abs(run.up) < kSideUp;
}

std::vector<const seams::SeamRun*> side_from(const seams::SeamModel& m, const seams::SeamRun& lowest,
                                             bool after) {
  std::vector<const seams::SeamRun*> side{&lowest};
  for (const seams::SeamRun* next = &beside(m, lowest, after); next->up < kWaistUp;
       next = &beside(m, *next, after)) {
    if (next == &lowest || next->up < -kWaistUp) return {};  // it went around by the hem
    side.push_back(next);
  }
  return side;
}

double length_of(const std::vector<const seams::SeamRun*>& side) {
  double length = 0;
  for (const seams::SeamRun* run : side) length += run->length;
  return length;
}

Vec2 way_on(const pattern::PanelEdge& edge, bool at_end) {
  const pattern::CubicBezier& c = at_end ? edge.curves.back() : edge.curves.front();
  const Vec2 along = pattern::derivative(c, at_end ? 1 : 0);
  return normalized(at_end ? along : -along);
}

std::vector<double> sides_behind(const seams::SeamModel& m) {
  std::vector<double> yokes{0}, sides;
  for (const seams::SeamRun& run : m.runs) {
    const seams::PieceWords& words = m.words[run.panel];
    if (words.yoke && std::abs(run.up) < seams::kPairWeights.facing) yokes.push_back(run.length);
  }
  for (const seams::SeamRun& run : m.runs) {
    const seams::PieceWords& words = m.words[run.panel];
    if (words.face >= 0 || words.layer || words.yoke || !seams::has_leg_crotch(m, run.panel)) continue;
    if (!begins_side(m, run)) continue;
    for (const bool after : {true, false}) {
      const std::vector<const seams::SeamRun*> side = side_from(m, run, after);
      if (side.empty()) continue;
      for (const double yoke : yokes) sides.push_back(length_of(side) + yoke);
    }
  }
  return sides;
}

bool agrees(const std::vector<double>& lengths, double length) {
  return std::any_of(lengths.begin(), lengths.end(),
                     [&](double other) { return std::abs(other - length) < kAgree; });
}

}  // namespace toile::create
