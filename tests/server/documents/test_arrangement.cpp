#include "server/documents/arrangement.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// Of one piece, "front", which an arrangement holds at its height by edge e0.
struct OnePiece {
  OnePiece() {
    pattern.panels.resize(1);
    pattern.panels[0].id = "front";
    pattern.panels[0].outline.edges = {{"e0", {}}, {"e1", {}}};
    project.pieces.resize(1);
    project.pieces[0].id = "front";
    made.placements.resize(1);
    sewing::Attachment hold;
    hold.id = "hold_front";
    hold.panel = 0;
    hold.edges = {0};
    made.attachments = {hold};
  }
  std::vector<std::string> ids() const {
    std::vector<std::string> ids;
    for (const project::ProjectAttachment& a : project.attachments) ids.push_back(a.id);
    return ids;
  }
  void arrange() { documents::take_arrangement(made, pattern, project); }

  pattern::Pattern pattern;
  project::Project project;
  arrange::Arrangement made;
};

TEST(TakenArrangement, ReplacesTheHoldsOfTheOneBefore) {
  OnePiece one;
  one.arrange();
  one.made.attachments[0].edges = {1};
  one.arrange();
  ASSERT_EQ(one.ids(), std::vector<std::string>{"hold_front"});
  EXPECT_EQ(one.project.attachments[0].edges, std::vector<std::string>{"e1"});
  one.made.attachments.clear();
  one.arrange();
  EXPECT_TRUE(one.ids().empty()) << "a top needs none";
}

TEST(TakenArrangement, KeepsWhatAPersonHoldsWhateverItsName) {
  OnePiece one;
  one.project.attachments = {{"hold_hem", "front", {"e1"}, "height", 1, {}, {}},
                             {"hold_front_hem", "front", {"e1"}, "height", 1, {}, {}},
                             {"hold_front", "front", {"e1"}, "place", 1, {}, {}},
                             {"hold_front_7", "front", {"e1"}, "height", -1, {}, {}}};
  const std::vector<project::ProjectAttachment> own = one.project.attachments;
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    one.arrange();
    ASSERT_EQ(one.project.attachments.size(), own.size() + 1);
    for (std::size_t k = 0; k < own.size(); ++k) EXPECT_EQ(one.project.attachments[k], own[k]);
    EXPECT_EQ(one.ids().back(), "hold_front_2") << "its own name is taken";
  }
}

}  // namespace
}  // namespace toile
