#include "core/pattern/own_mirror.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

bool is_own_mirror(const std::vector<garments::Node>& corners, double turned = 0) {
  return pattern::is_own_mirror(garments::turned(garments::piece("p", corners), turned).outline);
}

TEST(OwnMirror, BandsAndGoresAreInWhateverDirectionTheyLie) {
  EXPECT_TRUE(is_own_mirror({{0, 0}, {740, 0}, {740, 40}, {0, 40}}));
  EXPECT_TRUE(is_own_mirror({{0, 0}, {300, 0}, {200, 600}, {100, 600}}, 0.7));
  EXPECT_TRUE(is_own_mirror({{0, 0}, {300, 0, Vec2{280, 300}}, {200, 600}, {100, 600, Vec2{20, 300}}}));
}

TEST(OwnMirror, APieceWithASlantedEndOrOneBentEdgeIsNot) {
  EXPECT_FALSE(is_own_mirror({{0, 0}, {740, 0}, {760, 40}, {0, 40}}));
  EXPECT_FALSE(is_own_mirror({{0, 0}, {300, 0, Vec2{280, 300}}, {200, 600}, {100, 600}}));
  EXPECT_FALSE(is_own_mirror({{0, 0}, {740, 0}, {780, 40}, {40, 40}})) << "a parallelogram";
}

}  // namespace
}  // namespace toile
