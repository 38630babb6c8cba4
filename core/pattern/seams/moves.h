#pragma once
// The moves of a search for seams: small changes of what is sewn, chosen by a fixed sequence of numbers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pattern/seams/gluing.h"

namespace toile::seams {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t n) {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<std::size_t>((z ^ (z >> 31)) % n);
  }

 private:
  std::uint64_t state_;
};

/// A run that another may be sewn to, and what speaks for that, as pair_merit() says.
struct Candidate {
  Index run;
  std::array<double, 2> merit;
};

/// What there is to choose from. The model and the locked runs must outlive it.
struct Choices {
  const SeamModel& model;
  const std::vector<char>& locked;                 ///< of each run: it stays as it is
  std::vector<std::vector<Candidate>> candidates;  ///< of each run, the best first
  std::vector<Index> open;                         ///< runs that have any

  /// Of run a, run b; null when b is none.
  const Candidate* candidate(Index a, Index b) const;
};
Choices choices_of(const SeamModel& model, const std::vector<char>& locked);

/// What a search leaves alone, beside the locked runs.
struct Limits {
  bool may_turn = true;                         ///< panels over
  std::vector<std::array<Index, 2>> forbidden;  ///< pairs of runs that are not sewn
};

/// The limits, and never run a to run b, nor a run of another piece of the same form in place of one of them:
/// the garment with two such pieces changed round is the same garment. Neither the mirror image of one, where
/// no name tells left from right.
Limits without_pair(Limits limits, const SeamModel& model, Index a, Index b);

/// Changes `gluing` a little; false when the move that was drawn does not fit it. What is left of it then is
/// of no use.
bool change(const Choices& choices, const Limits& limits, Numbers& numbers, SeamGluing& gluing);

}  // namespace toile::seams
