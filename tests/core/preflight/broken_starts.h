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
  preflight::FindingKind kind = preflight::FindingKind::kGap;  ///< that must be found
  bool repaired = false;                                       ///< and whether the start is repaired
  std::function<drape::DrapeInput()> make;
};

const std::vector<BrokenStart>& broken_starts();

}  // namespace toile::test
