#include "core/body/measure/segments.h"

#include <gtest/gtest.h>

#include "core/body/mesh_import/load.h"

namespace toile {
namespace {

struct Parted {
  geometry::TriangleMesh mesh = mesh_import::load_mesh(TOILE_SOURCE_DIR "/samples/skirt/body.obj").value();
  measure::BodyFigure figure = measure::find_figure(mesh).value();
  std::vector<measure::BodyPart> parts = measure::part_of_vertices(mesh, figure);
  std::array<measure::PartBox, measure::kBodyParts> boxes = measure::part_boxes(mesh, figure);
};

TEST(Segments, EveryVertexLiesInTheBoxOfItsPart) {
  const Parted body;
  for (std::size_t v = 0; v < body.parts.size(); ++v) {
    const measure::PartBox& box = body.boxes[static_cast<std::size_t>(body.parts[v])];
    const Vec3 d = body.mesh.vertices[v] - box.centre;
    EXPECT_LE(std::abs(dot(d, box.axis[0])), box.half.x + 1e-9) << measure::name_of(box.part);
    EXPECT_LE(std::abs(dot(d, box.axis[1])), box.half.y + 1e-9) << measure::name_of(box.part);
    EXPECT_LE(std::abs(dot(d, box.axis[2])), box.half.z + 1e-9) << measure::name_of(box.part);
  }
}

TEST(Segments, BoxesAreRightHandedAndRunAlongTheirParts) {
  const Parted body;
  for (const measure::PartBox& box : body.boxes) {
    EXPECT_NEAR(length(cross(box.axis[0], box.axis[1]) - box.axis[2]), 0, 1e-12)
        << measure::name_of(box.part);
    EXPECT_GT(box.half.x * box.half.y * box.half.z, 0) << measure::name_of(box.part);
  }
  const measure::PartBox& arm = body.boxes[static_cast<std::size_t>(measure::BodyPart::kLeftArm)];
  EXPECT_GT(std::abs(dot(arm.axis[1], body.figure.arm[0].along())), 0.99);
  EXPECT_GT(arm.half.y, 2.0 * arm.half.z) << "an arm is longer than thick";
}

TEST(Segments, PartsLieWhereTheyBelong) {
  const Parted body;
  const auto centre = [&](measure::BodyPart p) { return body.boxes[static_cast<std::size_t>(p)].centre; };
  EXPECT_GT(centre(measure::BodyPart::kHead).y, centre(measure::BodyPart::kNeck).y);
  EXPECT_GT(centre(measure::BodyPart::kNeck).y, centre(measure::BodyPart::kTorso).y);
  EXPECT_GT(centre(measure::BodyPart::kTorso).y, centre(measure::BodyPart::kHips).y);
  EXPECT_GT(centre(measure::BodyPart::kHips).y, centre(measure::BodyPart::kLeftLeg).y);
  EXPECT_GT(centre(measure::BodyPart::kLeftArm).x, 0.2);
  EXPECT_LT(centre(measure::BodyPart::kRightArm).x, -0.2);
  EXPECT_GT(centre(measure::BodyPart::kLeftLeg).x, 0.05);
}

}  // namespace
}  // namespace toile
