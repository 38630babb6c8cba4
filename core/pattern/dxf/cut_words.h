#pragma once
// Words that tell to cut a piece, in a dozen languages.

#include <string_view>

namespace toile::dxf {

/// Whether the word (small Latin letters) is one of these, or four letters and more that one begins with:
/// "tagl", "cort".
bool tells_cutting(std::string_view word);

}  // namespace toile::dxf
