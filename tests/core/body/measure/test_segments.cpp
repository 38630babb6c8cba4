#include "core/body/measure/segments.h"

#include <gtest/gtest.h>

#include "core/body/mesh_import/load.h"

namespace toile {
namespace {

struct Parted {
  TriangleMesh mesh = load_mesh(TOILE_SOURCE_DIR "/samples/skirt/body.obj").value();
  BodyFigure figure = find_figure(mesh).value();
  std::vector<BodyPart> parts = part_of_vertices(mesh, figure);
  std::array<PartBox, kBodyParts> boxes = part_boxes(mesh, figure);
};

TEST(Segments, EveryVertexLiesInTheBoxOfItsPart) {
  const Parted body;
  for (std::size_t v = 0; v < body.parts.size(); ++v) {
    const PartBox& box = body.boxes[static_cast<std::size_t>(body.parts[v])];
    const Vec3 d = body.mesh.vertices[v] - box.centre;
    EXPECT_LE(std::abs(dot(d, box.axis[0])), box.half.x + 1e-9) << name_of(box.part);
    EXPECT_LE(std::abs(dot(d, box.axis[1])), box.half.y + 1e-9) << name_of(box.part);
    EXPECT_LE(std::abs(dot(d, box.axis[2])), box.half.z + 1e-9) << name_of(box.part);
  }
}

TEST(Segments, BoxesAreRightHandedAndRunAlongTheirParts) {
  const Parted body;
  for (const PartBox& box : body.boxes) {
    EXPECT_NEAR(length(cross(box.axis[0], box.axis[1]) - box.axis[2]), 0, 1e-12) << name_of(box.part);
    EXPECT_GT(box.half.x * box.half.y * box.half.z, 0) << name_of(box.part);
  }
  const PartBox& arm = body.boxes[static_cast<std::size_t>(BodyPart::kLeftArm)];
  EXPECT_GT(std::abs(dot(arm.axis[1], body.figure.arm[0].along())), 0.99);
  EXPECT_GT(arm.half.y, 2.0 * arm.half.z) << "an arm is longer than thick";
}

TEST(Segments, PartsLieWhereTheyBelong) {
  const Parted body;
  const auto centre = [&](BodyPart p) { return body.boxes[static_cast<std::size_t>(p)].centre; };
  EXPECT_GT(centre(BodyPart::kHead).y, centre(BodyPart::kNeck).y);
  EXPECT_GT(centre(BodyPart::kNeck).y, centre(BodyPart::kTorso).y);
  EXPECT_GT(centre(BodyPart::kTorso).y, centre(BodyPart::kHips).y);
  EXPECT_GT(centre(BodyPart::kHips).y, centre(BodyPart::kLeftLeg).y);
  EXPECT_GT(centre(BodyPart::kLeftArm).x, 0.2);
  EXPECT_LT(centre(BodyPart::kRightArm).x, -0.2);
  EXPECT_GT(centre(BodyPart::kLeftLeg).x, 0.05);
}

}  // namespace
}  // namespace toile
