#pragma once
// How a run of a job ends.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "server/store/store.h"

namespace toile::jobs {

/// What the job's row is to say. The results are in the store by then.
struct RunEnd {
  bool succeeded = false;
  std::string code, reason, where;
  std::vector<store::JobNote> notes;  ///< what it fell short of although it ended well
  bool touched = false;               ///< hands were on the cloth: its input does not tell how it hangs
  std::string report;                 ///< report.json's text; empty when nothing was draped
  store::ResultFiles results;
};

/// Says what an end falls short of: a note for programs, and the same at the end of the reason.
void fall_short(RunEnd& end, const std::string& code, const std::string& message);

/// What a drape's end means for its job, in words that say what to do next. A drape that ran out of time
/// succeeded with code "time", and one that came to rest with an open seam with "open_seam" and the seam as
/// its place: there is cloth to look at. drape.open_button (with the button as its place), drape.not_finite
/// and drape.stopped are failures. Report and results stay empty.
RunEnd verdict_on(const drape::DrapeInput& input, const drape::DrapeResult& result);

}  // namespace toile::jobs
