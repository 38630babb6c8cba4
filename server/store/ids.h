#pragma once
// Ids of projects and jobs: they sort by the time they were given out, and cannot be guessed.

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile::store {

/// Gives out ids: a letter, "_", 8 characters of time and 12 of chance, all of 0-9a-z without i, l, o, u.
/// Each sorts after the one before, even when the clock is set back. Not thread-safe.
class IdSource {
 public:
  /// What follows sorts after `id`, when it is one.
  void start_after(std::string_view id);
  /// `now_ms` is Unix time. Error: store.failed when the system has no random numbers.
  Result<std::string> next(char letter, std::int64_t now_ms);

 private:
  std::int64_t last_ = -1;         ///< ms since kFirstMs that the newest id carries
  std::uint64_t last_chance_ = 0;  ///< the digits behind, of that id
};

/// Id of an upload: "a_" and 32 hex digits, of its kind, name and bytes. Who has the file knows it before it
/// is there.
std::string asset_id(std::string_view kind, std::string_view name, std::string_view bytes);

/// Whether `text` has the form of an id of that letter.
bool is_id(std::string_view text, char letter);

}  // namespace toile::store
