#include "core/base/text.h"

#include <array>

namespace toile {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
char small_of(char c) { return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c; }

template <typename... Form>
std::string written(double value, Form... form) {
  std::array<char, 384> buffer;  // the greatest double has 309 digits before its decimals
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, form...).ptr;
  return {buffer.data(), end};
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = small_of(c);
  return out;
}

std::vector<std::string> words_of_name(std::string_view name) {
  std::vector<std::string> words;
  bool after_small = false, open = false;
  for (const char c : name) {
    const bool letter = is_small(c) || is_capital(c);
    if (letter && (!open || (is_capital(c) && after_small))) words.emplace_back();
    if (letter) words.back() += small_of(c);
    open = letter;
    after_small = is_small(c);
  }
  return words;
}

std::string number_text(double value) { return written(value); }

std::string fixed_text(double value, int decimals) {
  return written(value, std::chars_format::fixed, decimals);
}

std::string significant_text(double value, int digits) {
  return written(value, std::chars_format::general, digits);
}

}  // namespace toile
