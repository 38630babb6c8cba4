#pragma once

#include <string>

#include "server/store/store.h"

namespace toile::jobs {

/// How a drape is to be had.
struct JobWish {
  store::JobPriority priority =
      store::JobPriority::kBatch;  ///< of who does not say: whoever looks on says so
  bool pictures = true;            ///< are drawn of its end, which takes longer than a small drape
  bool anew = false;    ///< draped although the results of an equal one would do: somebody wants to look on
  store::Tags tags;     ///< that it gets as it is made
  std::string from;     ///< id of a job from whose end to go on (core/warm); empty: from the pieces
  JobWish() = default;  // NOLINTNEXTLINE(google-explicit-constructor): most say no more than that
  JobWish(store::JobPriority given) : priority(given) {}
};

}  // namespace toile::jobs
