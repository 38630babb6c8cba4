#include "core/mesh/sewn_part.h"

#include <gtest/gtest.h>

#include "core/mesh/make_panel_meshes.h"
#include "tests/core/arrange/garments.h"

namespace toile {
namespace {

TEST(SewnPart, ATubeHasTwoBordersAndALoosePieceOne) {
  pattern::Pattern pattern = test::skirt();
  pattern.panels.push_back(test::polygon("pocket", {{0, 0}, {100, 0}, {100, 50}, {0, 50}}));
  const auto meshes = mesh::make_panel_meshes(pattern, 0.02, {}).value();
  const std::vector<mesh::SewnPart> parts = mesh::sewn_parts(meshes);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].panels, (std::vector<Index>{0, 1, 2, 3}));
  ASSERT_EQ(parts[0].borders.size(), 2U) << "waist and hem";
  EXPECT_NEAR(parts[0].borders[0], 1.12, 1e-9) << "the longer, hem, first";
  EXPECT_NEAR(parts[0].borders[1], 0.75, 1e-9);
  EXPECT_EQ(parts[0].seams, 6);
  EXPECT_EQ(parts[1].panels, (std::vector<Index>{4}));
  ASSERT_EQ(parts[1].borders.size(), 1U);
  EXPECT_NEAR(parts[1].borders[0], 0.3, 1e-9);
  EXPECT_EQ(parts[1].seams, 0);
  EXPECT_NEAR(parts[1].area, 0.005, 1e-9);
}

}  // namespace
}  // namespace toile
