#pragma once
// Patterns on paper, at 1:1.

#include <string>

#include "core/base/result.h"
#include "core/pattern/pattern.h"
#include "core/print/paper.h"

namespace toile::print {

/// The whole pattern on one sheet as SVG in millimetres, for plotters and drawing programs. Errors:
/// "print.nothing" (no piece).
Result<std::string> pattern_svg(const pattern::Pattern& pattern, const std::string& title);

/// The pattern as PDF: a first page that shows how the others lie, then those, to be glued along their
/// frames. Each has its name and those of its neighbours. Equal input gives equal bytes. Errors:
/// "print.nothing", "print.too_large" (over 2000 pages), "print.pdf" (libharu's reason).
Result<std::string> pattern_pdf(const pattern::Pattern& pattern, const std::string& title,
                                const Paper& paper);

}  // namespace toile::print
