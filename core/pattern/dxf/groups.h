#pragma once
// The lowest layer of DXF: groups, each a code and a value, read as they come.

#include <cstddef>
#include <deque>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf/binary_groups.h"
#include "core/pattern/dxf/byte_source.h"

namespace toile::dxf {

struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< trimmed; valid until the next call of next()
  int line = 0;            ///< of the value, from 1
};

/// The code of a group whose own one cannot be read.
inline constexpr int kLostCode = -1000;

/// A file with more faults than are mended is no DXF file any more.
inline constexpr int kMostMends = 100;

/// A fault of the file that the reader has read past.
struct DxfDamage {
  int line = 0;
  std::string text;
};

/// Takes a DXF file apart, one group at a time, text or binary. Lines of texts may end in LF, CR LF or CR;
/// those of a binary file are counted as its text form would have them. Where a text's line should hold a
/// group code and does not, reading goes on where codes and values fit each other again.
class DxfGroupReader {
 public:
  /// Reads no more than `max_bytes` of the stream, which must outlive the reader.
  DxfGroupReader(std::istream& in, std::size_t max_bytes);

  bool is_binary() const { return binary_.has_value(); }
  /// The first bytes of the file (up to 1 KiB), to be asked before the first group.
  std::string_view beginning() const { return bytes_.beginning(); }

  /// The next group; nothing at the end of the text or at an error.
  std::optional<DxfGroup> next();

  /// Set once next() met what it could not read past: no groups, a line too long, a code without a value, or
  /// the limit.
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
  /// What has been read past since the last call.
  std::vector<DxfDamage> take_damages() { return std::exchange(damages_, {}); }

 private:
  struct Line {
    std::string text;
    bool ended = false;  ///< it has an end of its own
  };

  std::optional<DxfGroup> next_text();
  std::optional<DxfGroup> next_binary();
  std::optional<DxfGroup> with_value(int code);
  bool read_line(std::string& line, bool& ended);
  bool next_line(std::string& line);
  std::string_view ahead(std::size_t i);
  bool has_ahead(std::size_t i);
  int groups_ahead(std::size_t first);
  std::optional<DxfGroup> mended();
  std::optional<int> likely_code(std::string_view value);
  void pass_lines(std::size_t count);
  void fail(Fault fault, Error error);

  DxfByteSource bytes_;
  std::optional<DxfCodeWidth> binary_;
  std::deque<Line> ahead_;  // read, but not taken
  int line_ = 0, last_code_ = -1;
  bool ended_ = true, begins_section_ = false;
  std::string code_, value_;
  std::optional<Error> error_;
  Fault fault_ = Fault::kSound;
  std::vector<DxfDamage> damages_;
  int mends_ = 0;
};

/// The number, or nothing when `text` is not wholly one finite number. A comma may stand for the point.
std::optional<double> number_of(std::string_view text);

/// "line 12", as `where` names it.
std::string line_text(int line);

}  // namespace toile::dxf
