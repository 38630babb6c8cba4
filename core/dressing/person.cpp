#include "core/dressing/person.h"

#include "core/body/measure/stance.h"

namespace toile::dressing {

std::optional<Person> find_person(std::span<const body::Body> bodies) {
  for (const body::Body& body : bodies) {
    if (auto figure = measure::find_figure(body.mesh)) return Person{&body, *figure};
  }
  return std::nullopt;
}

bool looks_back(const Person& person) {
  const Result<measure::StandingBody> standing = measure::stand_body(person.body->mesh);
  return standing && standing->stance.quarter_turns == 2;
}

}  // namespace toile::dressing
