#include "core/pattern/dxf/groups.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {
namespace {

constexpr std::size_t kLongestLine = 4096;  // the format allows 2049 characters
constexpr std::size_t kBuffer = std::size_t{64} << 10;
constexpr std::size_t kShown = 1024;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}  // namespace

std::string line_text(int line) { return "line " + std::to_string(line); }

DxfGroupReader::DxfGroupReader(std::istream& in, std::size_t max_bytes)
    : in_(in), buffer_(kBuffer), max_bytes_(max_bytes) {
  fill();
  constexpr std::string_view kMark = "\xEF\xBB\xBF";  // byte order mark
  if (std::string_view(buffer_.data(), end_).starts_with(kMark)) at_ = kMark.size();
  shown_ = std::min(kShown, end_ - at_);
}

void DxfGroupReader::fail(Fault fault, Error error) {
  fault_ = fault;
  error_ = std::move(error);
}

bool DxfGroupReader::fill() {
  if (error_) return false;
  in_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  at_ = 0;
  end_ = static_cast<std::size_t>(in_.gcount());
  bytes_ += end_;
  if (bytes_ > max_bytes_) {
    fail(Fault::kTooLong,
         {"dxf.too_large", "The file has more than " + std::to_string(max_bytes_) + " bytes, the limit.", "",
          ErrorKind::kTooLarge});
    end_ = 0;
  }
  return end_ > 0;
}

int DxfGroupReader::peek() {
  if (at_ == end_ && !fill()) return -1;
  return static_cast<unsigned char>(buffer_[at_]);
}

bool DxfGroupReader::next_line(std::string& line) {
  line.clear();
  if (peek() < 0) return false;
  ++line_;
  ended_ = false;
  for (int c = peek(); c >= 0; c = peek()) {
    ++at_;
    if (c == '\r' && peek() == '\n') ++at_;
    if (c == '\r' || c == '\n') {
      ended_ = true;
      break;
    }
    line += static_cast<char>(c);
    if (line.size() > kLongestLine) {
      fail(Fault::kNoGroup, {"dxf.bad_group_code", "The line is too long for a DXF file.", line_text(line_)});
      return false;
    }
  }
  return !error_;
}

bool DxfGroupReader::only_blanks_left() {
  for (int c = peek(); c >= 0; c = peek(), ++at_)
    if (c != '\n' && c != 0x1A && !is_blank(static_cast<char>(c))) return false;  // 1A ends DOS texts
  return true;
}

std::optional<DxfGroup> DxfGroupReader::next() {
  if (error_ || !next_line(code_)) return std::nullopt;
  const std::string_view code = trimmed(code_);
  const std::optional<int> number = number_in<int>(code);
  if (!number) {
    // A last line without a value is where a cut file ends; blank lines at the end are harmless.
    if ((code.empty() || code == "\x1A") && only_blanks_left()) return std::nullopt;
    fail(Fault::kNoGroup,
         {"dxf.bad_group_code",
          "A group code is expected here, a whole number, and not '" + clean_text(code.substr(0, 40)) + "'.",
          line_text(line_)});
    return std::nullopt;
  }
  if (next_line(value_)) return DxfGroup{*number, trimmed(value_), line_};
  if (!error_)
    fail(Fault::kCutOff, {"dxf.truncated",
                          "The file ends after group code " + std::to_string(*number) +
                              ", without its value: it is cut off. Get a whole copy.",
                          "last good " + line_text(line_ - 1)});
  return std::nullopt;
}

std::optional<double> number_of(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  std::string with_point;
  if (const std::size_t comma = text.find(',');
      comma != std::string_view::npos && text.find_first_of(".,", comma + 1) == std::string_view::npos &&
      text.find('.') == std::string_view::npos) {
    with_point = text;
    with_point[comma] = '.';
    text = with_point;
  }
  const std::optional<double> value = number_in<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace toile::dxf
