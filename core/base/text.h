#pragma once
// Texts taken apart and numbers written, alike everywhere. All of it is ASCII and knows no locale: a
// machine's language must not change what a file says.

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

namespace toile {

/// Without the blanks (space, tab, CR, LF, VT, FF) at both ends; a view into `text`.
std::string_view trimmed(std::string_view text);

/// With A to Z in lower case; other bytes, and so UTF-8, stay.
std::string lower_case(std::string_view text);

/// The words of a name in lower case, none empty: parted at whatever is no letter of ASCII, and where a
/// capital follows a small letter ("leftSleeve-2" is "left", "sleeve").
std::vector<std::string> words_of_name(std::string_view name);

/// The number with the fewest digits that reads back as the same double: "0.1", "1e-09", "-0".
std::string number_text(double value);

/// With so many decimals, rounded to the nearest (ties to even, of the exact binary value), as printf's %.*f.
std::string fixed_text(double value, int decimals);

/// With at most so many significant digits and no zeros at the end, as printf's %.*g.
std::string significant_text(double value, int digits);

/// The number that the whole of `text` is, without blanks or a plus; nothing when it is none or does not fit
/// T. `base` counts for whole numbers only.
template <typename T>
std::optional<T> number_in(std::string_view text, [[maybe_unused]] int base = 10) {
  T value{};
  std::from_chars_result read{};
  if constexpr (std::is_floating_point_v<T>) {
    read = std::from_chars(text.data(), text.data() + text.size(), value);
  } else {
    read = std::from_chars(text.data(), text.data() + text.size(), value, base);
  }
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace toile
