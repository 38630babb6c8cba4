#include "core/base/names.h"

#include <gtest/gtest.h>

#include <vector>

namespace toile {
namespace {

const std::vector<std::string> kNames{"pieces", "fabrics", "seams"};

TEST(Names, FindsTheNameThatASlipOfThePenMeant) {
  EXPECT_EQ(nearest_name("peices", kNames), "pieces");
  EXPECT_EQ(nearest_name("seam", kNames), "seams");
  EXPECT_EQ(nearest_name("saems", kNames), "seams");
}

TEST(Names, OffersNothingForANameThatIsNearToNone) {
  EXPECT_EQ(nearest_name("colour", kNames), "");
  EXPECT_EQ(nearest_name("", std::vector<std::string>{}), "");
}

TEST(Names, AdviceListsWhatIsThere) {
  EXPECT_EQ(advice("colour", kNames), "there are \"pieces\", \"fabrics\", \"seams\"");
  EXPECT_EQ(advice("x", std::vector<std::string>{}), "there are none");
}

TEST(Names, AdviceEndsAfterADozenNames) {
  const std::vector<std::string> many(1000, "a name of some length");
  EXPECT_LT(advice("x", many).size(), 400u);
  EXPECT_NE(advice("x", many).find("and 988 more"), std::string::npos);
}

TEST(Names, QuotesNeitherFloodNorSteerATerminal) {
  EXPECT_EQ(in_quotes("a\x1b[2Jb\n"), "\"a?[2Jb?\"");
  EXPECT_LT(in_quotes(std::string(1000000, 'x')).size(), 70u);
}

}  // namespace
}  // namespace toile
