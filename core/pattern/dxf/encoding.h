#pragma once
// How a DXF file writes letters beyond ASCII.

#include <cstddef>
#include <string>
#include <string_view>

namespace toile::dxf {

/// How bytes beyond ASCII are to be read where they are not UTF-8.
struct DxfEncoding {
  /// As iconv names it; null where none is told: then all pairs of high bytes are Chinese (GB 2312), but for
  /// a pair amid small letters, and others Windows 1252.
  const char* code_page = nullptr;
};

/// What a value of $DWGCODEPAGE declares. ANSI_1252 says nothing: many programs declare it whatever they
/// write.
DxfEncoding encoding_of(std::string_view code_page);

/// The text as UTF-8. Bytes that the code page has no letter for are left out.
std::string utf8_of(std::string_view text, DxfEncoding encoding);

/// Length in bytes of the well-formed UTF-8 sequence at the start of s, 0 if it is none.
std::size_t utf8_length(std::string_view s);

}  // namespace toile::dxf
