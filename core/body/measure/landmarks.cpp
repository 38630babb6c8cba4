#include "core/body/measure/landmarks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/body/measure/slices.h"
#include "core/geometry/distance.h"

namespace toile::measure {

namespace {

/// Places of a figure by name, before they are put on the skin.
class Places {
 public:
  Places(const geometry::TriangleMesh& mesh, const BodyFigure& figure)
      : mesh_(mesh), cutter_(mesh), f_(figure) {}

  std::vector<Landmark> all() {
    head_and_neck();
    for (int side = 0; side < 2; ++side) {
      upper_body(side);
      limbs(side);
    }
    around("bust", f_.bust, false);
    around("underbust", f_.bust - 0.04 * f_.height(), false);
    around("waist", f_.waist, true);
    around("high_hip", (f_.waist + f_.hip) / 2, true);
    around("hip", f_.hip, true);
    add("crotch", {f_.middle, f_.crotch, middle_depth(f_.crotch)});
    return std::move(all_);
  }

 private:
  void add(const std::string& name, Vec3 p) {
    Landmark mark{name, nearest_on_skin(mesh_, p), {}};
    mark.place = position_of(mark.at, mesh_);
    all_.push_back(std::move(mark));
  }
  void add_side(const std::string& name, int side, Vec3 p) {
    add(name + (side == kWearersLeft ? "_left" : "_right"), p);
  }

  double middle_depth(double y) const {
    const BodyCut cut = middle_cut(cutter_, y, f_.middle);
    return cut.points.empty() ? 0 : cut.box.middle().z;
  }

  void head_and_neck() {
    Vec3 crown = mesh_.vertices.front();
    for (const Vec3& p : mesh_.vertices) {
      if (p.y > crown.y) crown = p;
    }
    add("head_top", crown);
    add("neck_front", f_.neck_front);
    add("neck_back", f_.neck_back);
    add("neck_left", f_.neck_side[0]);
    add("neck_right", f_.neck_side[1]);
  }

  void upper_body(int side) {
    add_side("shoulder", side, f_.shoulder[side]);
    add_side("armpit", side, f_.armpit[side]);
    add_side("bust_point", side, f_.bust_point[side]);
  }

  void limbs(int side) {
    const ArmLine& arm = f_.arm[side];
    const LegLine& leg = f_.leg[side];
    // Over the arm, seen from above along it: the side away from the trunk.
    const Vec3 along = arm.along();
    const Vec3 outwards = normalized(Vec3{-along.y * (along.x >= 0 ? 1 : -1), std::abs(along.x), 0});
    const double thick = arm.girth;
    add_side("upper_arm", side, (arm.root + arm.elbow) * 0.5 + outwards * thick);
    add_side("elbow", side, arm.elbow - Vec3{0, 0, thick});
    add_side("wrist", side, arm.wrist + outwards * thick);
    add_side("hand_tip", side, arm.tip);
    // From a place well outside, so that the nearest skin is that of the side which is meant.
    const double far = 0.1 * f_.height();
    add_side("thigh", side, (leg.top + leg.knee) * 0.5 + Vec3{0, 0, far});
    add_side("knee", side, leg.knee + Vec3{0, 0, far});
    add_side("ankle", side, leg.ankle + Vec3{(side == kWearersLeft ? far : -far), 0, 0});
  }

  /// Front, back and sides of the trunk at a height; the sides only where no arms hang beside them.
  void around(const std::string& name, double y, bool sides) {
    const BodyCut cut = middle_cut(cutter_, y, f_.middle);
    if (cut.points.empty()) return;
    // Front and back are those of the middle: breasts and blades stand out beside it.
    const double within = 0.012 * f_.height();
    for (const auto& [where, facing] : {std::pair{"_front", 1.0}, std::pair{"_back", -1.0}})
      add(name + where, middle_skin(mesh_, cut, y, f_.middle, facing, within).value_or(cut.box.middle()));
    if (!sides) return;
    const auto by_x = [](Vec3 p, Vec3 q) { return p.x < q.x; };
    add(name + "_left", *std::max_element(cut.points.begin(), cut.points.end(), by_x));
    add(name + "_right", *std::min_element(cut.points.begin(), cut.points.end(), by_x));
  }

  const geometry::TriangleMesh& mesh_;
  PlaneCutter cutter_;
  const BodyFigure& f_;
  std::vector<Landmark> all_;
};

}  // namespace

Vec3 position_of(const SkinPoint& point, const geometry::TriangleMesh& mesh) {
  const Tri& t = mesh.triangles[static_cast<std::size_t>(point.triangle)];
  Vec3 p;
  for (int c = 0; c < 3; ++c) p += mesh.vertices[static_cast<std::size_t>(t[c])] * point.share[c];
  return p;
}

SkinPoint nearest_on_skin(const geometry::TriangleMesh& mesh, Vec3 p) {
  SkinPoint best;
  double least = HUGE_VAL;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Tri& tri = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[tri[0]], &b = mesh.vertices[tri[1]], &c = mesh.vertices[tri[2]];
    const geometry::TrianglePoint w = geometry::closest_on_triangle(p, a, b, c);
    const Vec3 d = a * w.a + b * w.b + c * w.c - p;
    // Of equals the first, by number: the same on every machine.
    if (dot(d, d) < least) {
      least = dot(d, d);
      best = {static_cast<Index>(t), {w.a, w.b, w.c}};
    }
  }
  return best;
}

std::vector<Landmark> find_landmarks(const geometry::TriangleMesh& mesh, const BodyFigure& figure) {
  return Places(mesh, figure).all();
}

const Landmark* landmark_named(std::span<const Landmark> landmarks, std::string_view name) {
  const auto it =
      std::find_if(landmarks.begin(), landmarks.end(), [&](const Landmark& l) { return l.name == name; });
  return it == landmarks.end() ? nullptr : &*it;
}

}  // namespace toile::measure
