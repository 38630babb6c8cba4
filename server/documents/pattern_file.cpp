#include "server/documents/pattern_file.h"

#include "core/pattern/dxf/write.h"
#include "core/print/print.h"

namespace toile::documents {

Result<std::string> pattern_file(const pattern::Pattern& pattern, const std::string& name,
                                 PatternFormat format, const print::Paper& paper) {
  const std::string title = name.empty() ? "Pattern" : name;
  switch (format) {
    case PatternFormat::kDxf:
      return dxf::write_dxf(pattern);
    case PatternFormat::kSvg:
      return print::pattern_svg(pattern, title);
    case PatternFormat::kPdf:
      return print::pattern_pdf(pattern, title, paper);
  }
  return Error{"print.format", "there is no such format", ""};
}

}  // namespace toile::documents
