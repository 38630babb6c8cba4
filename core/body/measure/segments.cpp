#include "core/body/measure/segments.h"

#include <cmath>

#include "core/base/aabb.h"

namespace toile::measure {

namespace {

std::array<Vec3, 3> axes_along(Vec3 up) {
  const Vec3 y = normalized(up);
  // As far to the front as a right angle to the limb allows; no limb points straight ahead.
  const Vec3 z = normalized(Vec3{0, 0, 1} - y * y.z);
  return {cross(y, z), y, z};
}

std::array<Vec3, 3> axes_of(BodyPart part, const BodyFigure& f) {
  switch (part) {
    case BodyPart::kLeftArm:
      return axes_along(-f.arm[0].along());
    case BodyPart::kRightArm:
      return axes_along(-f.arm[1].along());
    case BodyPart::kLeftLeg:
      return axes_along(f.leg[0].top - f.leg[0].ankle);
    case BodyPart::kRightLeg:
      return axes_along(f.leg[1].top - f.leg[1].ankle);
    default:
      return axes_along({0, 1, 0});
  }
}

/// Beyond the plane across the arm at its root, on its own side.
bool is_arm(Vec3 p, const BodyFigure& f, int side) {
  const double x = (side == kWearersLeft ? 1 : -1) * (p.x - f.middle);
  const double armpit = (side == kWearersLeft ? 1 : -1) * (f.armpit[side].x - f.middle);
  const ArmLine& arm = f.arm[side];
  const Vec3 along = arm.along();
  // Inwards of the armpit a hanging upper arm may lie, a hip beside a hand may not: what is near the arm's
  // line is arm. Above the chin nothing is.
  return x > 0.7 * armpit && dot(p - f.armpit[side], along) > 0 &&
         length(cross(p - arm.root, along)) < 0.75 * arm.girth && p.y < f.chin;
}

}  // namespace

const char* name_of(BodyPart part) {
  constexpr const char* kNames[kBodyParts] = {"head",     "neck",      "torso",    "hips",
                                              "left_arm", "right_arm", "left_leg", "right_leg"};
  return kNames[static_cast<int>(part)];
}

std::vector<BodyPart> part_of_vertices(const geometry::TriangleMesh& mesh, const BodyFigure& f) {
  const double neck_base = (f.neck_side[0].y + f.neck_side[1].y) / 2;
  std::vector<BodyPart> parts;
  parts.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices) {
    if (is_arm(p, f, kWearersLeft)) {
      parts.push_back(BodyPart::kLeftArm);
    } else if (is_arm(p, f, kWearersRight)) {
      parts.push_back(BodyPart::kRightArm);
    } else if (p.y >= f.chin) {
      parts.push_back(BodyPart::kHead);
    } else if (p.y >= neck_base) {
      parts.push_back(BodyPart::kNeck);
    } else if (p.y >= f.waist) {
      parts.push_back(BodyPart::kTorso);
    } else if (p.y >= f.crotch) {
      parts.push_back(BodyPart::kHips);
    } else {
      parts.push_back(p.x >= f.middle ? BodyPart::kLeftLeg : BodyPart::kRightLeg);
    }
  }
  return parts;
}

std::array<PartBox, kBodyParts> part_boxes(const geometry::TriangleMesh& mesh, const BodyFigure& figure) {
  std::array<PartBox, kBodyParts> boxes;
  std::array<Aabb3, kBodyParts> around;  // in each part's own axes
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    boxes[k].part = static_cast<BodyPart>(k);
    boxes[k].axis = axes_of(boxes[k].part, figure);
  }
  const std::vector<BodyPart> parts = part_of_vertices(mesh, figure);
  for (std::size_t v = 0; v < parts.size(); ++v) {
    const auto k = static_cast<std::size_t>(parts[v]);
    const auto& [x, y, z] = boxes[k].axis;
    const Vec3 p = mesh.vertices[v];
    around[k].add({dot(p, x), dot(p, y), dot(p, z)});
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (around[k].empty()) continue;  // nothing of this part: a box without size at the origin
    boxes[k].half = around[k].size() * 0.5;
    const Vec3 middle = around[k].middle();
    boxes[k].centre += boxes[k].axis[0] * middle.x;
    boxes[k].centre += boxes[k].axis[1] * middle.y;
    boxes[k].centre += boxes[k].axis[2] * middle.z;
  }
  return boxes;
}

}  // namespace toile::measure
