#include "core/body/measure/lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/body/measure/cut_points.h"
#include "core/body/measure/slices.h"

namespace toile::measure {

namespace {

constexpr double kCorner = 0.008;  ///< m, least distance between corners

/// Where a line is looked for: the part of this cut that holds or is nearest to its origin.
struct LinePlane {
  Vec3 origin, normal;  ///< upwards
  bool trunk = false;   ///< all parts that cross the mid-plane count, whatever their middles
};

std::optional<LinePlane> limb_plane(const BodyFigure& f, std::string_view name) {
  for (const int side : {kWearersLeft, kWearersRight}) {
    const std::string_view ending = side == kWearersLeft ? "_left" : "_right";
    if (!name.ends_with(ending)) continue;
    const std::string_view place = name.substr(0, name.size() - ending.size());
    const ArmLine& arm = f.arm[side];
    const LegLine& leg = f.leg[side];
    if (place == "upper_arm")
      return LinePlane{(arm.root + arm.elbow) * 0.5, normalized(arm.root - arm.elbow)};
    if (place == "elbow") return LinePlane{arm.elbow, -arm.along()};
    if (place == "wrist") return LinePlane{arm.wrist, normalized(arm.elbow - arm.wrist)};
    if (place == "thigh") return LinePlane{(leg.top + leg.knee) * 0.5, normalized(leg.top - leg.knee)};
    if (place == "knee") return LinePlane{leg.knee, normalized(leg.top - leg.ankle)};
    if (place == "ankle") return LinePlane{leg.ankle, normalized(leg.knee - leg.ankle)};
  }
  return std::nullopt;
}

std::optional<LinePlane> plane_of(const BodyFigure& f, std::string_view name) {
  const auto level = [&](double y) { return LinePlane{{f.middle, y, 0}, {0, 1, 0}, true}; };
  if (name == "bust") return level(f.bust);
  if (name == "underbust") return level(f.bust - 0.04 * f.height());
  if (name == "waist") return level(f.waist);
  if (name == "high_hip") return level((f.waist + f.hip) / 2);
  if (name == "hip") return level(f.hip);
  if (name == "neck") return level(f.neck);
  if (name != "neckline") return limb_plane(f, name);
  // It holds the x axis, so that left and right are alike.
  const Vec3 slope = f.neck_back - f.neck_front;
  const Vec3 middle = (f.neck_front + f.neck_back) * 0.5;
  return LinePlane{{f.middle, middle.y, middle.z}, normalized(Vec3{0, -slope.z, slope.y})};
}

std::vector<Vec3> points_on(const PlaneCutter& cutter, const BodyFigure& f, const LinePlane& plane) {
  std::vector<Vec3> points;
  double least = HUGE_VAL;
  for (const BodyCut& cut : cut_body(cutter, plane.origin, plane.normal)) {
    if (plane.trunk) {
      if (cut.box.low.x > f.middle || cut.box.high.x < f.middle) continue;
      points.insert(points.end(), cut.points.begin(), cut.points.end());
      continue;
    }
    const Vec3 d = cut.box.middle() - plane.origin;
    if (dot(d, d) < least) {
      least = dot(d, d);
      points = cut.points;
    }
  }
  return points;
}

/// Corners of a convex loop moved outwards by `away`, so that its sides come to lie that far outside.
std::vector<Vec3> grown(const std::vector<Vec3>& loop, Vec3 normal, double away) {
  std::vector<Vec3> out;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 before = normalized(cross(loop[i] - loop[(i + n - 1) % n], normal));
    const Vec3 after = normalized(cross(loop[(i + 1) % n] - loop[i], normal));
    // Along the bisector by as much as brings both sides out; at a spike not without end.
    out.push_back(loop[i] + (before + after) * (away / std::max(0.2, 1 + dot(before, after))));
  }
  return out;
}

std::vector<Vec3> thinned(const std::vector<Vec3>& loop) {
  std::vector<Vec3> out;
  for (const Vec3& p : loop) {
    const bool near = !out.empty() && (length(p - out.back()) < kCorner || length(p - out.front()) < kCorner);
    if (!near) out.push_back(p);
  }
  return out;
}

/// Twice the area, positive where the loop runs counter-clockwise about the normal.
double turning(const std::vector<Vec3>& loop, Vec3 normal) {
  Vec3 sum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  }
  return dot(sum, normal);
}

}  // namespace

const std::vector<std::string>& body_line_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"neck", "neckline", "bust", "underbust", "waist", "high_hip", "hip"};
    for (const char* limb : {"upper_arm", "elbow", "wrist", "thigh", "knee", "ankle"}) {
      for (const char* side : {"_left", "_right"}) all.push_back(std::string(limb) + side);
    }
    return all;
  }();
  return names;
}

Result<std::vector<Vec3>> body_line(const PlaneCutter& cutter, const BodyFigure& figure,
                                    std::string_view name, double up, double away) {
  std::optional<LinePlane> plane = plane_of(figure, name);
  if (!plane) return Error{"body.unknown_line", "there is no line of that name on a body", std::string(name)};
  plane->origin += plane->normal * up;
  std::vector<Vec3> loop = thinned(taut_loop(points_on(cutter, figure, *plane), plane->normal));
  if (loop.size() < 3) {
    return Error{"body.no_line", "the body has nothing there that a tape could go around", std::string(name)};
  }
  if (turning(loop, plane->normal) < 0) std::reverse(loop.begin(), loop.end());
  return grown(loop, plane->normal, away);
}

double length_of_loop(const std::vector<Vec3>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += length(loop[(i + 1) % loop.size()] - loop[i]);
  return sum;
}

}  // namespace toile::measure
