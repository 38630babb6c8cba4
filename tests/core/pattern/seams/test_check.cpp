// What check_seams says of seams that are hardly meant.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "core/pattern/curve.h"
#include "core/pattern/seams/check.h"
#include "core/pattern/validate.h"

namespace toile {
namespace {

/// A rectangle of edges bottom (0), right (1), top (2), left (3).
pattern::Panel rectangle(const std::string& id, double width, double height) {
  const Vec2 c[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  const char* names[] = {"bottom", "right", "top", "left"};
  pattern::Panel panel;
  panel.id = id;
  for (int i = 0; i < 4; ++i)
    panel.outline.edges.push_back({names[i], {pattern::line_segment(c[i], c[(i + 1) % 4])}});
  return panel;
}

/// Front and back, sewn along both sides; a band ring of one piece; the skirt's top round to the band.
pattern::Pattern skirt() {
  pattern::Pattern p;
  p.panels = {rectangle("front", 300, 400), rectangle("back", 300, 400), rectangle("band", 600, 40)};
  p.seams = {{"side_1", {{0, 1}}, {{1, 3}}, false},
             {"side_2", {{0, 3}}, {{1, 1}}, false},
             {"band_ends", {{2, 1}}, {{2, 3}}, false},
             {"waist", {{0, 2}, {1, 2}}, {{2, 0}}, false}};
  return p;
}

std::vector<seams::SeamIssueKind> kinds(const pattern::Pattern& p) {
  std::vector<seams::SeamIssueKind> found;
  for (const seams::SeamIssue& issue : seams::check_seams(p)) found.push_back(issue.kind);
  return found;
}

using Kinds = std::vector<seams::SeamIssueKind>;

TEST(SeamCheck, HasNothingToSayOfASkirtWithItsBand) {
  // Walking the front's top with the cloth at the left leads to the left side, and there to the back's right.
  EXPECT_EQ(kinds(skirt()), Kinds{});
  EXPECT_TRUE(pattern::validate(skirt()).ok());
}

TEST(SeamCheck, FindsASeriesThatIsNotContinuous) {
  pattern::Pattern p = skirt();
  p.seams[3].a = {{0, 2}, {0, 0}};  // top, then bottom
  const auto issues = seams::check_seams(p);
  ASSERT_FALSE(issues.empty());
  EXPECT_EQ(issues[0].kind, seams::SeamIssueKind::kNotContinuous);
  EXPECT_EQ(issues[0].where, "seam waist, side a, item 1 (piece front, edge bottom)");
  EXPECT_EQ(issues[0].panel, 0);
  EXPECT_EQ(issues[0].at, (Vec2{0, 0})) << "where the second edge starts";
  EXPECT_NE(issues[0].message.find("400.0 mm"), std::string::npos) << issues[0].message;
}

TEST(SeamCheck, FindsASeriesOverTwoPiecesThatNoSeamJoins) {
  pattern::Pattern p = skirt();
  p.seams.erase(p.seams.begin() + 1);  // the side where the front's top goes over to the back's
  const Kinds found = kinds(p);
  EXPECT_NE(std::find(found.begin(), found.end(), seams::SeamIssueKind::kNotContinuous), found.end());
}

TEST(SeamCheck, FindsATwistedSeam) {
  pattern::Pattern p = skirt();
  p.seams[1].same_direction = true;
  const auto issues = seams::check_seams(p);
  ASSERT_FALSE(issues.empty());
  EXPECT_TRUE(std::any_of(issues.begin(), issues.end(), [](const seams::SeamIssue& i) {
    return i.kind == seams::SeamIssueKind::kTwisted && i.where == "seam side_2" && !seams::is_error(i.kind);
  }));
}

TEST(SeamCheck, FindsATwistByTheEndsThatOtherSeamsBringTogether) {
  pattern::Pattern p;
  p.panels = {rectangle("a", 100, 100), rectangle("b", 100, 100)};
  p.panels[0].outline.edges[0].curves = {pattern::line_segment({0, 0}, {50, 0}),
                                         pattern::line_segment({50, 0}, {100, 0})};
  p.seams = {{"long", {{0, 1}}, {{1, 3}}, false}, {"next", {{0, 2}}, {{1, 2}}, false}};
  EXPECT_EQ(kinds(p), Kinds{}) << "the tops go on from the sides";
  p.seams[1].a[0].reversed = p.seams[1].b[0].reversed = true;
  EXPECT_EQ(kinds(p), Kinds{}) << "both the other way is the same seam";
  p.seams[1].b[0].reversed = false;
  EXPECT_EQ(kinds(p), (Kinds{seams::SeamIssueKind::kTwisted}));
}

TEST(SeamCheck, FindsLengthsOfOverOneToThree) {
  pattern::Pattern p;
  p.panels = {rectangle("a", 299, 100), rectangle("b", 100, 50), rectangle("c", 301, 100)};
  p.seams = {{"s", {{0, 0}}, {{1, 0}}, false}};
  EXPECT_EQ(kinds(p), Kinds{});
  p.seams = {{"s", {{2, 0}}, {{1, 0}}, false}};
  const auto issues = seams::check_seams(p);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].kind, seams::SeamIssueKind::kLengthRatio);
  EXPECT_NE(issues[0].message.find("301.0 mm are sewn to 100.0 mm"), std::string::npos);
}

TEST(SeamCheck, FindsARingSewnToWhatIsNoRing) {
  pattern::Pattern p = skirt();
  p.seams.erase(p.seams.begin() + 2);  // the band's ends stay open
  const auto issues = seams::check_seams(p);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].kind, seams::SeamIssueKind::kOpenLoop);
  EXPECT_EQ(issues[0].panel, 2) << "the gap is in the band";
}

TEST(SeamCheck, LetsPartsOfAnEdgeBeSewnOnceEach) {
  pattern::Pattern p;
  p.panels = {rectangle("long", 200, 50), rectangle("b", 100, 50), rectangle("c", 100, 50)};
  p.seams = {{"one", {{0, 0, false, 0, 0.5}}, {{1, 2}}, false},
             {"two", {{0, 0, false, 0.5, 1}}, {{2, 2}}, false}};
  EXPECT_EQ(kinds(p), Kinds{});
  EXPECT_TRUE(pattern::validate(p).ok());
  EXPECT_DOUBLE_EQ(seams::series_length(p, p.seams[0].a), 100);
  p.seams[1].a[0].from = 0.4;
  const auto issues = seams::check_seams(p);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].kind, seams::SeamIssueKind::kSewnTwice);
  EXPECT_TRUE(seams::is_error(issues[0].kind));
  EXPECT_NEAR(issues[0].at.x, 80, 1e-9);
  EXPECT_EQ(pattern::validate(p).error().code, "pattern.edge_sewn_twice");
  p.seams[1].a[0].from = 1;
  EXPECT_EQ(kinds(p), (Kinds{seams::SeamIssueKind::kRange}));
  EXPECT_EQ(pattern::validate(p).error().code, "pattern.seam_range");
  p.seams[1].a[0] = {0, 7};
  EXPECT_EQ(kinds(p), (Kinds{seams::SeamIssueKind::kReference}));
}

TEST(SeamCheck, EveryKindHasACodeOfItsOwn) {
  std::set<std::string_view> codes;
  for (std::size_t i = 0; i < seams::kSeamIssueKindCount; ++i)
    codes.insert(seams::code_of(static_cast<seams::SeamIssueKind>(i)));
  EXPECT_EQ(codes.size(), seams::kSeamIssueKindCount);
  EXPECT_EQ(seams::code_of(seams::SeamIssueKind::kReference), "seam.reference");
  EXPECT_EQ(seams::code_of(seams::SeamIssueKind::kOpenLoop), "seam.open_loop");
}

TEST(SeamCheck, EveryIssueNamesTheSeamThatItIsAbout) {
  pattern::Pattern p = skirt();
  p.seams[1].same_direction = true;
  for (const seams::SeamIssue& issue : seams::check_seams(p)) {
    ASSERT_GE(issue.seam, 0);
    EXPECT_EQ(issue.where.rfind("seam " + p.seams[static_cast<std::size_t>(issue.seam)].id, 0), 0u)
        << issue.where;
  }
}

}  // namespace
}  // namespace toile
