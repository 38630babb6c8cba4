#pragma once
// What the look at a start found, for people.

#include "core/preflight/finding.h"
#include "server/documents/findings.h"

namespace toile::app {

/// One line each; a word where there is none.
void print_findings(const preflight::Findings& findings);

}  // namespace toile::app
