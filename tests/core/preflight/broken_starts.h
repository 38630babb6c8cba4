#pragma once
// Starts that are broken on purpose, each in one way.

#include <functional>
#include <string>
#include <vector>

#include "core/drape/drape_input.h"
#include "core/preflight/finding.h"

namespace toile::test {

struct BrokenStart {
  std::string name;
  FindingKind kind = FindingKind::kGap;  ///< that must be found
  bool repaired = false;                 ///< and whether the start is repaired
  std::function<DrapeInput()> make;
};

const std::vector<BrokenStart>& broken_starts();

}  // namespace toile::test
