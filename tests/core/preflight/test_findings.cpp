#include "core/preflight/finding.h"

#include <gtest/gtest.h>

#include <set>

namespace toile {
namespace {

TEST(Findings, EveryKindHasARowInItsPlaceAndACodeThatReadsBackAsIt) {
  std::set<std::string_view> codes;
  for (std::size_t i = 0; i < preflight::kFindingKindCount; ++i) {
    const auto kind = static_cast<preflight::FindingKind>(i);
    EXPECT_EQ(preflight::traits_of(kind).kind, kind) << "row " << i;
    const Result<preflight::FindingKind> read = preflight::finding_kind_from(preflight::code_of(kind));
    ASSERT_TRUE(read.ok()) << preflight::code_of(kind);
    EXPECT_EQ(*read, kind);
    codes.insert(preflight::code_of(kind));
  }
  EXPECT_EQ(codes.size(), preflight::kFindingKindCount) << "no two kinds have the same code";
}

TEST(Findings, NoKindIsUsuallyGraverThanAtItsGravest) {
  for (const preflight::FindingTraits& row : preflight::finding_table())
    EXPECT_LE(row.usual, row.gravest) << row.code;
}

TEST(Findings, OnlyWhatLiesInThePlacementIsEverRepaired) {
  for (const preflight::FindingTraits& row : preflight::finding_table()) {
    EXPECT_TRUE(!row.repairable || row.cause == preflight::Cause::kPlacement) << row.code;
  }
}

TEST(Findings, UnknownCodesAreRefusedAndQuotedAsThePlace) {
  for (const char* code : {"", "start", "start.", "start.crosses", "Start.gap", "seam.length"}) {
    const Result<preflight::FindingKind> read = preflight::finding_kind_from(code);
    ASSERT_FALSE(read.ok()) << code;
    EXPECT_EQ(read.error().code, "preflight.unknown_code");
    EXPECT_EQ(read.error().where, code);
  }
}

TEST(Findings, ThePlaceInWordsNamesPairsWithAndListsWithCommasAndLeavesBodiesToTheMessage) {
  const preflight::Concern a = preflight::piece_named("a"), b = preflight::piece_named("b");
  EXPECT_EQ(preflight::where_text(preflight::found(preflight::FindingKind::kTouches, "", {a, b}, {})),
            "piece a and piece b");
  EXPECT_EQ(preflight::where_text(preflight::found(preflight::FindingKind::kTightRing, "", {a, b}, {})),
            "piece a, piece b");
  EXPECT_EQ(preflight::where_text(preflight::found(preflight::FindingKind::kShortEdge, "",
                                                   {a, preflight::edge_named("e3")}, {})),
            "piece a, edge e3");
  EXPECT_EQ(
      preflight::where_text(preflight::found(preflight::FindingKind::kThreadThroughBody, "",
                                             {preflight::seam_named("s"), preflight::body_named("m")}, {})),
      "seam s");
}

TEST(Findings, TheFirstErrorCarriesItsCodeItsIdsAndItsPlace) {
  preflight::Findings findings{
      preflight::found(preflight::FindingKind::kFar, "far", {preflight::piece_named("a")}, {}),
      preflight::found(preflight::FindingKind::kCrossesCloth, "meet",
                       {preflight::piece_named("a"), preflight::piece_named("b")}, {1, 2, 3})};
  preflight::sort_by_severity(findings);
  const auto error = preflight::first_error(findings);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, "start.crosses_cloth");
  EXPECT_EQ(error->where, "piece a and piece b at (1.000, 2.000, 3.000) m");
  EXPECT_FALSE(preflight::first_error({preflight::found(preflight::FindingKind::kFar, "", {}, {})}));
}

}  // namespace
}  // namespace toile
