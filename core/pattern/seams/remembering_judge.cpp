#include "core/pattern/seams/remembering_judge.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace toile::seams {

RememberingJudge::RememberingJudge(const SeamModel& model, const GluingSettings& settings, std::size_t bytes)
    : judge_(model, settings),
      runs_(model.runs.size()),
      words_((runs_ * sizeof(Index) + model.words.size() + sizeof(std::uint64_t) - 1) /
             sizeof(std::uint64_t)),
      key_(words_, 0),
      known_(
          std::max<std::size_t>(1, std::bit_floor(bytes / (sizeof(Known) + words_ * sizeof(std::uint64_t))))),
      keys_(known_.size() * words_) {}

void RememberingJudge::write_key(const SeamGluing& g) {
  auto* bytes = reinterpret_cast<std::byte*>(key_.data());
  std::memcpy(bytes, g.partner.data(), runs_ * sizeof(Index));
  std::memcpy(bytes + runs_ * sizeof(Index), g.turned.data(), g.turned.size());
}

std::uint64_t RememberingJudge::hash_of_key() const {
  std::uint64_t hash = 1;  // as of no place where nothing is known yet
  for (const std::uint64_t word : key_) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash;
}

double RememberingJudge::merit(const SeamGluing& g) {
  write_key(g);
  const std::uint64_t hash = hash_of_key();
  const double pairs = judge_.pairs(g);
  const std::size_t place = hash & (known_.size() - 1);
  Known& known = known_[place];
  const auto key = keys_.begin() + static_cast<std::ptrdiff_t>(place * words_);
  // What speaks for a pair may differ in its last bit with which of the two came first.
  if (known.hash == hash && known.pairs == pairs && std::equal(key_.begin(), key_.end(), key))
    return known.merit;
  known = {hash, pairs, judge_.merit(g, pairs)};
  std::copy(key_.begin(), key_.end(), key);
  return known.merit;
}

}  // namespace toile::seams
