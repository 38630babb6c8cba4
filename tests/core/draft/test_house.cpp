// What nobody wears: solids by code, and what is cut to them.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "core/draft/chair_cover.h"
#include "core/draft/curtain.h"
#include "core/draft/joined_boxes.h"
#include "core/pattern/curve.h"
#include "tests/core/draft/panel.h"

namespace toile {
namespace {

/// Whether each edge belongs to two triangles that run along it in opposite directions.
bool is_closed(const geometry::TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, int> ways;
  for (const Tri& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) ++ways[{t[i], t[(i + 1) % 3]}];
  for (const auto& [edge, count] : ways) {
    const auto back = ways.find({edge.second, edge.first});
    if (count != 1 || back == ways.end() || back->second != 1) return false;
  }
  return !ways.empty();
}

/// m³, positive where triangles face outwards.
double volume_of(const geometry::TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  return sum;
}

double longest_edge(const geometry::TriangleMesh& mesh) {
  double most = 0;
  for (const Tri& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      most = std::max(most, length(mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]));
  return most;
}

double edge_length(const draft::Garment& g, const std::string& piece, const std::string& edge) {
  return pattern::arc_length(draft::edge_of(panel(g, piece), edge));
}

TEST(JoinedBoxes, TouchingBoxesAreOneSolidWithNothingWithin) {
  const geometry::TriangleMesh mesh =
      draft::joined_boxes({{{0, 0, 0}, {1, 0.1, 1}}, {{0, 0.1, 0}, {1, 1, 0.3}}}, 0.25);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume_of(mesh), 0.1 + 0.9 * 0.3, 1e-12);
  EXPECT_LE(longest_edge(mesh), 0.25 * std::sqrt(2.0) + 1e-12);
}

TEST(JoinedBoxes, OverlappingBoxesCountOnce) {
  const geometry::TriangleMesh mesh =
      draft::joined_boxes({{{0, 0, 0}, {2, 1, 1}}, {{1, 0, 0}, {3, 1, 1}}}, 10);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume_of(mesh), 3, 1e-12);
}

TEST(Chair, IsClosedStandsOnTheFloorAndLeansBack) {
  const draft::ChairSize size;
  const geometry::TriangleMesh mesh = draft::chair_solid(size);
  EXPECT_TRUE(is_closed(mesh));
  const double legs = 4 * size.leg * size.leg * (size.seat - size.cushion);
  const double seat = size.width * size.depth * size.cushion;
  const double back = size.width * size.back_thick * size.back;
  EXPECT_NEAR(volume_of(mesh), (legs + seat + back) * 1e-9, 1e-9) << "leaning back changes no volume";
  double low = 1, high = 0, behind = 0;
  for (const Vec3& p : mesh.vertices) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
    behind = std::min(behind, p.z);
  }
  EXPECT_EQ(low, 0);
  EXPECT_NEAR(high, (size.seat + size.back) * 1e-3, 1e-9);
  EXPECT_NEAR(behind, -(size.depth / 2 + size.rake * size.back) * 1e-3, 1e-9);
}

TEST(ChairCover, IsLargerThanTheChairByItsEaseAndClearsTheFloor) {
  const draft::ChairSize chair;
  const draft::ChairCoverStyle style;
  const draft::Garment g = draft::draft_chair_cover(style, chair);
  EXPECT_NEAR(edge_length(g, "seat", "bottom"), chair.width + 2 * style.ease, 1e-6);
  EXPECT_NEAR(edge_length(g, "seat", "right"), chair.depth - chair.back_thick, 1e-6)
      << "what is free of the back: the ease before it is the back's";
  EXPECT_NEAR(edge_length(g, "top boxing", "right"), chair.back_thick + 2 * style.ease, 1e-6);
  const double slant = std::hypot(1, chair.rake) * (chair.back + style.ease);
  for (const char* back : {"inside back", "outside back"})
    EXPECT_NEAR(edge_length(g, back, "left"), slant, 1e-6);
  const double hem = edge_length(g, "front skirt", "hem");
  EXPECT_NEAR(hem - edge_length(g, "front skirt", "top"), 2 * style.flare, 1e-6);
  for (const char* side : {"left skirt", "right skirt"})
    EXPECT_NEAR(edge_length(g, side, "seat") + edge_length(g, side, "boxing"), chair.depth + 2 * style.ease,
                1e-6);
}

TEST(Curtain, IsDrawnUpToWhatItCoversOfTheRail) {
  const draft::CurtainStyle style;
  const draft::Garment g = draft::draft_curtain(style);
  ASSERT_EQ(g.hooks.size(), 2u);
  for (const draft::DraftedElastic& tape : g.elastics) EXPECT_EQ(tape.factor, 1 / style.fullness);
  for (const draft::DraftedHooks& hooks : g.hooks) {
    ASSERT_EQ(hooks.points.size(), static_cast<size_t>(style.hooks));
    ASSERT_EQ(hooks.places.size(), hooks.points.size());
    const double flat = hooks.points.back().x - hooks.points.front().x;
    const double hung = (hooks.places.back().x - hooks.places.front().x) * 1e3;
    EXPECT_NEAR(hung, style.covered, 1e-6);
    EXPECT_NEAR(flat, style.fullness * style.covered, 1e-6);
    EXPECT_NEAR(edge_length(g, hooks.piece, "bottom"), flat, 1e-6) << "the heading is as wide as the cloth";
    const std::vector<Vec2>& tape = panel(g, hooks.piece).lines.front().points;
    for (const Vec2& p : hooks.points) EXPECT_NEAR(p.y, tape.front().y, 1e-6) << "hooks sit on the tape";
    for (const Vec3& p : hooks.places) EXPECT_LE(std::abs(p.x), style.rail / 2 * 1e-3 + 1e-9);
  }
}

}  // namespace
}  // namespace toile
