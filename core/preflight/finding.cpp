#include "core/preflight/finding.h"

#include <algorithm>
#include <cstdio>

namespace toile {

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

std::string place_text(Vec3 p) {
  char text[128];
  std::snprintf(text, sizeof text, "at (%.3f, %.3f, %.3f) m", p.x, p.y, p.z);
  return text;
}

std::string length_text(double metres) {
  char text[64];
  if (metres >= 1) {
    std::snprintf(text, sizeof text, "%.2f m", metres);
  } else {
    std::snprintf(text, sizeof text, metres < 0.1 ? "%.1f mm" : "%.0f mm", 1e3 * metres);
  }
  return text;
}

void sort_by_severity(Findings& findings) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
}

std::optional<Error> first_error(const Findings& findings) {
  for (const Finding& f : findings) {
    if (f.severity == Severity::kError) return Error{f.code, f.message, f.where + " " + place_text(f.place)};
  }
  return std::nullopt;
}

}  // namespace toile
