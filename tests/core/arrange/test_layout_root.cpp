// Which piece the flat layout begins with.

#include <gtest/gtest.h>

#include "core/arrange/layout_measures.h"

namespace toile {
namespace {

arrange::GarmentPiece front(const char* id, int hand, double area) {
  arrange::GarmentPiece piece;
  piece.id = id;
  piece.area = area;
  piece.cover = arrange::Cover::kTorso;
  piece.face = 1;
  piece.hand = hand;
  return piece;
}

arrange::GarmentTie tie(Index a, Index b) { return {a, b, {}, {}, 0}; }

/// A jacket's: the side fronts are larger than the fronts.
arrange::GarmentGraph panelled() {
  arrange::GarmentGraph graph;
  graph.pieces = {front("left side front", 1, 0.09), front("right side front", -1, 0.09),
                  front("left front", 1, 0.06), front("right front", -1, 0.06)};
  graph.ties = {tie(0, 2), tie(1, 3)};
  return graph;
}

TEST(RootOfTrunk, IsAFrontThatTheMiddleGoesThroughBeforeALargerOneAtTheSide) {
  arrange::GarmentGraph graph = panelled();
  graph.ties.push_back(tie(2, 3));
  const Index root = arrange::root_of_trunk(graph, {0, 1, 2, 3});
  EXPECT_TRUE(root == 2 || root == 3) << graph.pieces[static_cast<std::size_t>(root)].id;
}

TEST(RootOfTrunk, IsTheLargestWhereNoSeamJoinsTheHands) {
  const arrange::GarmentGraph graph = panelled();
  const Index root = arrange::root_of_trunk(graph, {0, 1, 2, 3});
  EXPECT_TRUE(root == 0 || root == 1) << graph.pieces[static_cast<std::size_t>(root)].id;
}

}  // namespace
}  // namespace toile
