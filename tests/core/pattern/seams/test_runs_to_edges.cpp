#include "core/pattern/seams/runs_to_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/pattern/seams/model.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

/// A sheet whose lower edge is cut in two, and two more.
struct Cut {
  seams::FoundSeams found;
  Index first = 0, second = kNone, front = kNone, back = kNone;

  explicit Cut(bool turned = false) {
    const pattern::Pattern pattern{{garments::strip("sleeve", 400, 300), garments::strip("front", 200, 500),
                                    garments::strip("back", 200, 500)},
                                   {}};
    found.model = seams::with_cuts(pattern, seams::make_seam_model(pattern), 0, {200});
    second = found.model.runs[0].next;
    front = 4;
    back = 8;
    found.gluing.turned = {static_cast<char>(turned), 0, 0};
  }
  std::vector<pattern::SeamEdge> edges(const std::vector<Index>& runs) const {
    double length = 0;
    return seams::edges_of_runs(found, runs, length);
  }
};

TEST(RunsToEdges, PartsThatFollowEachOtherAreOneEdgeAgain) {
  const Cut cut;
  const std::vector<pattern::SeamEdge> whole = cut.edges({cut.first, cut.second});
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].from, 0);
  EXPECT_EQ(whole[0].to, 1);
  EXPECT_EQ(cut.edges({cut.front, cut.back}).size(), 2U);
}

TEST(RunsToEdges, PartsThatOnlyARingBringsTogetherAreNot) {
  EXPECT_EQ(Cut().edges({Cut().second, Cut().first}).size(), 2U);
  const Cut turned(true);
  EXPECT_EQ(turned.edges({turned.second, turned.first}).size(), 1U) << "walked against the outline";
  EXPECT_EQ(turned.edges({turned.first, turned.second}).size(), 2U);
}

TEST(RunsToEdges, ARingBeginsAtEdgesEndsOnBothSides) {
  const Cut cut;
  // Side b is walked against its outline: from the second part to the first it goes on, from the first to the
  // second it wraps.
  const seams::FoundSeam wrapped{{cut.front, cut.back}, {cut.first, cut.second}, 0};
  EXPECT_EQ(seams::begun_at_an_end(cut.found, wrapped, true).b, (std::vector{cut.second, cut.first}));
  const seams::FoundSeam on_a{{cut.second, cut.first}, {cut.front, cut.back}, 0};
  EXPECT_EQ(seams::begun_at_an_end(cut.found, on_a, true).a, (std::vector{cut.first, cut.second}));
  const seams::FoundSeam both{{cut.front, cut.back}, {cut.back, cut.front}, 0};
  EXPECT_EQ(seams::begun_at_an_end(cut.found, both, true).a, both.a) << "several edges on both sides";
}

TEST(RunsToEdges, ACapIsSetInFromUnderTheArm) {
  // Front and back whose armholes go up to the shoulder: e2 of the one, e3 of the other.
  const std::vector<garments::Node> half{{0, 0}, {200, 0}, {200, 300}, {150, 500}, {0, 550}};
  pattern::Panel front = garments::piece("front", half), back = garments::piece("back", half);
  back = garments::mirrored(back, "back");
  const pattern::Pattern pattern{{garments::strip("sleeve", 400, 300), front, back}, {}};
  seams::FoundSeams found;
  found.model = seams::make_seam_model(pattern);
  found.gluing.turned = {0, 0, 0};
  const Index up = 4 + 2;  // of the front, counter-clockwise from under the arm
  Index down = kNone;      // of the back, towards it
  for (Index r = 9; r < 14; ++r)
    if (std::abs(found.model.runs[r].length - found.model.runs[up].length) < 1e-6 &&
        found.model.runs[r].at.front().y > found.model.runs[r].at.back().y)
      down = r;
  ASSERT_NE(down, kNone);
  const seams::FoundSeam from_the_shoulder{{down, up}, {2, 2}, 0};
  EXPECT_EQ(seams::begun_at_an_end(found, from_the_shoulder, true).a, (std::vector{up, down}));
  EXPECT_EQ(seams::begun_at_an_end(found, from_the_shoulder, false).a, from_the_shoulder.a) << "no ring";
}

}  // namespace
}  // namespace toile
