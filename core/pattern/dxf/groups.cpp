#include "core/pattern/dxf/groups.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/pattern/dxf/group_codes.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {
namespace {

constexpr std::size_t kLongestLine = 4096;  // the format allows 2049 characters
constexpr int kEnough = 3;                  // groups in a row that fit: there the file is sound again
constexpr std::size_t kFarthest = 400;      // lines that are passed over to get there

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::string quoted(std::string_view text) { return "'" + clean_text(text.substr(0, 40)) + "'"; }

}  // namespace

std::string line_text(int line) { return "line " + std::to_string(line); }

DxfGroupReader::DxfGroupReader(std::istream& in, std::size_t max_bytes)
    : bytes_(in, max_bytes), binary_(binary_width(bytes_.beginning())) {
  if (binary_) pass_sentinel(bytes_);
  if (bytes_.too_long()) fail(Fault::kTooLong, {});
}

void DxfGroupReader::fail(Fault fault, Error error) {
  if (bytes_.too_long()) {
    fault = Fault::kTooLong;
    error = {"dxf.too_large",
             "The file has more than " + std::to_string(bytes_.most()) + " bytes, the limit.", "",
             ErrorKind::kTooLarge};
  }
  fault_ = fault;
  error_ = std::move(error);
}

bool DxfGroupReader::read_line(std::string& line, bool& ended) {
  if (error_ || bytes_.peek() < 0) return false;
  ended = false;
  for (int c = bytes_.take(); c >= 0; c = bytes_.take()) {
    if (c == '\r' && bytes_.peek() == '\n') bytes_.take();
    ended = c == '\r' || c == '\n';
    if (ended) break;
    line += static_cast<char>(c);
    if (line.size() > kLongestLine) {
      const int number = line_ + static_cast<int>(ahead_.size()) + 1;
      fail(Fault::kNoGroup,
           {"dxf.bad_group_code", "The line is too long for a DXF file.", line_text(number)});
      return false;
    }
  }
  return !bytes_.too_long();
}

bool DxfGroupReader::next_line(std::string& line) {
  line.clear();
  if (!ahead_.empty()) {
    line = std::move(ahead_.front().text);
    ended_ = ahead_.front().ended;
    ahead_.pop_front();
  } else if (!read_line(line, ended_)) {
    if (bytes_.too_long()) fail(Fault::kTooLong, {});
    return false;
  }
  ++line_;
  return true;
}

bool DxfGroupReader::has_ahead(std::size_t i) {
  while (ahead_.size() <= i) {
    Line line;
    if (!read_line(line.text, line.ended)) return false;
    ahead_.push_back(std::move(line));
  }
  return true;
}

std::string_view DxfGroupReader::ahead(std::size_t i) {
  return has_ahead(i) ? trimmed(ahead_[i].text) : std::string_view();
}

bool DxfGroupReader::only_blanks_left() {
  const auto blank = [](int c) { return c == '\n' || c == 0x1A || is_blank(static_cast<char>(c)); };
  for (const Line& line : ahead_)  // 1A ends DOS texts
    if (!std::all_of(line.text.begin(), line.text.end(), blank)) return false;
  for (int c = bytes_.peek(); c >= 0; c = bytes_.peek()) {
    if (!blank(c)) return false;
    bytes_.take();
  }
  if (bytes_.too_long()) fail(Fault::kTooLong, {});
  return true;
}

std::optional<DxfGroup> DxfGroupReader::next() { return binary_ ? next_binary() : next_text(); }

std::optional<DxfGroup> DxfGroupReader::next_binary() {
  if (error_) return std::nullopt;
  DxfBinaryGroup group = next_binary_group(bytes_, *binary_);
  using End = DxfBinaryGroup::End;
  if (bytes_.too_long()) fail(Fault::kTooLong, {});
  if (group.end == End::kWithin)
    fail(Fault::kCutOff,
         {"dxf.truncated", "The binary file ends within a group: it is cut off. Get a whole copy.",
          "last good " + line_text(line_)});
  if (group.end == End::kNoCode)
    fail(Fault::kNoGroup,
         {"dxf.bad_group_code",
          "The binary file cannot be taken apart behind its group code " + std::to_string(group.code) + ".",
          "last good " + line_text(line_)});
  if (group.end != End::kNone || error_) return std::nullopt;
  line_ += 2;
  value_ = std::move(group.value);
  return DxfGroup{group.code, trimmed(value_), line_};
}

std::optional<DxfGroup> DxfGroupReader::with_value(int code) {
  if (!next_line(value_)) {
    if (!error_)
      fail(Fault::kCutOff, {"dxf.truncated",
                            "The file ends after group code " + std::to_string(code) +
                                ", without its value: it is cut off. Get a whole copy.",
                            "last good " + line_text(line_ - 1)});
    return std::nullopt;
  }
  const std::string_view value = trimmed(value_);
  last_code_ = code;
  begins_section_ = code == 0 && value == "SECTION";
  return DxfGroup{code, value, line_};
}

std::optional<DxfGroup> DxfGroupReader::next_text() {
  while (!error_ && next_line(code_)) {
    const std::string_view code = trimmed(code_);
    if (const std::optional<int> number = number_in<int>(code)) return with_value(*number);
    // A last line without a value is where a cut file ends; blank lines at the end are harmless.
    if ((code.empty() || code == "\x1A") && only_blanks_left()) return std::nullopt;
    if (std::optional<DxfGroup> group = mended()) return group;
  }
  return std::nullopt;
}

/// Number of groups that stand in a row from a line ahead on, up to kEnough; the end of the file stands for
/// as many.
int DxfGroupReader::groups_ahead(std::size_t first) {
  int groups = 0;
  for (; groups < kEnough; ++groups) {
    const std::size_t at = first + 2 * std::size_t(groups);
    if (!has_ahead(at + 1)) return groups > 0 && !has_ahead(at) ? kEnough : groups;
    const std::optional<int> code = number_in<int>(ahead(at));
    if (!code || !is_plausible(*code, ahead(at + 1))) return groups;
  }
  return groups;
}

/// What the damaged code before this value was, by what stands around it.
std::optional<int> DxfGroupReader::likely_code(std::string_view value) {
  constexpr int kFirstX = 10, kLastX = 18, kToY = 10;
  if (is_record_name(value)) return 0;
  if (begins_section_ && is_section_name(value)) return 2;
  if (!number_of(value)) return std::nullopt;
  const auto is_x = [](int code) { return code >= kFirstX && code <= kLastX; };
  const std::optional<int> after = number_in<int>(ahead(1));
  if (is_x(last_code_) && after != last_code_ + kToY) return last_code_ + kToY;
  if (after && is_x(*after - kToY) && last_code_ != *after - kToY) return *after - kToY;
  return std::nullopt;
}

void DxfGroupReader::pass_lines(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) next_line(value_);
}

/// Behind a line that is no group code: the group that it began, where its value follows. Else nothing, and
/// next_line() gives the next group code, or the error is set.
std::optional<DxfGroup> DxfGroupReader::mended() {
  const std::string said = "a group code is expected here, a whole number, and not " + quoted(trimmed(code_));
  const int line = line_;
  const bool begins = last_code_ >= 0 || ahead(0) == "SECTION" || ahead(2) == "SECTION";
  const bool hopeless = !begins || ++mends_ > kMostMends;
  const bool is_last = is_record_name(ahead(0)) && !has_ahead(1);
  if (!hopeless && (is_last || groups_ahead(1) == kEnough)) {
    const std::optional<int> code = likely_code(ahead(0));
    damages_.push_back({line, said + (code ? ": it is taken for " + std::to_string(*code) : "")});
    return with_value(code.value_or(kLostCode));
  }
  for (std::size_t lines = 0; !hopeless && lines < kFarthest && has_ahead(lines); ++lines) {
    if (lines == 1 || groups_ahead(lines) < kEnough) continue;
    pass_lines(lines);
    damages_.push_back({line, said + ": reading goes on in " + line_text(line_ + 1)});
    return std::nullopt;
  }
  if (!error_)
    fail(Fault::kNoGroup,
         {"dxf.bad_group_code",
          "A group code is expected here, a whole number, and not " + quoted(trimmed(code_)) + ".",
          line_text(line)});
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
