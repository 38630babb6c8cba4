#include "core/pattern/seams/runs_to_edges.h"

#include <gtest/gtest.h>

#include <string>
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

TEST(RunsToEdges, ARingBeginsAtAnEdgesEndWhicheverSideItIsOn) {
  const Cut cut;
  // Side b is walked against its outline: from the second part to the first it goes on, from the first to the
  // second it wraps.
  const seams::FoundSeam wrapped{{cut.front, cut.back}, {cut.first, cut.second}, 0};
  const seams::FoundSeam begun = seams::begun_at_an_end(cut.found, wrapped);
  EXPECT_EQ(begun.a, (std::vector{cut.back, cut.front}));
  EXPECT_EQ(begun.b, (std::vector{cut.second, cut.first}));
  EXPECT_EQ(seams::begun_at_an_end(cut.found, begun).b, begun.b) << "it stays";
  const seams::FoundSeam on_a{{cut.second, cut.first}, {cut.front, cut.back}, 0};
  EXPECT_EQ(seams::begun_at_an_end(cut.found, on_a).a, (std::vector{cut.first, cut.second}));
}

}  // namespace
}  // namespace toile
