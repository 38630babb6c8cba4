#include "core/dressing/person.h"

namespace toile::dressing {

std::optional<Person> find_person(std::span<const body::Body> bodies) {
  for (const body::Body& body : bodies) {
    if (auto figure = measure::find_figure(body.mesh)) return Person{&body, *figure};
  }
  return std::nullopt;
}

}  // namespace toile::dressing
