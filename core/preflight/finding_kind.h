#pragma once
// Everything that the look at a start can find, in one table: its code, how grave it may be, where its cause
// lies, whether a repair is tried. Whoever judges findings asks these; codes are for programs outside.

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/result.h"

namespace toile::preflight {

enum class Severity {
  kNote,     ///< good to know; nothing to do
  kWarning,  ///< the drape begins, but may not be what was meant
  kError,    ///< the drape does not begin
};

/// "note", "warning", "error".
const char* name_of(Severity severity);

enum class FindingKind : std::uint8_t {
  kCrossesBody,
  kInsideBody,
  kCrossesCloth,
  kTouches,
  kGap,
  kTurned,
  kInsideOut,
  kWindsOtherWay,
  kScale,
  kFar,
  kLayerInside,
  kShortEdge,
  kTwisted,
  kLengthRatio,
  kLengthDifference,
  kOneSided,
  kThreadNearLimb,
  kThreadThroughBody,
  kThreadThroughCloth,
  kOnOpenRing,
  kTightRing,
  kRingAroundNothing,
  kRingOnWrongLimb,
  kLeftOut,
  kRingOff,
  kSlit,
  kSlipped,
  kOffShoulder,
  kHeldOn,
  kNeckShut,
  kElsewhere,
  kOnGround,
  kUnsewn,
  kBelowFloor,
  kBegunAnew,
  kGoesOn,
  kFromThePieces,
  kTouched,
  kGivenUp,
  kMethodWithout,
  kBodyTurned,
  kBodyStopped,
  kBodyWaited,
  kOverLimit,
  kTooTight,
};
inline constexpr std::size_t kFindingKindCount = static_cast<std::size_t>(FindingKind::kTooTight) + 1;

/// What would have to change for a finding to go.
enum class Cause : std::uint8_t {
  kPlacement,  ///< where the pieces stand
  kPattern,    ///< the pieces, their edges or seams: it is there wherever they stand
};

struct FindingTraits {
  FindingKind kind;
  std::string_view code;  ///< stable, lower case with dots, e.g. "start.crosses_body"
  Severity usual;         ///< as it is told when nothing else is said
  Severity gravest;       ///< as it may be told
  Cause cause;
  bool repairable;  ///< run_preflight tries to make it go
};

/// One row for each kind, in the order of the enumerators.
const std::array<FindingTraits, kFindingKindCount>& finding_table();
const FindingTraits& traits_of(FindingKind kind);

/// "start.crosses_body", as reports and the service have it.
std::string_view code_of(FindingKind kind);
/// Error: preflight.unknown_code, with the code as its place.
Result<FindingKind> finding_kind_from(std::string_view code);

}  // namespace toile::preflight
