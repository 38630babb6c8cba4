#pragma once
// What the store keeps of a drape under way: its checkpoint, and what was recorded for its film until then.
// In one piece, so that a drape that goes on leaves the film that it would have left at one go.

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile::jobs {

struct KeptDrape {
  std::string motion;      ///< movie::encode_motion
  std::string checkpoint;  ///< drape::DrapeRun::checkpoint
  std::string shape;       ///< JobRun::shape, of one that nobody may go on with for long; else empty
};

std::string encode_kept(const KeptDrape& kept);
/// Error: checkpoint.damaged, kind kSystem.
Result<KeptDrape> decode_kept(std::string_view bytes);

}  // namespace toile::jobs
