#include "core/arrange/box_places.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/arrange/sheet_placement.h"
#include "core/body/mesh_import/load.h"

namespace toile {
namespace {

struct Boxed {
  geometry::TriangleMesh mesh = mesh_import::load_mesh(TOILE_SOURCE_DIR "/samples/skirt/body.obj").value();
  measure::BodyFigure figure = measure::find_figure(mesh).value();
  std::array<measure::PartBox, measure::kBodyParts> boxes = measure::part_boxes(mesh, figure);
  const measure::PartBox& of(measure::BodyPart part) const { return boxes[static_cast<std::size_t>(part)]; }
};

const Boxed& boxed() {
  static const Boxed b;
  return b;
}

TEST(BoxPlaces, APieceStandsBeforeItsSideWithItsRightSideOutwards) {
  for (const measure::BodyPart part :
       {measure::BodyPart::kTorso, measure::BodyPart::kLeftArm, measure::BodyPart::kRightLeg}) {
    const measure::PartBox& box = boxed().of(part);
    for (const arrange::BoxSide side : {arrange::BoxSide::kFront, arrange::BoxSide::kBack,
                                        arrange::BoxSide::kLeft, arrange::BoxSide::kRight}) {
      arrange::OnBox where;
      where.side = side;
      where.at = {0.02, 0.05};
      where.away = 0.03;
      where.turn = 0.4;
      where.anchor = {0.1, 0.2};
      const auto p = sewing::place({{0.1, 0.2}, {0.2, 0.2}, {0.1, 0.3}}, arrange::on_box_side(box, where));
      const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]) * 100.0;
      EXPECT_GT(dot(normal, p[0] - box.centre), 0) << measure::name_of(part);
      EXPECT_NEAR(dot(p[0] - box.centre, box.axis[1]), 0.05, 1e-9) << measure::name_of(part);
      const double half = std::abs(dot(normal, box.axis[2])) > 0.5 ? box.half.z : box.half.x;
      EXPECT_NEAR(dot(normal, p[0] - box.centre), half + 0.03, 1e-9) << measure::name_of(part);
    }
  }
}

TEST(BoxPlaces, APieceRolledAroundAnArmKeepsItsDistanceAndIsNotStretched) {
  const measure::PartBox& box = boxed().of(measure::BodyPart::kLeftArm);
  const double radius = arrange::radius_of_part(boxed().mesh, boxed().figure, box, -0.05, 0.25);
  arrange::OnBox where;
  where.away = 0.01;
  where.at = {0, 0.1};
  std::vector<Vec2> flat;
  for (int i = 0; i <= 30; ++i) flat.push_back({0.01 * i - 0.15, 0.002 * i});
  const auto p = sewing::place(flat, arrange::around_box(box, where, radius));
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 d = p[i] - box.centre;
    EXPECT_NEAR(length(d - box.axis[1] * dot(d, box.axis[1])), radius + 0.01, 1e-9);
    if (i == 0) continue;
    EXPECT_NEAR(length(p[i] - p[i - 1]), length(flat[i] - flat[i - 1]), 1e-4);
  }
}

TEST(BoxPlaces, AnglesOfATurnGiveTheTurnAgain) {
  const Vec3 columns[][3] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
                             {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                             {{0.6, 0.8, 0}, {0, 0, 1}, {0.8, -0.6, 0}}};
  for (const auto& c : columns) {
    sewing::RigidPlacement rigid;
    rigid.rotation = arrange::turn_angles({c[0], c[1], c[2]});
    const auto p = sewing::place({{1, 0}, {0, 1}}, rigid);
    EXPECT_NEAR(length(p[0] - c[0]), 0, 1e-12);
    EXPECT_NEAR(length(p[1] - c[1]), 0, 1e-12);
  }
}

}  // namespace
}  // namespace toile
