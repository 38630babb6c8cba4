#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Text as HTML, XML and SVG have it, within quotes as well: & < > " are written by name, control characters,
/// which have no place there, become blanks.
std::string in_markup(std::string_view text);

}  // namespace toile
