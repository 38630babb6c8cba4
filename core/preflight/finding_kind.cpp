#include "core/preflight/finding_kind.h"

#include <algorithm>
#include <string>

namespace toile::preflight {
namespace {

constexpr Severity kNote = Severity::kNote, kWarning = Severity::kWarning, kError = Severity::kError;
constexpr Cause kPlacement = Cause::kPlacement, kPattern = Cause::kPattern;
using enum FindingKind;

// code, as told usually, at the gravest, cause, repair tried. A tight ring counts as the pattern's although
// it is measured where it stands: another place on the same limb seldom helps, a longer edge always does.
constexpr std::array<FindingTraits, kFindingKindCount> kTable{{
    {kCrossesBody, "start.crosses_body", kError, kError, kPlacement, true},
    {kInsideBody, "start.inside_body", kError, kError, kPlacement, true},
    {kCrossesCloth, "start.crosses_cloth", kError, kError, kPlacement, true},
    {kTouches, "start.touches", kError, kError, kPlacement, true},
    {kGap, "start.gap", kWarning, kWarning, kPlacement, true},
    {kTurned, "piece.turned", kWarning, kWarning, kPlacement, true},
    {kInsideOut, "piece.inside_out", kWarning, kWarning, kPlacement, false},
    {kWindsOtherWay, "piece.winds_other_way", kNote, kNote, kPattern, false},
    {kScale, "piece.scale", kWarning, kWarning, kPattern, false},
    {kFar, "piece.far", kWarning, kWarning, kPlacement, false},
    {kLayerInside, "layer.inside", kWarning, kWarning, kPlacement, false},
    {kShortEdge, "edge.short", kWarning, kWarning, kPattern, false},
    {kTwisted, "seam.twisted", kWarning, kWarning, kPlacement, true},
    {kLengthRatio, "seam.length_ratio", kError, kError, kPattern, false},
    {kLengthDifference, "seam.length_difference", kNote, kWarning, kPattern, false},
    {kOneSided, "seam.one_sided", kWarning, kWarning, kPattern, false},
    {kThreadNearLimb, "seam.thread_near_limb", kNote, kNote, kPlacement, false},
    {kThreadThroughBody, "seam.thread_through_body", kNote, kError, kPlacement, false},
    {kThreadThroughCloth, "seam.thread_through_cloth", kNote, kWarning, kPlacement, false},
    {kOnOpenRing, "seam.on_open_ring", kNote, kNote, kPlacement, false},
    {kTightRing, "ring.tight", kNote, kWarning, kPattern, false},
    {kRingAroundNothing, "ring.around_nothing", kNote, kNote, kPlacement, false},
    {kRingOnWrongLimb, "ring.wrong_limb", kWarning, kWarning, kPlacement, false},
    {kLeftOut, "piece.left_out", kWarning, kWarning, kPattern, false},
    {kRingOff, "worn.ring_off", kWarning, kWarning, kPlacement, false},
    {kSlit, "worn.slit", kWarning, kWarning, kPattern, false},
    {kSlipped, "worn.slipped", kWarning, kWarning, kPattern, false},
    {kOffShoulder, "worn.off_shoulder", kWarning, kWarning, kPattern, false},
    {kHeldOn, "worn.held", kWarning, kWarning, kPattern, false},
    {kNeckShut, "worn.neck_shut", kWarning, kWarning, kPlacement, false},
    {kElsewhere, "worn.elsewhere", kWarning, kWarning, kPlacement, false},
    {kOnGround, "worn.on_ground", kWarning, kWarning, kPlacement, false},
    {kUnsewn, "worn.unsewn", kWarning, kWarning, kPattern, false},
    {kBelowFloor, "start.below_floor", kWarning, kWarning, kPlacement, false},
    {kBegunAnew, "start.begun_anew", kNote, kNote, kPlacement, false},
    {kGoesOn, "start.goes_on", kNote, kNote, kPlacement, false},
    {kFromThePieces, "start.from_the_pieces", kNote, kNote, kPlacement, false},
    {kTouched, "live.touched", kNote, kNote, kPlacement, false},
    {kGivenUp, "start.given_up", kWarning, kWarning, kPattern, false},
    {kMethodWithout, "method.without", kWarning, kWarning, kPattern, false},
    {kBodyTurned, "body.turned", kWarning, kWarning, kPattern, false},
    {kBodyStopped, "body.stopped", kWarning, kWarning, kPattern, false},
    {kBodyWaited, "body.waited", kNote, kNote, kPattern, false},
    {kOverLimit, "strain.over_limit", kNote, kNote, kPattern, false},
    {kTooTight, "fit.too_tight", kWarning, kWarning, kPattern, false},
}};

}  // namespace

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kNote:
      break;
  }
  return "note";
}

const std::array<FindingTraits, kFindingKindCount>& finding_table() { return kTable; }

const FindingTraits& traits_of(FindingKind kind) { return kTable.at(static_cast<std::size_t>(kind)); }

std::string_view code_of(FindingKind kind) { return traits_of(kind).code; }

Result<FindingKind> finding_kind_from(std::string_view code) {
  const auto row =
      std::find_if(kTable.begin(), kTable.end(), [&](const FindingTraits& t) { return t.code == code; });
  if (row != kTable.end()) return row->kind;
  return Error{"preflight.unknown_code", "the look at a start finds nothing of this code", std::string(code)};
}

}  // namespace toile::preflight
