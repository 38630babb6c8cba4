#include "core/body/measure/arm_tape.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/body/measure/cut_points.h"
#include "core/body/measure/mesh_cut.h"

namespace toile::measure {
namespace {

// Shares of the way from the shoulder point to the fingertips, and to the wrist.
constexpr double kWristFrom = 0.60, kWristTo = 0.82, kUpperArm = 0.32, kElbow = 0.545;
constexpr int kAxisCuts = 10;
constexpr double kArmReach = 0.07;  // of an arm's cut from where its axis is thought to be, in statures
constexpr double kUpperFrom = 0.30, kUpperTo = 0.62, kLevelArm = 0.35;
constexpr double kJointLevel = 0.18;  // of the way from nape to crotch

class ArmTape {
 public:
  ArmTape(const geometry::TriangleMesh& mesh, double stature, BodyMeasures& measures)
      : mesh_(mesh), side_(mesh, {1, 0, 0}), stature_(stature), measures_(measures) {}

  void run();

 private:
  std::vector<Index> arm_triangles() const;
  std::vector<Index> side_triangles() const;
  Vec3 top_at(double x) const;
  Vec3 shoulder_point(std::span<const Vec3> axis) const;
  std::vector<Vec3> arm_cut(Vec3 at, Vec3 direction) const {
    return outer_part(plane_cut(mesh_, at, direction, side_triangles_), at, kArmReach * stature_);
  }

  const geometry::TriangleMesh& mesh_;
  MeshCutter side_;
  double stature_;
  BodyMeasures& measures_;
  std::vector<Index> arm_, side_triangles_;
};

// What hangs together beyond the armpit, from the vertex farthest to the side.
std::vector<Index> ArmTape::arm_triangles() const {
  const double limit = measures_.points.armpit.x;
  std::vector<std::vector<Index>> fans(mesh_.vertices.size());
  Index far = 0;
  for (Index t = 0; t < static_cast<Index>(mesh_.triangles.size()); ++t)
    for (Index v : mesh_.triangles[t]) fans[v].push_back(t);
  for (Index v = 0; v < static_cast<Index>(mesh_.vertices.size()); ++v)
    if (mesh_.vertices[v].x > mesh_.vertices[far].x) far = v;
  std::vector<bool> seen(mesh_.vertices.size(), false), taken(mesh_.triangles.size(), false);
  std::vector<Index> queue{far}, out;
  seen[far] = true;
  while (!queue.empty()) {
    const Index v = queue.back();
    queue.pop_back();
    for (Index t : fans[v]) {
      if (!taken[t]) {
        taken[t] = true;
        out.push_back(t);
      }
      for (Index w : mesh_.triangles[t])
        if (!seen[w] && mesh_.vertices[w].x > limit) {
          seen[w] = true;
          queue.push_back(w);
        }
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

// What a cut across the arm may meet: more than the arm, so that no cut is open.
std::vector<Index> ArmTape::side_triangles() const {
  const BodyPoints& p = measures_.points;
  const double limit = p.middle + 0.5 * (p.armpit.x - p.middle);
  std::vector<Index> out;
  for (Index t = 0; t < static_cast<Index>(mesh_.triangles.size()); ++t) {
    const Vec3& q = mesh_.vertices[mesh_.triangles[t][0]];
    if (q.x > limit && q.y > 0.7 * p.crotch.y) out.push_back(t);
  }
  return out;
}

void ArmTape::run() {
  BodyPoints& p = measures_.points;
  arm_ = arm_triangles();
  side_triangles_ = side_triangles();
  const Vec3 shoulder = top_at(p.armpit.x);
  if (!(shoulder.y > p.armpit_height)) return;
  const Vec3 root = (shoulder + p.armpit) * 0.5;
  double reach = 0;
  for (Index t : arm_) {
    const Vec3& q = mesh_.vertices[mesh_.triangles[t][0]];
    if (const double d = length(q - shoulder); d > reach) {
      reach = d;
      p.hand_tip = q;
    }
  }
  // The axis bends with the arm: middles of cuts across the straight line.
  const Vec3 straight = normalized(p.hand_tip - root);
  const double span = length(p.hand_tip - root);
  const auto axis_at = [&](double s) {
    const Vec3 at = root + straight * (s * span);
    const std::vector<Vec3> cut = arm_cut(at, straight);
    return cut.empty() ? at : middle_of(cut);
  };
  const auto loop_at_share = [&](double s, Vec3* centre) {
    const Vec3 direction = normalized(axis_at(s + 0.06) - axis_at(s - 0.03));
    *centre = axis_at(s);
    return std::pair(arm_cut(*centre, direction), direction);
  };
  const auto girth_at_share = [&](double s, Vec3* centre) {
    const auto [points_of_cut, direction] = loop_at_share(s, centre);
    return around(points_of_cut, direction);
  };
  const auto line_at_share = [&](double s) {
    Vec3 centre;
    const auto [points_of_cut, direction] = loop_at_share(s, &centre);
    return taut_loop(points_of_cut, direction);
  };
  double least = HUGE_VAL, wrist = 0;
  for (double s = kWristFrom; s <= kWristTo; s += 0.01) {
    Vec3 c;
    if (const double g = girth_at_share(s, &c); g > 0 && g < least) {
      least = g;
      wrist = s;
      p.wrist = c;
    }
  }
  if (!(least < HUGE_VAL)) return;
  std::vector<Vec3> axis;
  for (int i = 0; i <= kAxisCuts; ++i)
    axis.push_back(axis_at((kUpperFrom + (kUpperTo - kUpperFrom) * i / kAxisCuts) * wrist));
  p.shoulder = shoulder_point(axis);
  const Vec3 other{2 * p.middle - p.shoulder.x, p.shoulder.y, p.shoulder.z};
  measures_.take(Measure::kShoulderWidth, 2 * (p.shoulder.x - p.middle), p.shoulder.y, {p.shoulder, other});
  measures_.take(Measure::kWrist, least, p.wrist.y, line_at_share(wrist));
  const Vec3 elbow = axis_at(kElbow * wrist);
  measures_.take(Measure::kArmLength, length(elbow - p.shoulder) + length(p.wrist - elbow), p.wrist.y,
                 {p.shoulder, elbow, p.wrist});
  Vec3 c;
  const double upper = girth_at_share(kUpperArm * wrist, &c);
  measures_.take(Measure::kUpperArm, upper, c.y, line_at_share(kUpperArm * wrist));
}

// The highest point of the skin right above x, between armpit and neck.
Vec3 ArmTape::top_at(double x) const {
  Vec3 top{x, -HUGE_VAL, 0};
  for (const Vec3& q : side_.at(x).points)
    if (q.y > top.y) top = q;
  return top;
}

// The skin above the shoulder joint: there the upper arm's axis, a line through the middles of several cuts,
// comes to the joint's level. Level arms have no such place; theirs lies above the armpit.
Vec3 ArmTape::shoulder_point(std::span<const Vec3> axis) const {
  const BodyPoints& p = measures_.points;
  Vec3 mean;
  for (const Vec3& q : axis) mean += q * (1.0 / static_cast<double>(axis.size()));
  double along = 0, fall = 0;  // the line's slope, by least squares along x
  for (const Vec3& q : axis) {
    along += (q.x - mean.x) * (q.x - mean.x);
    fall -= (q.x - mean.x) * (q.y - mean.y);
  }
  if (!(fall > kLevelArm * along)) return top_at(p.armpit.x);
  const double joint = p.nape.y - kJointLevel * (p.nape.y - p.crotch.y);
  return top_at(mean.x - (joint - mean.y) * along / fall);
}

}  // namespace

void measure_arm(const geometry::TriangleMesh& mesh, double stature, BodyMeasures& measures) {
  ArmTape(mesh, stature, measures).run();
}

}  // namespace toile::measure
