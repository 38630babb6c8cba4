#pragma once
// A pattern as a file to take home: for cutting tables and other programs, for plotters, for printers.

#include <string>

#include "core/base/result.h"
#include "core/pattern/pattern.h"
#include "core/print/paper.h"

namespace toile::documents {

enum class PatternFormat { kDxf, kSvg, kPdf };

/// True to size, in millimetres. `name` stands on the sheet of SVG and PDF ("Pattern" where it is empty),
/// `paper` is that of the PDF's pages. Equal input gives equal bytes. Errors: print.*, those of write_dxf.
Result<std::string> pattern_file(const pattern::Pattern& pattern, const std::string& name,
                                 PatternFormat format, const print::Paper& paper);

}  // namespace toile::documents
