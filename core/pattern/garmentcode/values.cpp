#include "core/pattern/garmentcode/values.h"

#include <cmath>

namespace toile::garmentcode {

Error wrong_type(const Place& place, const char* wanted) {
  if (place.value == nullptr)
    return {"garmentcode.missing", std::string(wanted) + " is missing", place.pointer};
  return {"garmentcode.type", std::string("this should be ") + wanted, place.pointer};
}

Result<Place> object(const Place& place, const char* what) {
  if (place.value == nullptr || !place.value->object()) return wrong_type(place, what);
  return place;
}

Result<Place> list(const Place& place, const char* what, std::size_t least, std::size_t most) {
  if (place.value == nullptr || !place.value->array()) return wrong_type(place, what);
  const std::size_t size = place.value->array()->size();
  if (size >= least && size <= most) return place;
  return Error{"garmentcode.range", std::string(what) + " has " + std::to_string(size) + " elements",
               place.pointer};
}

Result<double> number(const Place& place, const char* what) {
  const double* value = place.value == nullptr ? nullptr : place.value->number();
  if (value == nullptr) return wrong_type(place, what);
  if (!std::isfinite(*value) || std::abs(*value) > 1e9)
    return Error{"garmentcode.range", std::string(what) + " is out of all proportion", place.pointer};
  return *value;
}

Result<std::size_t> index(const Place& place, const char* what, std::size_t end) {
  const double value = TRY(number(place, what));
  if (value != std::floor(value) || value < 0 || value >= static_cast<double>(end))
    return Error{"garmentcode.reference", std::string("there is no such ") + what, place.pointer};
  return static_cast<std::size_t>(value);
}

}  // namespace toile::garmentcode
