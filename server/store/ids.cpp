#include "server/store/ids.h"

#include <sys/random.h>

#include <algorithm>
#include <cstddef>

#include "core/base/hash.h"

namespace toile::store {
namespace {

/// In the order of their bytes, so that text sorts as the numbers do.
constexpr std::string_view kDigits = "0123456789abcdefghjkmnpqrstvwxyz";
constexpr std::size_t kPrefixSize = 2, kTimeDigits = 8, kChanceDigits = 12;
/// 2025-01-01; 40 bits of milliseconds reach from there to 2059.
constexpr std::int64_t kFirstMs = 1'735'689'600'000;
constexpr std::int64_t kLastTick = (std::int64_t{1} << (5 * kTimeDigits)) - 1;
constexpr std::uint64_t kLastChance = (std::uint64_t{1} << (5 * kChanceDigits)) - 1;
constexpr std::uint64_t kStride = std::uint64_t{1} << 24;  // hard to guess, and room for 2³⁶ more ids

std::uint64_t number_of(std::string_view digits) {
  std::uint64_t number = 0;
  for (const char c : digits) number = number * 32 + kDigits.find(c);
  return number;
}

void append(std::string& id, std::uint64_t number, std::size_t digits) {
  for (std::size_t digit = digits; digit-- > 0;) id += kDigits[(number >> (5 * digit)) & 31];
}

}  // namespace

std::string asset_id(std::string_view kind, std::string_view name, std::string_view bytes) {
  std::string all(kind);  // no kind, no name has a slash
  all.append("/").append(name).append("/").append(hash_of(bytes));
  return "a_" + hash_of(std::string_view(all));
}

bool is_id(std::string_view text, char letter) {
  return text.size() == kPrefixSize + kTimeDigits + kChanceDigits && text[0] == letter && text[1] == '_' &&
         text.find_first_not_of(kDigits, kPrefixSize) == std::string_view::npos;
}

void IdSource::start_after(std::string_view id) {
  if (id.empty() || !is_id(id, id[0])) return;
  const auto tick = static_cast<std::int64_t>(number_of(id.substr(kPrefixSize, kTimeDigits)));
  const std::uint64_t chance = number_of(id.substr(kPrefixSize + kTimeDigits));
  last_chance_ = tick > last_ ? chance : tick == last_ ? std::max(last_chance_, chance) : last_chance_;
  last_ = std::max(last_, tick);
}

Result<std::string> IdSource::next(char letter, std::int64_t now_ms) {
  std::uint64_t chance = 0;
  if (getrandom(&chance, sizeof chance, 0) != static_cast<ssize_t>(sizeof chance)) {
    return Error{"store.failed", "the system gives no random numbers", "", ErrorKind::kSystem};
  }
  // Two ids of one millisecond, or a clock that was set back: the time is then one more than the last.
  const std::int64_t tick = std::min(std::max(now_ms - kFirstMs, last_ + 1), kLastTick);
  chance &= kLastChance;
  // A clock was once beyond the last time there is: ids go on rising in the digits behind it.
  if (tick == last_) chance = last_chance_ + 1 + chance % kStride;
  if (chance > kLastChance)
    return Error{"store.failed", "there are no more ids; set the clock right and start with a new folder", "",
                 ErrorKind::kSystem};
  last_ = tick;
  last_chance_ = chance;
  std::string id{letter, '_'};
  append(id, static_cast<std::uint64_t>(tick), kTimeDigits);
  append(id, chance, kChanceDigits);
  return id;
}

}  // namespace toile::store
