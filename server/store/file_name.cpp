#include "server/store/file_name.h"

#include <algorithm>
#include <cstddef>

#include "core/base/names.h"

namespace toile::store {
namespace {

constexpr std::size_t kLongestName = 255;  // bytes; what Linux file systems take

/// Length of the UTF-8 character that `text` begins with (1 to 4), or 0 when it is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  if (length == 0 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  // Too long a form for the character, half of a surrogate pair, or beyond the last character.
  if ((first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f)) return 0;
  if ((first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) > 0x8f)) return 0;
  return length;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

Status check_name(std::string_view name) {
  const auto refused = [&](const char* reason) {
    return Error{"store.bad_name", "the file name " + in_quotes(name) + " " + reason, ""};
  };
  if (name.empty()) return refused("is empty");
  if (name.size() > kLongestName) return refused("has more than 255 bytes");
  if (name.front() == '.') return refused("begins with a dot");
  if (name.find_first_of("/\\") != std::string_view::npos) return refused("has a slash in it");
  const auto control = [](char c) { return (c >= 0 && c < 0x20) || c == 0x7f; };
  if (std::any_of(name.begin(), name.end(), control)) return refused("has a control character in it");
  if (!is_utf8(name)) return refused("is not UTF-8");
  return {};
}

std::string ending_of(std::string_view file_name) {
  constexpr std::size_t kLongest = 8;
  const std::size_t dot = file_name.rfind('.');
  if (dot == std::string_view::npos) return ".bin";
  std::string ending(file_name.substr(dot + 1));
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  const bool plain = std::all_of(ending.begin(), ending.end(),
                                 [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); });
  return plain && !ending.empty() && ending.size() <= kLongest ? "." + ending : ".bin";
}

}  // namespace toile::store
