#pragma once
// A drape's report as a page to look at, print and send on.

#include <span>
#include <string>

#include "core/json/tree.h"

namespace toile::exports {

/// A picture of the drape on the page.
struct PagePicture {
  std::string title;  ///< "front"
  std::string png;    ///< the file's bytes
};

/// One page of HTML with nothing outside it (no script, pictures within): verdict, pictures, table of fit,
/// findings, figures. `report` as report_json() gives it; what it has not, the page leaves out.
std::string report_page(const json::JsonValue& report, std::span<const PagePicture> pictures);

}  // namespace toile::exports
