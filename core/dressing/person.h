#pragma once
// Who of a scene's bodies is to be dressed.

#include <optional>
#include <span>

#include "core/body/body.h"
#include "core/body/measure/figure.h"

namespace toile::dressing {

/// The first body that stands like a person.
struct Person {
  const body::Body* body = nullptr;
  measure::BodyFigure figure;
};
std::optional<Person> find_person(std::span<const body::Body> bodies);

/// Whether the person looks along -z, against all that is put on along +z.
bool looks_back(const Person& person);

}  // namespace toile::dressing
