#pragma once

#include <utility>

#include "core/drape/drape_input.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile::test {

/// The pattern for the mannequin, all its pieces in one place at her feet.
inline drape::DrapeInput heap_of(pattern::Pattern pattern) {
  drape::DrapeInput input;
  input.pattern = std::move(pattern);
  input.fabrics.resize(1);
  input.fabric_of_panel.assign(input.pattern.panels.size(), 0);
  input.placements.assign(input.pattern.panels.size(), sewing::RigidPlacement{});
  input.bodies = {*person().body};
  input.settings.particle_distance = 0.022;
  return input;
}

}  // namespace toile::test
