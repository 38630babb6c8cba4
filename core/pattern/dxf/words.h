#pragma once
// What texts of a DXF file say: their characters, and statements such as "Piece Name: FRONT".

#include <optional>
#include <string>
#include <string_view>

#include "core/pattern/dxf/encoding.h"

namespace toile::dxf {

/// The text as valid UTF-8 without control characters, at most 120 characters long; escapes such as \U+00E9
/// and %%D become their characters.
std::string clean_text(std::string_view text, DxfEncoding encoding = {});

/// The words of an MTEXT without its formatting codes.
std::string plain_text(std::string_view mtext);

/// Whether the word is one of a list with a semicolon before and behind each.
bool is_listed(std::string_view list, std::string_view word);

/// Nothing but question marks and blanks: what a program leaves of letters that it cannot write.
bool is_lost(std::string_view text);

/// "Key: value" of a text. The blank behind the colon may be missing.
struct DxfStatement {
  std::string key;  ///< lower case, single blanks
  std::string value;
};
std::optional<DxfStatement> statement_of(const std::string& text);

/// "2" is two pieces, "1,1" one and one mirrored.
struct DxfQuantity {
  int as_drawn = 0, mirrored = 0;
  bool told_apart = false;  ///< two figures stand there
};
std::optional<DxfQuantity> quantity_of(std::string_view value);

}  // namespace toile::dxf
