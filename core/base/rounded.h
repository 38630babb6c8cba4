#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/check.h"

namespace toile {

/// To so many decimals (0 to 3), as replies and written documents have numbers; never −0.
inline double rounded(double value, int decimals) {
  constexpr std::array kPer{1.0, 10.0, 100.0, 1000.0};
  TOILE_CHECK(decimals >= 0 && decimals < static_cast<int>(kPer.size()));
  const double per = kPer[static_cast<std::size_t>(decimals)];
  return std::round(value * per) / per + 0.0;
}

}  // namespace toile
