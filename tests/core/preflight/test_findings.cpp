#include "core/preflight/finding.h"

#include <gtest/gtest.h>

#include <set>

namespace toile {
namespace {

TEST(Findings, EveryKindHasARowInItsPlaceAndACodeThatReadsBackAsIt) {
  std::set<std::string_view> codes;
  for (std::size_t i = 0; i < kFindingKindCount; ++i) {
    const auto kind = static_cast<FindingKind>(i);
    EXPECT_EQ(traits_of(kind).kind, kind) << "row " << i;
    const Result<FindingKind> read = finding_kind_from(code_of(kind));
    ASSERT_TRUE(read.ok()) << code_of(kind);
    EXPECT_EQ(*read, kind);
    codes.insert(code_of(kind));
  }
  EXPECT_EQ(codes.size(), kFindingKindCount) << "no two kinds have the same code";
}

TEST(Findings, NoKindIsUsuallyGraverThanAtItsGravest) {
  for (const FindingTraits& row : finding_table()) EXPECT_LE(row.usual, row.gravest) << row.code;
}

TEST(Findings, OnlyWhatLiesInThePlacementIsEverRepaired) {
  for (const FindingTraits& row : finding_table()) {
    EXPECT_TRUE(!row.repairable || row.cause == Cause::kPlacement) << row.code;
  }
}

TEST(Findings, UnknownCodesAreRefusedAndQuotedAsThePlace) {
  for (const char* code : {"", "start", "start.", "start.crosses", "Start.gap", "seam.length"}) {
    const Result<FindingKind> read = finding_kind_from(code);
    ASSERT_FALSE(read.ok()) << code;
    EXPECT_EQ(read.error().code, "preflight.unknown_code");
    EXPECT_EQ(read.error().where, code);
  }
}

TEST(Findings, ThePlaceInWordsNamesPairsWithAndListsWithCommasAndLeavesBodiesToTheMessage) {
  const Concern a = piece_named("a"), b = piece_named("b");
  EXPECT_EQ(where_text(found(FindingKind::kTouches, "", {a, b}, {})), "piece a and piece b");
  EXPECT_EQ(where_text(found(FindingKind::kTightRing, "", {a, b}, {})), "piece a, piece b");
  EXPECT_EQ(where_text(found(FindingKind::kShortEdge, "", {a, edge_named("e3")}, {})), "piece a, edge e3");
  EXPECT_EQ(where_text(found(FindingKind::kThreadThroughBody, "", {seam_named("s"), body_named("m")}, {})),
            "seam s");
}

TEST(Findings, TheFirstErrorCarriesItsCodeItsIdsAndItsPlace) {
  Findings findings{
      found(FindingKind::kFar, "far", {piece_named("a")}, {}),
      found(FindingKind::kCrossesCloth, "meet", {piece_named("a"), piece_named("b")}, {1, 2, 3})};
  sort_by_severity(findings);
  const auto error = first_error(findings);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, "start.crosses_cloth");
  EXPECT_EQ(error->where, "piece a and piece b at (1.000, 2.000, 3.000) m");
  EXPECT_FALSE(first_error({found(FindingKind::kFar, "", {}, {})}));
}

}  // namespace
}  // namespace toile
