#pragma once
// Part codes of trade files: a style's number and two to four letters, "4417-FP", "K6114-FFC".

#include <string>

namespace toile::seams {

/// The name with its code spelled out, where that stands behind a style's number and no word besides:
/// "4417-FP_mirrored" is "front panel mirrored". All others stay.
std::string with_code_spelled_out(std::string name);

}  // namespace toile::seams
