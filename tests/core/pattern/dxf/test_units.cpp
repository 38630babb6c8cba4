// Which unit a drawing is in: every statement that real files make, and the sizes of the pieces.

#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

/// A piece as high as that, with a text on its unit.
std::string drawing(double height, const std::string& units = "", const std::string& head = "") {
  return head +
         entities(rectangle({0, 0}, height / 2, height) + (units.empty() ? "" : text({0, 0}, units, "1")));
}

void expect_unit(const std::string& text, const std::string& name, double least_confidence) {
  const dxf::DxfDrawing d = read_trial(text);
  EXPECT_EQ(d.unit.name, name);
  EXPECT_GE(d.unit.confidence, least_confidence) << name;
  EXPECT_LE(d.unit.confidence, 1) << name;
  EXPECT_EQ(d.unit.mm, d.mm_per_unit);
  EXPECT_FALSE(d.unit.evidence.empty());
}

TEST(DxfUnits, TheHeaderStatesThem) {
  expect_unit(drawing(27, "", header(1)), "inch", 0.95);
  expect_unit(drawing(2.3, "", header(2)), "foot", 0.95);
  expect_unit(drawing(700, "", header(4)), "mm", 0.95);
  expect_unit(drawing(70, "", header(5)), "cm", 0.95);
  expect_unit(drawing(0.7, "", header(6)), "m", 0.95);
  expect_unit(drawing(60, "", header(4)), "mm", 0.8);  // a pocket alone
}

TEST(DxfUnits, AHeaderThatMakesGiantsIsNotBelieved) {
  expect_unit(drawing(700, "", header(6)), "mm", 0.9);  // some libraries write metres whatever they draw
  expect_unit(drawing(700, "", header(1)), "mm", 0.8);
}

TEST(DxfUnits, AScaleStatesThem) {
  expect_unit(drawing(200, "Scale: 1 unit = 1 cm"), "cm", 0.95);
  expect_unit(drawing(30, "Massstab: 1 unit = 1 inch"), "inch", 0.95);
}

TEST(DxfUnits, OtherLanguagesStateThem) {
  expect_unit(drawing(200, "Einheiten: cm"), "cm", 0.95);
  expect_unit(drawing(200, "Unidades: cm"), "cm", 0.95);
}

TEST(DxfUnits, AGarmentOfNothingWideIsInCentimetres) {
  const std::string robe = entities(rectangle({0, 0}, 45, 121) + rectangle({200, 0}, 73, 117) +
                                    rectangle({400, 0}, 14, 263) + text({0, 0}, "Units: METRIC", "1"));
  expect_unit(robe, "cm", 0.7);
}

TEST(DxfUnits, MetricIsMillimetresOrCentimetresByTheSizeOfThePieces) {
  expect_unit(drawing(815, "Units: METRIC"), "mm", 0.9);
  expect_unit(drawing(75, "UNITS: METRIC"), "cm", 0.6);
  expect_unit(drawing(75, "units:Metric"), "cm", 0.6);
}

/// A band alone would do for millimetres; but nothing of it goes over a body.
TEST(DxfUnits, ARobeInCentimetresIsKnownByItsWidestPieceNotByItsBand) {
  const auto robe = [](double wide) {
    std::string pieces;
    for (const double x : {0.0, 100.0}) pieces += rectangle({x, 0}, wide, 100);
    return entities(pieces + rectangle({200, 0}, 10, 221) + text({0, 0}, "Units: METRIC", "1"));
  };
  expect_unit(robe(60), "cm", 0.6);
  expect_unit(entities(rectangle({200, 0}, 10, 221) + text({0, 0}, "Units: METRIC", "1")), "mm", 0.5);
}

TEST(DxfUnits, EnglishIsInches) {
  expect_unit(drawing(24, "Units: ENGLISH"), "inch", 0.95);
  expect_unit(drawing(118, "UNITS: ENGLISH"), "inch", 0.8);  // a box of three metres
}

TEST(DxfUnits, WithoutAWordTheSizeDecidesAndTheDoubtIsTold) {
  expect_unit(drawing(700), "mm", 0.9);
  const dxf::DxfDrawing unsure = read_trial(drawing(50));
  EXPECT_LT(unsure.unit.confidence, 0.8);
  EXPECT_TRUE(told(unsure, "the unit is not sure"));
}

TEST(DxfUnits, AUnitThatWasAskedForIsTakenAndAGiantIsTold) {
  const auto read_in = [](double height, double mm_per_unit) {
    dxf::DxfSettings settings;
    settings.mm_per_unit = mm_per_unit;
    return read_trial(drawing(height, "", header(4)), settings);
  };
  const dxf::DxfDrawing giant = read_in(700, 25.4);
  EXPECT_EQ(giant.unit.name, "inch");
  EXPECT_TRUE(told(giant, "the largest piece is 17.8 m in the unit that was asked for (inch)"));
  EXPECT_TRUE(told(giant, "that piece to be 700 mm: leave the unit out, or give mm"));
  ASSERT_TRUE(giant.unit.doubt);
  EXPECT_EQ(giant.unit.doubt->own, "mm");
  EXPECT_NEAR(giant.unit.doubt->largest_mm, 17780, 1e-6);
  EXPECT_NEAR(giant.unit.doubt->largest_own, 700, 1e-6);
  EXPECT_FALSE(read_in(150, 25.4).unit.doubt);
  EXPECT_TRUE(told(read_in(700, 0.01), "the largest piece is 7.0 mm"));
  EXPECT_FALSE(told(read_in(150, 25.4), "asked for"));  // 3.8 m: a curtain may be
  EXPECT_FALSE(told(read_in(6000, 1), "asked for"));    // the file says so itself
}

TEST(DxfUnits, EvidenceNamesLengthsAsPeopleSayThem) {
  const auto says = [](double height, const std::string& words) {
    for (const std::string& evidence : read_trial(drawing(height)).unit.evidence)
      if (evidence.find(words) != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(says(1363, "measures 1363 units: 1363 mm as mm, 13.6 m as cm, 34.6 m as inch"));
  EXPECT_TRUE(says(27.5, "measures 27.5 units: 28 mm as mm, 275 mm as cm, 698 mm as inch"));
  EXPECT_TRUE(says(5.25, "5.2 mm as mm")) << "and small ones to the tenth";
}

TEST(DxfUnits, TheUserOverrulesThem) {
  dxf::DxfSettings settings;
  settings.mm_per_unit = 10;
  const dxf::DxfDrawing d = read_trial(drawing(700, "Units: ENGLISH", header(4)), settings);
  EXPECT_EQ(d.unit.name, "cm");
  EXPECT_EQ(d.unit.confidence, 1);
  EXPECT_NEAR(area_of(d.pieces[0]), 3500.0 * 7000, 1e-3);
}

TEST(DxfUnits, AnEmptyOrMissingHeaderOrLimitsOfTenToTheTwentyDoNoHarm) {
  const std::string body = entities(rectangle({0, 0}, 350, 700));
  EXPECT_EQ(read_trial(body).unit.name, "mm");
  EXPECT_EQ(read_trial(section("HEADER", "") + body).unit.name, "mm");
  const std::string limits = section("HEADER", groups({{9, "$ACADVER"},
                                                       {1, "AC1006"},
                                                       {9, "$EXTMIN"},
                                                       {10, "1e+20"},
                                                       {20, "1e+20"},
                                                       {9, "$EXTMAX"},
                                                       {10, "-1e+20"},
                                                       {20, "-1e+20"}}));
  EXPECT_EQ(read_trial(limits + body).unit.name, "mm");
}

TEST(DxfUnits, InchesWithOpenSidesCloseAlthoughTheirFirstReadingWasInAnotherUnit) {
  const dxf::DxfDrawing d =
      read_trial(section("BLOCKS", block("A_36", open_sides({1, 1}, 20.1234, 27.5678, "1"))) +
                 entities(text({0, 0}, "Units: ENGLISH", "1") + insert("A_36", {0, 0})));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_NEAR(area_of(d.pieces[0]), 20.1234 * 27.5678 * 25.4 * 25.4, 0.1);
}

}  // namespace
}  // namespace toile
