// Small faults of outlines that importing mends, so that what is imported can be sewn.

#include <cmath>
#include <vector>

#include "core/pattern/validate.h"
#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

std::string outline(const std::vector<Vec2>& points) {
  std::string out = groups({{0, "POLYLINE"}, {8, "1"}, {66, "1"}, {70, "1"}});
  for (const Vec2 p : points) out += groups({{0, "VERTEX"}, {8, "1"}, {10, number(p.x)}, {20, number(p.y)}});
  return out + groups({{0, "SEQEND"}});
}

/// The drawing's only piece, after a look whether it can be sewn.
dxf::DxfDrawing sound_drawing(const std::vector<Vec2>& points) {
  dxf::DxfDrawing d = read_trial(entities(outline(points)), in_mm());
  EXPECT_EQ(d.pieces.size(), 1u);
  for (const dxf::DxfPiece& piece : d.pieces) {
    const Status sound = pattern::validate(panel_of(piece));
    EXPECT_TRUE(sound) << to_string(sound.error());
  }
  return d;
}

TEST(DxfRepair, AnOutlineThatTurnsBackByLittleIsSmoothedAndTold) {
  const std::vector<std::vector<Vec2>> backtracks{
      {{200, 0}, {199.96, 0.01}},                // goes on from there
      {{200, 0}, {199.96, 0}},                   // on the very line
      {{200, 0}, {200, 0.04}, {200.001, 0}},     // a spike
      {{200, 0}, {199.96, 0}, {199.99, 0.005}},  // twice
      {{200, 0}, {160, 0}},                      // by 40 mm, along itself
      {{200, 0}, {200, 30}, {200.001, 0}},       // a slash without width
      {{400.04, 0.01}},                          // beyond the corner
      {{400, 0}, {399.96, 0.01}},                // back from the corner
  };
  for (const std::vector<Vec2>& some : backtracks) {
    std::vector<Vec2> points{{0, 0}};
    points.insert(points.end(), some.begin(), some.end());
    points.insert(points.end(), {{400, 0.02}, {380, 300}, {0, 300}});
    for (const bool reversed : {false, true}) {
      if (reversed) std::reverse(points.begin(), points.end());
      const dxf::DxfDrawing d = sound_drawing(points);
      EXPECT_TRUE(told(d, "turned back on itself")) << some[0].x;
      ASSERT_EQ(d.pieces.size(), 1u);
      EXPECT_NEAR(area_of(d.pieces[0]), 390 * 300, 30);
    }
  }
}

TEST(DxfRepair, SharpTipsOfThePieceItselfStay) {
  const dxf::DxfDrawing d = sound_drawing({{0, 0}, {400, 0}, {400, 20}, {2, 1}, {0, 300}});
  EXPECT_FALSE(told(d, "turned back"));
  EXPECT_EQ(d.pieces.at(0).outline.size(), 5u);
}

TEST(DxfRepair, ACurveThatLeavesALineByADegreeDoesNotCrossIt) {
  // Vertices of an arc of 150 mm, 18 mm apart: its first chord runs a degree below the straight line, and an
  // arc through the vertices begins above it.
  constexpr double kStep = 18, kRadius = 150, kDegree = 0.0174533;
  std::vector<Vec2> points{{0, 0}};
  for (int i = 0; i < 12; ++i) {
    const double angle = -kDegree - i * kStep / kRadius;
    points.push_back(points.back() + kStep * Vec2{std::cos(angle), std::sin(angle)});
  }
  points.insert(points.end(), {{190, -100}, {190, 0}});
  EXPECT_TRUE(sound_drawing(points).notes.empty());
  EXPECT_TRUE(sound_drawing({points.rbegin(), points.rend()}).notes.empty());
}

}  // namespace
}  // namespace toile
