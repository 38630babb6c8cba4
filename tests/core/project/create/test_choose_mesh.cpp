#include "core/project/create/choose_mesh.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

pattern::Panel sheet(const std::string& name, double width, double height) {
  return garments::piece(name, {{0, 0}, {width, 0}, {width, height}, {0, height}});
}

TEST(ChooseMesh, ATopIsMeshedAsByDefaultAndALongDressCoarser) {
  EXPECT_EQ(create::distance_for(0.8e6), 15) << "0.8 m²";
  EXPECT_EQ(create::distance_for(2.4e6), 21.5) << "6000 particles, each on √3/2 d²";
  EXPECT_EQ(create::distance_for(50e6), 25) << "no coarser than folds can bear";
}

TEST(ChooseMesh, TheTimeStepGrowsWithTheEdges) {
  const project::ProjectSettings usual;
  project::ProjectSettings settings;
  create::choose_mesh({{sheet("front", 600, 700), sheet("back", 600, 700)}, {}}, settings);
  EXPECT_EQ(settings, usual);
  create::choose_mesh({{sheet("front", 1000, 1200), sheet("back", 1000, 1200)}, {}}, settings);
  EXPECT_EQ(settings.particle_distance_mm, 21.5);
  EXPECT_NEAR(settings.time_step_s / settings.particle_distance_mm,
              usual.time_step_s / usual.particle_distance_mm, 1e-12);
}

TEST(ChooseMesh, WhatLiesOnOtherClothAndHolesDoNotCount) {
  pattern::Panel front = sheet("front", 1000, 1200);
  pattern::Loop hole;
  for (const pattern::PanelEdge& edge : pattern::reversed(sheet("", 900, 1000).outline).edges)
    hole.edges.push_back(edge);
  front.holes.push_back(hole);
  project::ProjectSettings settings;
  create::choose_mesh({{front, sheet("front lining", 1000, 1200), sheet("pocket", 1000, 1200)}, {}},
                      settings);
  EXPECT_EQ(settings.particle_distance_mm, 15);
}

}  // namespace
}  // namespace toile
