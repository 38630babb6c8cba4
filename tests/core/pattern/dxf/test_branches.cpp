// Drawings on one layer, in which outlines meet other lines.

#include "core/pattern/validate.h"
#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

std::string frame(Vec2 at, double width, double height) {
  const Vec2 b = at + Vec2{width, 0}, c = at + Vec2{width, height}, d = at + Vec2{0, height};
  return line(at, b) + line(b, c) + line(c, d) + line(d, at);
}

dxf::DxfDrawing read_one_piece(const std::string& body, double area) {
  const dxf::DxfDrawing d = read_trial(entities(body), in_mm());
  EXPECT_EQ(d.pieces.size(), 1u);
  if (d.pieces.size() == 1) {
    EXPECT_NEAR(area_of(d.pieces[0]), area, 1e-6 * area);
    EXPECT_TRUE(d.pieces[0].holes.empty());
    EXPECT_TRUE(pattern::validate(panel_of(d.pieces[0])));
  }
  return d;
}

TEST(DxfBranches, AStyleLineFromCornerToCornerLeavesTheOutlineWhole) {
  for (const bool style_first : {true, false}) {
    const std::string style = line({300, 500}, {0, 0});
    const std::string outline = frame({0, 0}, 300, 500);
    const dxf::DxfDrawing d = read_one_piece(style_first ? style + outline : outline + style, 150'000);
    ASSERT_EQ(d.pieces.at(0).internals.size(), 1u);
    EXPECT_TRUE(told(d, "part an outline: it is taken around the outside"));
  }
}

TEST(DxfBranches, TicksAndLeadersThatHangOnCornersAreLinesOfThePiece) {
  const std::string ticks =
      line({0, 0}, {5, 5}) + line({300, 500}, {290, 480}) + line({290, 480}, {280, 480});
  const dxf::DxfDrawing d = read_one_piece(ticks + frame({0, 0}, 300, 500), 150'000);
  EXPECT_EQ(d.pieces.at(0).internals.size(), 2u);
  EXPECT_FALSE(told(d, "part an outline"));
}

TEST(DxfBranches, DartLegsWithinAClosedOutlineAreOneLine) {
  // The waist in three lines; the dart's legs go up from the ends of its mouth.
  const std::string body = line({0, 0}, {100, 0}) + line({100, 0}, {120, 0}) + line({120, 0}, {250, 0}) +
                           line({250, 0}, {250, 400}) + line({250, 400}, {0, 400}) + line({0, 400}, {0, 0}) +
                           line({100, 0}, {110, 90}) + line({110, 90}, {120, 0});
  const dxf::DxfDrawing d = read_one_piece(body, 100'000);
  ASSERT_EQ(d.pieces.at(0).internals.size(), 1u);
  EXPECT_EQ(d.pieces.at(0).internals[0].size(), 3u) << "both legs in one";
}

TEST(DxfBranches, LinesDrawnTwiceCountOnce) {
  const dxf::DxfDrawing d =
      read_one_piece(line({300, 0}, {0, 0}) + frame({0, 0}, 300, 500) + line({0, 0}, {0, 500}), 150'000);
  EXPECT_TRUE(told(d, "drawn a second time"));
  const dxf::DxfDrawing twice = read_one_piece(frame({0, 0}, 300, 500) + frame({0, 0}, 300, 500), 150'000);
  EXPECT_TRUE(told(twice, "drawn a second time"));
}

TEST(DxfBranches, PiecesJoinedByALineOrAPointAreTwo) {
  for (const std::string& joint : {line({300, 0}, {400, 0}), std::string()}) {
    const double x = joint.empty() ? 300 : 400, y = joint.empty() ? 500 : 0;
    const dxf::DxfDrawing d =
        read_trial(entities(frame({0, 0}, 300, 500) + joint + frame({x, y}, 200, 300)), in_mm());
    ASSERT_EQ(d.pieces.size(), 2u) << joint;
    EXPECT_NEAR(area_of(d.pieces[0]), 150'000, 1e-6);
    EXPECT_NEAR(area_of(d.pieces[1]), 60'000, 1e-6);
    EXPECT_FALSE(told(d, "part an outline"));
  }
}

TEST(DxfBranches, ASewLineHeldByCornerLinesIsStillTheSewLine) {
  const std::string held = line({0, 0}, {10, 10}) + line({300, 0}, {290, 10}) + line({300, 500}, {290, 490}) +
                           line({0, 500}, {10, 490});
  const dxf::DxfDrawing d =
      read_one_piece(frame({0, 0}, 300, 500) + held + frame({10, 10}, 280, 480), 280 * 480);
  EXPECT_TRUE(told(d, "gives way to the sew line"));
}

TEST(DxfBranches, CurvesThatLeaveOneCornerSideBySideAreToldApart) {
  // Two arcs over one chord: the outline takes the outer one, whichever is drawn first.
  const auto arc = [](double bulge) {
    return groups({{0, "LWPOLYLINE"},
                   {8, "0"},
                   {70, "0"},
                   {10, "0"},
                   {20, "0"},
                   {42, number(bulge)},
                   {10, "200"},
                   {20, "0"}});
  };
  const std::string sides = line({200, 0}, {200, 300}) + line({200, 300}, {0, 300}) + line({0, 300}, {0, 0});
  const double outer =
      std::abs(geometry::signed_area(read_trial(entities(arc(0.5) + sides), in_mm()).pieces.at(0).outline));
  for (const std::string& both : {arc(0.5) + arc(0.4), arc(0.4) + arc(0.5)}) {
    const dxf::DxfDrawing d = read_trial(entities(both + sides), in_mm());
    ASSERT_EQ(d.pieces.size(), 1u);
    EXPECT_NEAR(area_of(d.pieces[0]), outer, 1);
  }
}

TEST(DxfBranches, AHoleHeldByOneLineIsAHole) {
  const dxf::DxfDrawing d = read_trial(
      entities(frame({0, 0}, 300, 500) + line({0, 0}, {100, 100}) + frame({100, 100}, 50, 50)), in_mm());
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].holes.size(), 1u);
}

TEST(DxfBranches, AGridOfLinesIsBoundedWork) {
  std::string grid;
  for (int i = 0; i <= 60; ++i) {
    for (int k = 0; k < 60; ++k) {
      const double x = 50.0 * i, y = 50.0 * k;
      grid += line({x, y}, {x, y + 50}) + line({y, x}, {y + 50, x});
    }
  }
  const dxf::DxfDrawing d = read_one_piece(grid, 9'000'000);
  EXPECT_TRUE(told(d, "part an outline"));
}

}  // namespace
}  // namespace toile
