#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Text as HTML, XML and SVG have it, within quotes as well: & < > " are written by name, control characters,
/// which have no place there, become blanks.
std::string in_markup(std::string_view text);

/// Bytes as text of A to Z, a to z, 0 to 9, + and /, with = at the end (RFC 4648, 4): as data: URLs have
/// them.
std::string base64(std::string_view bytes);

}  // namespace toile
