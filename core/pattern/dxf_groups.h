#pragma once
// The lowest layer of DXF: pairs of lines, a group code and a value.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile {

struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< trimmed; a view into the reader's text
  int line = 0;            ///< of the value, from 1
};

/// Takes a DXF text apart, one group at a time. Lines may end in LF, CR LF or CR.
class DxfGroupReader {
 public:
  /// The text must outlive the reader.
  explicit DxfGroupReader(std::string_view text) : text_(text) {}

  /// The next group; nothing at the end of the text or at an error.
  std::optional<DxfGroup> next();

  /// Set once next() met a code that is no number, a line too long, or a code without a value.
  const std::optional<Error>& error() const { return error_; }
  int line() const { return line_; }  ///< last line read

 private:
  std::optional<std::string_view> next_line();

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 0;
  std::optional<Error> error_;
};

/// The number, or nothing when `text` is not wholly one finite number.
std::optional<double> number_of(std::string_view text);

/// The text as valid UTF-8 without control characters, at most 120 characters long: older files hold Windows
/// Latin 1, newer ones escapes such as \U+00E9.
std::string clean_text(std::string_view text);

/// "line 12", as `where` names it.
std::string line_text(int line);

}  // namespace toile
