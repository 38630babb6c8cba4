#pragma once
// The lowest layer of DXF: pairs of lines, a group code and a value, read as they come.

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace toile::dxf {

struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< trimmed; valid until the next call of next()
  int line = 0;            ///< of the value, from 1
};

/// Takes a DXF text apart, one group at a time, with one buffer of 64 KiB. Lines may end in LF, CR LF or CR.
class DxfGroupReader {
 public:
  /// Reads no more than `max_bytes` of the stream, which must outlive the reader.
  DxfGroupReader(std::istream& in, std::size_t max_bytes);

  /// The first bytes of the text (up to 1 KiB), without taking them.
  std::string_view beginning() const { return std::string_view(buffer_.data() + at_, shown_); }

  /// The next group; nothing at the end of the text or at an error.
  std::optional<DxfGroup> next();

  /// Set once next() met a code that is no number, a line too long, a code without a value, or the limit.
  const std::optional<Error>& error() const { return error_; }
  enum class Fault {
    kSound,
    kCutOff,   ///< the text ends within a group
    kNoGroup,  ///< what stands there is no group of a DXF file
    kTooLong,  ///< more than max_bytes
  };
  Fault fault() const { return fault_; }  ///< what error() is about
  int line() const { return line_; }      ///< last line read
  /// Whether the last line read had an end: without one, some of it may be missing.
  bool ended_a_line() const { return ended_; }
  /// Whether all that follows is blank. Takes it.
  bool only_blanks_left();

 private:
  bool fill();
  int peek();
  bool next_line(std::string& line);

  std::istream& in_;
  std::vector<char> buffer_;
  std::size_t at_ = 0, end_ = 0, shown_ = 0, bytes_ = 0, max_bytes_;
  int line_ = 0;
  bool ended_ = true;
  std::string code_, value_;
  void fail(Fault fault, Error error);

  std::optional<Error> error_;
  Fault fault_ = Fault::kSound;
};

/// The number, or nothing when `text` is not wholly one finite number. A comma may stand for the point.
std::optional<double> number_of(std::string_view text);

/// "line 12", as `where` names it.
std::string line_text(int line);

}  // namespace toile::dxf
