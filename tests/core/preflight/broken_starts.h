#pragma once
// Starts that are broken on purpose, each in one way.

#include <functional>
#include <string>
#include <vector>

#include "core/drape/drape_input.h"

namespace toile::test {

struct BrokenStart {
  std::string name;
  std::string code;       ///< that must be found
  bool repaired = false;  ///< and whether the start is repaired
  std::function<DrapeInput()> make;
};

const std::vector<BrokenStart>& broken_starts();

}  // namespace toile::test
