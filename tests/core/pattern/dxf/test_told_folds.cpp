// Halves of which a text says that they are cut on the fold, and no line where it lies.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/dxf/told_folds.h"
#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;  // NOLINT(google-build-using-namespace): names of a test's own text

/// Half a front, its middle at x = 0; the side slants.
const std::string kFront =
    polyline({{0, 0}, {250, 0}, {230, 400}, {210, 560}, {90, 600}, {60, 540}, {0, 520}}, "1") +
    line({100, 100}, {100, 400}, "7");

/// The only piece of a drawing of those lines and texts.
dxf::DxfPiece only_piece(const std::string& body) {
  const dxf::DxfDrawing drawing = read_trial(blocks_and_inserts({{"PIECE", body}}));
  EXPECT_EQ(drawing.pieces.size(), 1U);
  return drawing.pieces.at(0);
}

Vec2 size_of(const dxf::DxfPiece& piece) { return bounding_box(piece.outline).size(); }

dxf::DxfPiece half(const std::vector<Vec2>& outline, Vec2 grain = {0, 1}) {
  dxf::DxfPiece piece;
  piece.outline = outline;
  piece.grain = grain;
  return piece;
}

TEST(DxfToldFolds, OnTheFoldIsToldInManyLanguages) {
  for (const char* text :
       {"Cut 1 on fold", "PLACE ON THE FOLD", "1x im Stoffbruch", "IM BRUCH", "Tagliare 1x in piega",
        "AU PLI", "x2 PLIURE", "CORTAR 1 AL DOBLEZ", "1x aan stofvouw", "1 x w zgi\u0119ciu", "1 taitteelta"})
    EXPECT_TRUE(dxf::tells_fold(text)) << text;
  for (const char* text : {"CF and fold line marked", "1x, Bruch der Laenge nach", "CUT 1 - FOLD LENGTHWISE",
                           "FOLD", "CUFF FOLDED", "PIEGA CINTURA", "front", "2 x fold"})
    EXPECT_FALSE(dxf::tells_fold(text)) << text;
}

TEST(DxfToldFolds, LabelsAtTheFoldNameNoPiece) {
  for (const char* text : {"PLACE ON FOLD", "IN PIEGA", "BRUCH", "ZGI\u0118CIE", "fold"})
    EXPECT_TRUE(dxf::tells_only_fold(text)) << text;
  for (const char* text : {"FRONT on fold", "yoke", "cut line"})
    EXPECT_FALSE(dxf::tells_only_fold(text)) << text;
  const dxf::DxfPiece piece =
      only_piece(kFront + text({5, 300}, "IN PIEGA", "1") + text({60, 200}, "DAVANTI", "1"));
  EXPECT_TRUE(piece.unfolded);
  EXPECT_NEAR(size_of(piece).x, 500, 1e-6) << "about its middle, not its side";
}

TEST(DxfToldFolds, AHalfIsUnfoldedWhateverTellsItAndCountsOnce) {
  for (const char* told : {"ANNOTATION: Cut 1 on fold", "Quantity: 2 on fold", "CUT 1 ON FOLD"}) {
    const dxf::DxfPiece piece = only_piece(kFront + text({60, 200}, told, "1"));
    EXPECT_TRUE(piece.unfolded) << told;
    EXPECT_NEAR(std::abs(geometry::signed_area(piece.outline)),
                2 * std::abs(geometry::signed_area(only_piece(kFront).outline)), 1e-6)
        << told;
    EXPECT_EQ(piece.mirrored, 0) << "it is its own mirror image";
  }
  EXPECT_FALSE(only_piece(kFront + text({60, 200}, "BRUCH", "1")).unfolded) << "a label of some fold";
}

TEST(DxfToldFolds, WhatHasNoStraightEdgeStaysAsItIsDrawn) {
  dxf::DxfPiece all_round = half({});
  for (int k = 0; k < 60; ++k) {
    const double a = k * std::numbers::pi / 30;
    all_round.outline.push_back({100 * std::cos(a) + 10 * std::cos(3 * a), 100 * std::sin(a)});
  }
  EXPECT_FALSE(dxf::likely_fold(all_round)) << "no edge is as long as a fold";
  const dxf::DxfDrawing whole = read_trial(blocks_and_inserts(
      {{"PIECE", polyline({{-200, 0}, {200, 0}, {180, 500}, {60, 560}, {-60, 560}, {-180, 500}}, "1") +
                     text({10, 70}, "CUT 1 ON FOLD", "1")}}));
  ASSERT_EQ(whole.pieces.size(), 1U);
  EXPECT_FALSE(whole.pieces[0].unfolded);
  EXPECT_TRUE(told(whole, "nothing says where"));
}

TEST(DxfToldFolds, AnEdgeWithTheLabelIsTheFold) {
  // A quarter of a skirt, with two straight edges alike: either may be meant.
  const std::string quarter = polyline({{0, 0}, {400, 0}, {370, 200}, {200, 370}, {0, 400}}, "1");
  for (const bool below : {false, true}) {
    const Vec2 at = below ? Vec2{200, 10} : Vec2{10, 200};
    const dxf::DxfPiece piece = only_piece(quarter + text(at, "PLACE ON FOLD", "1"));
    ASSERT_TRUE(piece.unfolded);
    EXPECT_NEAR(size_of(piece).y, below ? 800 : 400, 1e-6);
  }
}

TEST(DxfToldFolds, GoAcrossStripsAndCollars) {
  const std::vector<Vec2> strip{{0, 0}, {350, 0}, {350, 60}, {0, 60}};
  const std::vector<Vec2> collar{{0, 0}, {150, 5}, {210, 25}, {200, 90}, {0, 75}};
  for (const std::vector<Vec2>& outline : {strip, collar}) {
    const auto axis = dxf::likely_fold(half(outline));
    ASSERT_TRUE(axis);
    EXPECT_NEAR(std::abs(axis->along.y), 1, 1e-9) << "at an end";
  }
  const std::vector<Vec2> panel{{0, 0}, {110, 0}, {95, 300}, {105, 560}, {40, 600}, {0, 585}};
  const auto axis = dxf::likely_fold(half(panel));
  ASSERT_TRUE(axis);
  EXPECT_NEAR(axis->at.x, 0, 1e-9) << "along a dress's narrow middle";
}

TEST(DxfToldFolds, WholePiecesAreNotUnfolded) {
  const std::vector<Vec2> whole{{-200, 0}, {200, 0}, {180, 500}, {60, 560}, {-60, 560}, {-180, 500}};
  EXPECT_FALSE(dxf::likely_fold(half(whole)));
}

}  // namespace
}  // namespace toile
