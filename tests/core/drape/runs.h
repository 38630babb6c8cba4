#pragma once
// Drapes, begun and done, and what came of them.

#include <algorithm>
#include <limits>
#include <memory>

#include "core/drape/pipeline.h"
#include "core/preflight/finding.h"

namespace toile {

inline constexpr int kToTheEnd = std::numeric_limits<int>::max();  // steps

inline std::unique_ptr<drape::DrapeRun> begun(const drape::DrapeInput& input) {
  return drape::DrapeRun::start(input, {}, nullptr).value();
}

inline drape::DrapeResult draped(const drape::DrapeInput& input) {
  return drape::drape(input, {}, nullptr).value();
}

inline int crossings_of(const drape::DrapeResult& r) { return r.worst.cloth_body + r.worst.cloth_cloth; }

/// The first finding of the kind; null: there is none.
inline const preflight::Finding* told(const preflight::Findings& findings, preflight::FindingKind kind) {
  const auto at = std::find_if(findings.begin(), findings.end(),
                               [&](const preflight::Finding& f) { return f.kind == kind; });
  return at == findings.end() ? nullptr : &*at;
}

}  // namespace toile
