// Which collars turn down, and where.

#include "core/project/create/collar_folds.h"

#include <gtest/gtest.h>

#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::piece;
using garments::strip;

/// A front and a back with these pieces, the first of which is sewn to their necks by its edge 0.
pattern::Pattern top_with(const std::vector<pattern::Panel>& around_neck) {
  pattern::Pattern pattern;
  pattern.panels = {garments::plain_top("Front", 560), garments::plain_top("Back", 620)};
  pattern.panels.insert(pattern.panels.end(), around_neck.begin(), around_neck.end());
  pattern.seams = {
      {"left", {{0, 3}}, {{1, 5}}}, {"right", {{0, 5}}, {{1, 3}}}, {"neck", {{0, 4}, {1, 4}}, {{2, 0}}}};
  return pattern;
}

/// Its outer edge is longer at each end, mm.
pattern::Panel collar(double breadth, double points, const std::string& name = "Collar") {
  return piece(name, {{0, 0}, {400, 0}, {400 + points, breadth}, {-points, breadth}});
}

TEST(CollarFolds, AFallTurnsDownAlongItsStandsSeam) {
  pattern::Pattern shirt = top_with({strip("Collar stand", 400, 30), collar(65, 12)});
  shirt.seams.push_back({"fall", {{2, 2}}, {{3, 0}}});
  const auto folds = create::collar_folds(shirt);
  ASSERT_EQ(folds.size(), 1u);
  EXPECT_EQ(folds[0].panel, 3);
  EXPECT_EQ(folds[0].stand, 2);
  EXPECT_EQ(folds[0].fold.piece, "Collar");
  EXPECT_EQ(folds[0].fold.lines, std::vector<std::string>{shirt.panels[3].outline.edges[0].id});
  EXPECT_LT(folds[0].fold.angle, -135) << "outwards: the outsides of stand and fall come together";
  EXPECT_TRUE(folds[0].lines.empty());

  shirt.seams.back() = {"fall", {{2, 2}}, {{3, 0, true}}, false};
  EXPECT_GT(create::collar_folds(shirt).at(0).fold.angle, 135) << "sewn with its wrong side outside";
}

TEST(CollarFolds, ACollarOfOnePieceTurnsDownWithin) {
  const pattern::Pattern shirt = top_with({collar(70, 15)});
  const auto folds = create::collar_folds(shirt);
  ASSERT_EQ(folds.size(), 1u);
  ASSERT_EQ(folds[0].lines.size(), 1u);
  EXPECT_EQ(folds[0].fold.lines, std::vector<std::string>{folds[0].lines[0].id});
  const std::vector<Vec2>& line = folds[0].lines[0].points;
  for (const Vec2 p : line) EXPECT_NEAR(p.y, 28, 1) << "two fifths of its breadth stand";
  EXPECT_NEAR(std::min(line.front().x, line.back().x), -6, 0.5);
  EXPECT_NEAR(std::max(line.front().x, line.back().x), 406, 0.5);
}

TEST(CollarFolds, AFlatCollarTurnsDownAtTheNeck) {
  const auto folds = create::collar_folds(top_with({collar(70, 90)}));
  ASSERT_EQ(folds.size(), 1u);
  EXPECT_TRUE(folds[0].lines.empty());
}

TEST(CollarFolds, WhatStandsIsLeft) {
  const auto count = [](const std::vector<pattern::Panel>& pieces) {
    return create::collar_folds(top_with(pieces)).size();
  };
  EXPECT_EQ(count({collar(70, 15)}), 1u);
  EXPECT_EQ(count({collar(40, 8)}), 0u) << "it is too low to turn over";
  EXPECT_EQ(count({collar(70, 15, "Collar stand")}), 0u) << "its name says so";
  EXPECT_EQ(count({collar(80, 15, "Collar rib")}), 1u) << "of ribs it does not";
  EXPECT_EQ(count({collar(70, 0)}), 0u) << "a zip may close it up to its edge";
  EXPECT_EQ(count({collar(70, 0), strip("Placket", 30, 150)}), 1u) << "as a polo shirt's";
  EXPECT_EQ(count({collar(90, 0)}), 1u) << "nothing stands so high";
  EXPECT_EQ(count({collar(70, 15, "Hood")}), 0u);
  pattern::Pattern ring = top_with({collar(70, 15)});
  ring.seams.push_back({"ends", {{2, 1}}, {{2, 3}}});
  EXPECT_TRUE(create::collar_folds(ring).empty()) << "a polo neck";
  pattern::Pattern held = top_with({collar(70, 15)});
  held.seams.push_back({"front edge", {{0, 0}}, {{2, 2}}});
  EXPECT_TRUE(create::collar_folds(held).empty()) << "sewn all around";
}

}  // namespace
}  // namespace toile
