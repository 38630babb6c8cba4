#pragma once
// Why a drape ended, as a value: what happened, and to which seam or button. Its words are made and read here
// and nowhere else; reports, checkpoints and the command line carry them, the program itself asks `kind`.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile::drape {

enum class Stop : std::uint8_t {
  kSettled,     ///< the cloth is at rest, everything is shut
  kTime,        ///< DrapeSettings::max_time is over and it still moves
  kCancelled,   ///< whoever ran it wanted no more
  kNotFinite,   ///< a position is no number any more
  kOpenSeam,    ///< the cloth is at rest, but a seam is not shut
  kOpenButton,  ///< the cloth is at rest, but a button's thread is longer than it should be
};
inline constexpr std::array kStops{Stop::kSettled,   Stop::kTime,     Stop::kCancelled,
                                   Stop::kNotFinite, Stop::kOpenSeam, Stop::kOpenButton};

/// Whether a stop is one of a certain seam or button, which StopReason::name then gives.
bool has_name(Stop kind);

struct StopReason {
  Stop kind = Stop::kCancelled;
  std::string name;  ///< id of the seam or button; empty when none is at fault
  double gap = 0;    ///< m, how far that is open
};

/// "settled", "time", "cancelled", "not finite", "open seam NAME", "open button NAME":
/// as report.json has it.
std::string to_string(const StopReason& reason);

/// The reason with these words; the gap is not among them and stays 0. Error: drape.unknown_stop, with the
/// words as its place.
Result<StopReason> stop_reason_from(std::string_view words);

}  // namespace toile::drape
