#pragma once
// What the look at a start found: a code for programs, words for people, the place in both.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"

namespace toile {

enum class Severity {
  kNote,     ///< good to know; nothing to do
  kWarning,  ///< the drape begins, but may not be what was meant
  kError,    ///< the drape does not begin
};

/// "note", "warning", "error".
const char* name_of(Severity severity);

struct Finding {
  std::string code;  ///< stable, lower case with dots, e.g. "start.crosses_body"
  Severity severity = Severity::kNote;
  std::string message;    ///< what it is and the way out
  std::string where;      ///< ids: "piece back", "seam side_left", "piece front, edge e3"
  Vec3 place;             ///< m, at the start as it was placed
  bool repaired = false;  ///< the start was changed so that it is gone
};

using Findings = std::vector<Finding>;

/// "at (0.100, 1.250, -0.030) m"
std::string place_text(Vec3 p);

/// "12.5 mm", "120 mm", "1.25 m": a length (m) in words.
std::string length_text(double metres);

/// Errors first, then warnings, then notes; each in the order found.
void sort_by_severity(Findings& findings);

/// The first error with its place, if there is one: why a drape cannot begin.
std::optional<Error> first_error(const Findings& findings);

}  // namespace toile
