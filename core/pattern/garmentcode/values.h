#pragma once
// Values of a specification with their places. Internal to garmentcode. Errors of all functions:
// garmentcode.missing, garmentcode.type, garmentcode.range, garmentcode.reference; `what` is what the value
// is called in them.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/json/tree.h"

namespace toile::garmentcode {

/// A value with its place, so that every error can name it.
struct Place {
  const json::JsonValue* value = nullptr;
  std::string pointer;

  /// REQUIRES a list with that element.
  Place at(std::size_t i) const { return {&(*value->array())[i], json::pointer_to(pointer, i)}; }
  /// The member of that name; its value is null when it is not there.
  Place find(std::string_view key) const { return {value->find(key), json::pointer_to(pointer, key)}; }
};

/// It is missing, or something else.
Error wrong_type(const Place& place, const char* wanted);
Result<Place> object(const Place& place, const char* what);
/// A list of `least` to `most` elements.
Result<Place> list(const Place& place, const char* what, std::size_t least, std::size_t most);
Result<double> number(const Place& place, const char* what);
/// A whole number from 0 up to but not including `end`.
Result<std::size_t> index(const Place& place, const char* what, std::size_t end);

template <std::size_t N>
Result<std::array<double, N>> numbers(const Place& place, const char* what) {
  TRY(list(place, what, N, N));
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    const double value = TRY(number(place.at(i), what));
    values[i] = value;
  }
  return values;
}

}  // namespace toile::garmentcode
