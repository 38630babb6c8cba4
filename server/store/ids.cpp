#include "server/store/ids.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace toile::store {
namespace {

/// In the order of their bytes, so that text sorts as the numbers do.
constexpr std::string_view kDigits = "0123456789abcdefghjkmnpqrstvwxyz";
constexpr std::size_t kPrefixSize = 2, kTimeDigits = 8, kChanceDigits = 12;
/// 2025-01-01; 40 bits of milliseconds reach from there to 2059.
constexpr std::int64_t kFirstMs = 1'735'689'600'000;
constexpr std::int64_t kLastTick = (std::int64_t{1} << (5 * kTimeDigits)) - 1;

std::int64_t tick_of(std::string_view id) {
  std::int64_t tick = 0;
  for (const char c : id.substr(kPrefixSize, kTimeDigits)) {
    tick = tick * 32 + static_cast<std::int64_t>(kDigits.find(c));
  }
  return tick;
}

}  // namespace

bool is_id(std::string_view text, char letter) {
  return text.size() == kPrefixSize + kTimeDigits + kChanceDigits && text[0] == letter && text[1] == '_' &&
         text.find_first_not_of(kDigits, kPrefixSize) == std::string_view::npos;
}

void IdSource::start_after(std::string_view id) {
  if (!id.empty() && is_id(id, id[0])) last_ = std::max(last_, tick_of(id));
}

Result<std::string> IdSource::next(char letter, std::int64_t now_ms) {
  std::array<unsigned char, kChanceDigits> chance;
  if (getrandom(chance.data(), chance.size(), 0) != static_cast<ssize_t>(chance.size())) {
    return Error{"store.failed", "the system gives no random numbers", "", ErrorKind::kSystem};
  }
  // Two ids of one millisecond, or a clock that was set back: the time is then one more than the last.
  last_ = std::min(std::max(now_ms - kFirstMs, last_ + 1), kLastTick);
  std::string id{letter, '_'};
  for (std::size_t digit = kTimeDigits; digit-- > 0;) id += kDigits[(last_ >> (5 * digit)) & 31];
  for (const unsigned char byte : chance) id += kDigits[byte & 31];
  return id;
}

}  // namespace toile::store
