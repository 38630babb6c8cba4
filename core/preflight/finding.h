#pragma once
// What the look at a start found: a kind for programs, words for people, the place in both.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/preflight/finding_kind.h"

namespace toile::preflight {

/// A thing of the garment or the scene that a finding is about, by its id.
struct Concern {
  enum class Thing : std::uint8_t { kPiece, kEdge, kSeam, kBody };
  Thing thing = Thing::kPiece;
  std::string id;
  friend bool operator==(const Concern&, const Concern&) = default;
};
using Concerns = std::vector<Concern>;

/// "piece", "edge", "seam", "body".
const char* name_of(Concern::Thing thing);

Concern piece_named(const std::string& id);
/// Of the piece before it.
Concern edge_named(const std::string& id);
Concern seam_named(const std::string& id);
Concern body_named(const std::string& id);

struct Finding {
  FindingKind kind = FindingKind::kGap;
  Severity severity = Severity::kNote;
  std::string message;    ///< what it is and the way out
  Concerns about;         ///< what has to be seen to first; bodies last
  Vec3 place;             ///< m, at the start as it was placed; of what the end shows, there
  bool repaired = false;  ///< the start was changed so that it is gone
};

using Findings = std::vector<Finding>;

/// A finding as grave as its kind usually is.
Finding found(FindingKind kind, std::string message, Concerns about, Vec3 place);

/// The ids in words: "piece back", "seam side_left", "piece front, edge e3", "piece a and piece b" where two
/// pieces get in each other's way. Bodies stand in the message.
std::string where_text(const Finding& finding);

/// "at (0.100, 1.250, -0.030) m"
std::string place_text(Vec3 p);

/// "12.5 mm", "120 mm", "1.25 m": a length (m) in words.
std::string length_text(double metres);

/// Errors first, then warnings, then notes; each in the order found.
void sort_by_severity(Findings& findings);

/// The first error with its place, if there is one: why a drape cannot begin.
std::optional<Error> first_error(const Findings& findings);

}  // namespace toile::preflight
