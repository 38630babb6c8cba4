#pragma once
// A judge of garments who remembers them.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pattern/seams/judge.h"

namespace toile::seams {

/// As GluingJudge. A search comes back to the garments that it has left, mostly around the best ones: what
/// was found of those last is kept. The model must outlive it.
class RememberingJudge {
 public:
  /// Remembers as many garments as fit into that memory.
  RememberingJudge(const SeamModel& model, const GluingSettings& settings, std::size_t bytes);
  double merit(const SeamGluing& gluing);

 private:
  struct Known {
    std::uint64_t hash = 0;
    double pairs = 0, merit = 0;
  };
  void write_key(const SeamGluing& g);
  std::uint64_t hash_of_key() const;

  GluingJudge judge_;
  std::size_t runs_, words_;  ///< of a key
  std::vector<std::uint64_t>
      key_;                   ///< of the garment that is asked for: partners, and which panels are turned
  std::vector<Known> known_;  ///< by the lower bits of their hashes; a later one takes another's place
  std::vector<std::uint64_t> keys_;  ///< of these
};

}  // namespace toile::seams
