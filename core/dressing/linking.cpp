#include "core/dressing/linking.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/units.h"

namespace toile::dressing {

namespace {

constexpr double kFarAway =
    200;  // m, where limbs' lines end: what is missing of the integral there is nothing

double angle_between(Vec3 unit_a, Vec3 unit_b) {
  return std::asin(std::clamp(dot(unit_a, unit_b), -1.0, 1.0));
}

/// 4π times Gauss's integral over two straight pieces: the area of the sphere of directions from one to the
/// other.
double directions(Vec3 a0, Vec3 a1, Vec3 b0, Vec3 b1) {
  const Vec3 r00 = b0 - a0, r01 = b1 - a0, r10 = b0 - a1, r11 = b1 - a1;
  const Vec3 n1 = normalized(cross(r00, r01)), n2 = normalized(cross(r01, r11));
  const Vec3 n3 = normalized(cross(r11, r10)), n4 = normalized(cross(r10, r00));
  const double area =
      angle_between(n1, n2) + angle_between(n2, n3) + angle_between(n3, n4) + angle_between(n4, n1);
  const double side = dot(cross(b1 - b0, a1 - a0), r00);
  return side > 0 ? area : side < 0 ? -area : 0;
}

}  // namespace

double gauss_integral(std::span<const Vec3> closed, std::span<const Vec3> open) {
  double sum = 0;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const Vec3 a0 = closed[i], a1 = closed[(i + 1) % closed.size()];
    for (std::size_t j = 0; j + 1 < open.size(); ++j) sum += directions(a0, a1, open[j], open[j + 1]);
  }
  return sum / (4 * kPi);
}

int linking_number(std::span<const Vec3> a, std::span<const Vec3> b) {
  if (a.empty() || b.empty()) return 0;
  std::vector<Vec3> around(b.begin(), b.end());
  around.push_back(b.front());
  return static_cast<int>(std::lround(gauss_integral(a, around)));
}

Skeleton skeleton_of(const measure::BodyFigure& f) {
  const Vec3 neck = (f.neck_front + f.neck_back) * 0.5;
  const Vec3 pelvis = (f.leg[0].top + f.leg[1].top) * 0.5 + Vec3{0, 0.5 * (f.hip - f.crotch), 0};
  const Vec3 chest{f.middle, 0.5 * (f.armpit[0].y + f.armpit[1].y),
                   0.5 * (f.arm[0].root.z + f.arm[1].root.z)};
  const Vec3 middle = (pelvis + chest) * 0.5;
  Skeleton skeleton;
  const auto end_far = [](std::vector<Vec3>& line, Vec3 along) {
    line.push_back(line.back() + normalized(along) * kFarAway);
  };
  // Out through the mouth: a hood covers the head, and its opening lies there, seldom up to the brow.
  constexpr double kMouth = 0.3;  // of the head's height above the chin
  skeleton[kHead] = {middle, chest, neck, {neck.x, f.chin + kMouth * (f.top - f.chin), neck.z}};
  end_far(skeleton[kHead], {0, 0, 1});
  for (std::size_t side = 0; side < 2; ++side) {
    const measure::ArmLine& arm = f.arm[side];
    std::vector<Vec3>& a = skeleton[kLeftArm + side];
    a = {middle, chest, arm.root, arm.elbow, arm.wrist, arm.tip};
    end_far(a, arm.tip - arm.wrist);
    const measure::LegLine& leg = f.leg[side];
    std::vector<Vec3>& l = skeleton[kLeftLeg + side];
    l = {middle, pelvis, leg.top, leg.knee, leg.ankle, {leg.ankle.x, f.floor, leg.ankle.z}};
    end_far(l, {0, -1, 0});
  }
  return skeleton;
}

bool Enclosure::simple() const {
  return std::all_of(times.begin(), times.end(), [](int n) { return n == 0 || n == 1; });
}

std::optional<Enclosure> enclosed_by(std::span<const Vec3> ring, const Skeleton& skeleton) {
  std::array<double, kLimbCount> part{};
  for (std::size_t k = 0; k < kLimbCount; ++k) part[k] = gauss_integral(ring, skeleton[k]);
  Enclosure up, down;
  for (std::size_t k = 0; k < kLimbCount; ++k) {
    const double way = part[k] - part[0];
    if (std::abs(way - std::round(way)) > 0.2) return std::nullopt;
    up.times[k] = static_cast<int>(std::lround(way));
    down.times[k] = -up.times[k];
  }
  // A ring has no sense of direction, and lines from limb to limb tell differences only: of all ways to say
  // it the one with the fewest turns.
  const auto least = [](Enclosure e) {
    Enclosure best = e;
    int fewest = -1;
    for (const int base : e.times) {
      Enclosure moved = e;
      int turns = 0;
      for (int& n : moved.times) turns += std::abs(n -= base);
      if (fewest < 0 || turns < fewest) {
        fewest = turns;
        best = moved;
      }
    }
    return best;
  };
  const Enclosure a = least(up), b = least(down);
  const auto below = [](const Enclosure& e) {
    return std::count_if(e.times.begin(), e.times.end(), [](int n) { return n < 0; });
  };
  return below(b) < below(a) ? b : a;
}

}  // namespace toile::dressing
