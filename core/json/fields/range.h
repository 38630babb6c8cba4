#pragma once
// JSON objects as structs, said once: for each struct a function describe(visitor, object) names its keys,
// where they go, what they mean and what they may be. Readers, writers and the schema are visitors of these
// functions, so that they cannot disagree. A visitor has
//
//   object(name, meaning)         said first: the object's name among the schema's definitions (empty: it is
//                                 written out where it stands) and what it is
//   field(key, place, meaning, need, range)    any value; the range is of numbers, and of a list's count
//   file(key, place, meaning, need)            a string that names a file
//   choice(key, place, meaning, {words}, need) a string out of a few; absent: stays as it is
//   shared_choice(name, meaning, key, place, {words})    the same, where several objects have it
//   chosen_names(key, place, meaning, {words})    an object of names, each with a string out of a few
//   exactly_one(key, key, …)      of these keys, one must be there
//   unless(key, {keys})           these keys must be there where that one is not
//
// Meanings are for people who read the schema; units stand first in them. An empty one: the value's own
// definition says enough. The functions stand in this namespace, which is the visitors' own: there the
// compiler looks for them.

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace toile::fields {

enum class Need { kOptional, kRequired };

struct Range {
  double least = std::numeric_limits<double>::lowest();
  double most = std::numeric_limits<double>::max();
  const char* name = "";  ///< of such a number among the schema's definitions; empty: of none
};

inline constexpr Range kAnything{};

inline constexpr std::size_t kLongestText = 200;  ///< bytes of a name or a file name

using Words = std::initializer_list<const char*>;

/// Names, each with a word.
using ChosenNames = std::vector<std::pair<std::string, std::string>>;
inline constexpr std::size_t kMostNames = 1000;

/// What holds for an element of a list, and what it means.
struct ElementRule {
  Range range = kAnything;
  const char* meaning = "";
};
template <typename T>
inline constexpr ElementRule kElement = {};

}  // namespace toile::fields
