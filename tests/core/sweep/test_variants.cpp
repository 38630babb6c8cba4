#include "core/sweep/variants.h"

#include <gtest/gtest.h>

namespace toile::sweep {
namespace {

project::ProjectPiece piece(const std::string& id, const std::string& fabric) {
  project::ProjectPiece piece;
  piece.id = id;
  piece.fabric = fabric;
  return piece;
}

project::Project coat() {
  project::Project project;
  project.name = "Coat";
  project.fabric = "wool";
  project.fabrics.resize(2);
  project.fabrics[0].id = "wool";
  project.fabrics[1].id = "silk";
  project.pieces = {piece("front", ""), piece("back", "wool"), piece("lining", "silk")};
  project::ProjectBody body;
  body.id = "anna";
  body.file = "anna.obj";
  body.friction = 0.7;
  body.skin_offset_mm = 3;
  project.bodies = {body};
  return project;
}

project::ProjectBody mannequin(const std::string& id, const std::string& preset) {
  project::ProjectBody body;
  body.id = id;
  body.mannequin.emplace();
  body.mannequin->preset = preset;
  return body;
}

TEST(SweepVariants, TheMainFabricIsThatOfMostPieces) {
  EXPECT_EQ(main_fabric(coat()), "wool");
  project::Project one_each = coat();
  one_each.pieces.pop_back();
  one_each.pieces[1].fabric = "silk";
  EXPECT_EQ(main_fabric(one_each), "wool") << "of equals the first";
  EXPECT_EQ(main_fabric({}), "");
}

TEST(SweepVariants, AnotherFabricLeavesTheLining) {
  const auto cut = cut_of(coat(), "denim-10oz");
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->fabric, "denim-10oz");
  EXPECT_EQ(cut->pieces[0].fabric, "");
  EXPECT_EQ(cut->pieces[1].fabric, "denim-10oz");
  EXPECT_EQ(cut->pieces[2].fabric, "silk");
  EXPECT_EQ(*cut_of(coat(), "wool"), coat()) << "the same fabric is the same document";
  EXPECT_EQ(cut_of(coat(), "silk")->pieces[1].fabric, "silk");
}

TEST(SweepVariants, AFabricThatIsNowhereIsRefusedWithWhatComesNear) {
  const auto cut = cut_of(coat(), "denim-10os");
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().code, "project.unknown_fabric");
  EXPECT_NE(cut.error().message.find("denim-10oz"), std::string::npos) << cut.error().message;
}

TEST(SweepVariants, AnotherBodyTakesThePlaceOfTheOne) {
  const auto worn = worn_by(coat(), mannequin("anna", "eu40"));
  ASSERT_TRUE(worn);
  ASSERT_EQ(worn->bodies.size(), 1u);
  EXPECT_EQ(worn->bodies[0].mannequin->preset, "eu40");
  EXPECT_EQ(worn->bodies[0].file, "");
  EXPECT_EQ(worn->bodies[0].friction, 0.7);
  EXPECT_EQ(worn->bodies[0].skin_offset_mm, 3);
  EXPECT_EQ(worn_by(coat(), mannequin("ben", "m50"))->bodies.size(), 2u);
}

TEST(SweepVariants, AMannequinMovesAsTheOneBefore) {
  project::Project moving = coat();
  moving.bodies[0] = mannequin("anna", "eu38");
  project::ProjectKeyframe raised;
  raised.after_s = 1.5;
  raised.mannequin = moving.bodies[0].mannequin;
  raised.mannequin->pose = "t";
  moving.bodies[0].motion = {raised};
  const auto worn = worn_by(moving, mannequin("anna", "eu44"));
  ASSERT_TRUE(worn);
  ASSERT_EQ(worn->bodies[0].motion.size(), 1u);
  EXPECT_EQ(worn->bodies[0].motion[0].mannequin->preset, "eu44");
  EXPECT_EQ(worn->bodies[0].motion[0].mannequin->pose, "t");
  EXPECT_EQ(worn->bodies[0].motion[0].after_s, 1.5);
  moving.bodies[0].motion[0].mannequin.reset();
  moving.bodies[0].motion[0].file = "raised.obj";
  EXPECT_EQ(worn_by(moving, mannequin("anna", "eu44")).error().code, "sweep.moving_body");
}

TEST(SweepVariants, BodiesAreCalledByWhatTheyAre) {
  EXPECT_EQ(name_of(mannequin("anna", "eu38")), "eu38");
  project::ProjectBody wide = mannequin("anna", "eu38");
  wide.mannequin->measures_cm[static_cast<std::size_t>(measure::Measure::kWaist)] = 81.5;
  EXPECT_EQ(name_of(wide), "eu38 waist 81.5");
  EXPECT_EQ(name_of(mannequin("anna", "")), "mannequin");
  EXPECT_EQ(name_of(coat().bodies[0]), "anna.obj");
  EXPECT_EQ(main_body(coat()), "anna");
  EXPECT_EQ(main_body({}), "body");
}

}  // namespace
}  // namespace toile::sweep
