#pragma once
// What the look at a start found, for people.

#include "core/preflight/finding.h"
#include "server/documents/findings.h"

namespace toile {

/// One line each; a word where there is none.
void print_findings(const Findings& findings);

}  // namespace toile
