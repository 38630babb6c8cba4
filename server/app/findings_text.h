#pragma once
// What the look at a start found, for people and for programs.

#include "core/preflight/finding.h"
#include "proto/cpp/json_codec.h"

namespace toile {

JsonValue finding_json(const Finding& finding);

/// One line each; a word where there is none.
void print_findings(const Findings& findings);

}  // namespace toile
