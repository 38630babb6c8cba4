// Which proposed seams are sewn.

#include "core/pattern/seams/accept.h"

#include <gtest/gtest.h>

#include "tests/core/arrange/garments.h"

namespace toile {
namespace {

seams::SeamProposal proposal(double confidence, pattern::SeamEdge a, pattern::SeamEdge b) {
  seams::SeamProposal p;
  p.confidence = confidence;
  p.seam.a = {a};
  p.seam.b = {b};
  return p;
}

/// A large front and back, and small pieces of these names.
pattern::Pattern front_and_back_and(const std::vector<std::string>& names) {
  pattern::Pattern pattern;
  const std::vector<Vec2> large{{0, 0}, {400, 0}, {400, 600}, {0, 600}};
  pattern.panels = {test::polygon("front", large), test::polygon("back", large)};
  for (const std::string& name : names)
    pattern.panels.push_back(test::polygon(name, {{0, 0}, {90, 0}, {90, 120}, {0, 120}}));
  return pattern;
}

TEST(AcceptSeams, OfAlternativesTheSurerOneIsSewn) {
  const std::vector<seams::SeamProposal> proposals{
      proposal(0.9, {0, 0}, {1, 0}),                     // sewn
      proposal(0.8, {1, 0}, {2, 0}),                     // wants an edge that is taken
      proposal(0.7, {2, 0}, {3, 1, false, 0, 0.5}),      // sewn: what it wants was not taken after all
      proposal(0.6, {2, 1}, {3, 1, false, 0.5, 1}),      // sewn: the other half
      proposal(0.55, {4, 0}, {3, 1, false, 0.4, 0.45}),  // a part of a taken part
      proposal(0.4, {5, 0}, {6, 0})};                    // not sure enough
  EXPECT_EQ(seams::sewn_together(proposals, 0.5), (std::vector<bool>{true, false, true, true, false, false}));
}

TEST(AcceptSeams, APieceThatNoSureSeamHoldsTakesALikelyOne) {
  const pattern::Pattern pattern = front_and_back_and({"yoke", "tab"});
  const std::vector<seams::SeamProposal> proposals{
      proposal(0.9, {0, 1}, {1, 3}),   // sure
      proposal(0.6, {0, 3}, {1, 1}),   // likely, of pieces that hang together
      proposal(0.6, {0, 2}, {2, 0}),   // likely, and all that holds the yoke
      proposal(0.55, {2, 0}, {3, 0}),  // the yoke's edge is taken
      proposal(0.4, {0, 0}, {3, 2})};  // a guess
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.8),
            (std::vector<bool>{true, false, true, false, false}));
}

TEST(AcceptSeams, WhatFitsNowhereElseIsSewnBetweenPiecesThatHangTogether) {
  const pattern::Pattern pattern = front_and_back_and({});
  const std::vector<seams::SeamProposal> proposals{
      proposal(0.9, {0, 1}, {1, 3}),           // sure
      proposal(seams::kFits, {0, 3}, {1, 1}),  // the other side
      proposal(0.64, {0, 2}, {1, 2})};         // less: the neck stays open
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.8), (std::vector<bool>{true, true, false}));
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.6), (std::vector<bool>{true, true, true}));
}

TEST(AcceptSeams, WhichWayASeamRunsIsNoDoubtThatItIsOne) {
  seams::SeamProposal one = proposal(0.4, {0, 2}, {2, 0}), other = proposal(0.35, {0, 2}, {2, 0});
  other.seam.a[0].reversed = true;
  const pattern::Pattern pattern = front_and_back_and({"collar"});
  const std::vector<seams::SeamProposal> proposals{proposal(0.9, {0, 1}, {1, 3}), one, other};
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.8), (std::vector<bool>{true, true, false}));
  EXPECT_EQ(seams::sewn_to_wear(pattern, std::vector{proposals[0], one}, 0.8),
            (std::vector<bool>{true, false}));
}

TEST(AcceptSeams, TheRestOfAnEdgeThatIsSewnInPartIsSewnWithIt) {
  const pattern::Pattern pattern = front_and_back_and({"sleeve"});
  seams::SeamProposal first = proposal(0.9, {0, 1}, {2, 3}), rest = proposal(0.6, {1, 3}, {2, 3});
  first.seam.b[0].to = 0.5;
  rest.seam.b[0].from = 0.5;
  const std::vector<seams::SeamProposal> proposals{first, proposal(0.85, {0, 3}, {1, 1}), rest,
                                                   proposal(0.6, {0, 2}, {1, 2})};
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.8), (std::vector<bool>{true, true, true, false}));
}

TEST(AcceptSeams, ALegOfOnePieceIsClosedByALikelySeam) {
  pattern::Pattern pattern;
  for (const char* name : {"LEG", "LEG_2", "APRON"})
    pattern.panels.push_back(test::polygon(name, {{0, 0}, {90, 0}, {90, 120}, {0, 120}}));
  const std::vector<seams::SeamProposal> proposals{
      proposal(0.95, {0, 2}, {1, 2}), proposal(0.9, {1, 0}, {2, 0}),  // all of them hang together
      proposal(0.6, {0, 1}, {0, 3}),                                  // closes the leg
      proposal(0.6, {2, 1}, {2, 3}),                                  // an apron is open
      proposal(0.45, {1, 1}, {1, 3})};                                // a guess
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.8),
            (std::vector<bool>{true, true, true, false, false}));
}

TEST(AcceptSeams, WhereNothingIsSureTheLikelyIsSewn) {
  const std::vector<seams::SeamProposal> proposals{proposal(0.7, {0, 1}, {1, 3}),
                                                   proposal(0.6, {0, 3}, {1, 1})};
  EXPECT_EQ(seams::sewn_to_wear(front_and_back_and({}), proposals, 0.8), (std::vector<bool>{true, true}));
}

TEST(AcceptSeams, ALiningDoesWithoutALikelySeam) {
  const std::vector<seams::SeamProposal> proposals{proposal(0.9, {0, 1}, {1, 3}),
                                                   proposal(0.6, {0, 2}, {2, 0})};
  EXPECT_EQ(seams::sewn_to_wear(front_and_back_and({"lining"}), proposals, 0.8),
            (std::vector<bool>{true, false}));
}

/// The pocket of a hooded shirt was sewn to its hood, which no seam held surely enough.
TEST(AcceptSeams, APieceThatNothingHoldsIsNotSewnToALayer) {
  const std::vector<seams::SeamProposal> proposals{proposal(0.9, {0, 1}, {1, 3}),
                                                   proposal(0.6, {2, 0}, {3, 2})};
  EXPECT_EQ(seams::sewn_to_wear(front_and_back_and({"hood", "lining"}), proposals, 0.8),
            (std::vector<bool>{true, false}));
  EXPECT_EQ(seams::sewn_to_wear(front_and_back_and({"hood", "yoke"}), proposals, 0.8),
            (std::vector<bool>{true, true}));
}

TEST(AcceptSeams, SeamsThatThePatternHasHoldPieces) {
  pattern::Pattern pattern = front_and_back_and({"yoke"});
  pattern.seams = {test::seam("s", {{0, 2}}, {{2, 0}}), test::seam("t", {{0, 1}}, {{1, 3}})};
  const std::vector<seams::SeamProposal> proposals{proposal(0.6, {2, 2}, {1, 2})};
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.8), (std::vector<bool>{false}));
}

TEST(AcceptSeams, WhatIsSetInAllAroundIsClosed) {
  const pattern::Pattern pattern = front_and_back_and({"sleeve", "yoke"});
  seams::SeamProposal cap = proposal(0.9, {0, 1}, {2, 2});  // the sleeve's cap to front and back
  cap.seam.a.push_back({1, 3});
  const std::vector<seams::SeamProposal> proposals{
      cap, proposal(0.85, {0, 3}, {1, 1}),
      proposal(0.85, {0, 2}, {3, 2}),                // of the other piece one end is sewn, to the front alone
      proposal(seams::kClosesTube, {2, 1}, {2, 3}),  // closes the sleeve
      proposal(0.45, {3, 1}, {3, 3})};
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.8), (std::vector<bool>{true, true, true, true, false}));
  pattern::Pattern collared = pattern;
  collared.panels[2].id = "collar";
  EXPECT_FALSE(seams::sewn_to_wear(collared, proposals, 0.8)[3]) << "which is open in front";
  std::vector<seams::SeamProposal> less = proposals;
  less[3].confidence = 0.2;
  EXPECT_FALSE(seams::sewn_to_wear(pattern, less, 0.8)[3]);
}

TEST(AcceptSeams, ATrimOfWhichNothingTellsTakesNoneInDoubt) {
  const pattern::Pattern pattern = front_and_back_and({"Zwirbel"});
  const std::vector<seams::SeamProposal> proposals{proposal(0.9, {0, 1}, {1, 3}),
                                                   proposal(0.75, {0, 2}, {2, 0})};
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.8), (std::vector<bool>{true, false}));
  EXPECT_EQ(seams::sewn_to_wear(pattern, proposals, 0.7), (std::vector<bool>{true, true}));
}

}  // namespace
}  // namespace toile
