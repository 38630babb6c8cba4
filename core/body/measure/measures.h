#pragma once
// What a tape says of a body: names, places by ISO 8559-1, and the measuring of any standing body.

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::measure {

/// In the order in which they are printed.
enum class Measure {
  kHeight,
  kBust,
  kUnderbust,
  kWaist,
  kHip,
  kNeck,
  kShoulderWidth,
  kUpperArm,
  kWrist,
  kArmLength,
  kThigh,
  kCalf,
  kInseam,
  kBackLength,
};
inline constexpr int kMeasureCount = 14;

constexpr Measure measure_at(int i) { return static_cast<Measure>(i); }

/// "height", "bust", … as options and documents name them.
std::string_view measure_name(Measure m);
/// How and where it is taken, one sentence.
std::string_view measure_rule(Measure m);
bool is_girth(Measure m);

/// Lengths in metres; nothing where it is not known.
struct MeasureSet {
  std::array<std::optional<double>, kMeasureCount> values;
  std::optional<double>& operator[](Measure m) { return values[static_cast<size_t>(m)]; }
  const std::optional<double>& operator[](Measure m) const { return values[static_cast<size_t>(m)]; }
};

/// A measure as taken.
struct TakenMeasure {
  double value = 0;   ///< m
  double height = 0;  ///< m above the floor: of the level, or of the middle of a slanting tape
  /// m: where the tape lay, taut. A girth's closes by itself; that of an arm or leg is the one on +x. Empty
  /// for the height.
  std::vector<Vec3> line = {};
};

/// Points that the tape found on its way. Metres; the arm is the one on +x.
struct BodyPoints {
  double middle = 0;  ///< x of the plane of symmetry
  double armpit_height = 0, bust_height = 0, underbust_height = 0, waist_height = 0, hip_height = 0;
  Vec3 crotch, nape, armpit, shoulder, wrist, hand_tip;
};

struct BodyMeasures {
  std::array<std::optional<TakenMeasure>, kMeasureCount> taken;
  BodyPoints points;
  /// Notes a measure (arguments as TakenMeasure); one that is not above 0 was not to be found.
  void take(Measure m, double value, double height, std::vector<Vec3> line = {}) {
    if (value > 0) taken[static_cast<size_t>(m)] = TakenMeasure{value, height, std::move(line)};
  }
  const std::optional<TakenMeasure>& operator[](Measure m) const { return taken[static_cast<size_t>(m)]; }
};

/// Measures a body that stands on y = 0, faces +z and holds its arms 20° to 100° off (see stance.h for
/// others). A tape spans hollows: girths are perimeters of convex hulls of cuts, without arms or the other
/// leg. Bust and hip are the widest, waist the narrowest; what cannot be found stays empty. Error:
/// "body.not_a_body" where the mesh has no trunk, head and two legs.
Result<BodyMeasures> measure_body(const geometry::TriangleMesh& standing);

}  // namespace toile::measure
