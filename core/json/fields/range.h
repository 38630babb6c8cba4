#pragma once
// JSON objects as structs, said once: for each struct a function describe(visitor, object) names its keys,
// where they go and what they may be. Readers, writers and the list of keys are visitors of these functions,
// so that they cannot disagree. A visitor has
//   field(key, place, need, range)      any value; the range holds for numbers and for the count of a list
//   choice(key, place, {words})         a string out of a few; absent: stays as it is
//   exactly_one(key, key, …)            of these keys, one must be there
// The functions stand in this namespace, which is the visitors' own: there the compiler looks for them.

#include <limits>

namespace toile::fields {

enum class Need { kOptional, kRequired };

struct Range {
  double least = std::numeric_limits<double>::lowest();
  double most = std::numeric_limits<double>::max();
};

inline constexpr Range kAnything{};

/// What holds for an element of a list of T.
template <typename T>
inline constexpr Range kElementRange = kAnything;

}  // namespace toile::fields
