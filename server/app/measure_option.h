#pragma once
// Measures of a mannequin as the command line spells them.

#include <algorithm>
#include <string>

#include "core/body/measure/measures.h"

namespace toile::app {

/// "arm_length" as "--arm-length".
inline std::string measure_option(measure::Measure m) {
  std::string text = "--" + std::string(measure::measure_name(m));
  std::replace(text.begin(), text.end(), '_', '-');
  return text;
}

}  // namespace toile::app
