#pragma once
// gzip, for answers that are text and for clients that take it.

#include <string>
#include <string_view>

namespace toile::http {

/// Whether an Accept-Encoding allows gzip: named with a weight above 0, or under "*".
bool takes_gzip(std::string_view accept_encoding);

/// The bytes as a gzip file; empty where there is no memory for it.
std::string gzipped(std::string_view bytes);

}  // namespace toile::http
