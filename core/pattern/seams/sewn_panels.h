#pragma once
// Which pieces hang together.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/types.h"

namespace toile::seams {

/// Pieces and the runs that are sewn between them.
class SewnPanels {
 public:
  explicit SewnPanels(std::size_t panels);

  /// One more run, or one less, is sewn from the one panel to the other.
  void add(Index p, Index q);
  void remove(Index p, Index q);
  /// Parts that do not hang together.
  int parts();

 private:
  using Word = std::uint64_t;  ///< one bit a panel, so that many are looked at at once
  static constexpr std::size_t kBits = 64;

  int& runs_between(Index p, Index q) {
    return runs_[static_cast<std::size_t>(std::min(p, q)) * panels_ +
                 static_cast<std::size_t>(std::max(p, q))];
  }
  void flip(Index p, Index q);
  int count_parts();
  static Word bit(Index q) { return Word{1} << (q % kBits); }

  std::size_t panels_, words_;
  std::vector<int> runs_;     ///< of each two panels, the lower one's first
  std::vector<Word> beside_;  ///< of each panel: those that it is sewn to
  int parts_ = 0;
  bool counted_ = false;     ///< `parts_` are those of now
  std::vector<Word> left_;   ///< panels that no part has yet
  std::vector<Index> open_;  ///< panels of a part whose neighbours are still to come
};

}  // namespace toile::seams
