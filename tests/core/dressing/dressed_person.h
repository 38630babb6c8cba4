#pragma once
// The sample's mannequin, as someone to dress.

#include "core/body/mesh_import/load.h"
#include "core/dressing/person.h"

namespace toile::test {

inline const dressing::Person& person() {
  static const body::Body body{"mannequin",
                               mesh_import::load_mesh(TOILE_SOURCE_DIR "/samples/skirt/body.obj").value()};
  static const dressing::Person person = dressing::find_person(std::span(&body, 1)).value();
  return person;
}

}  // namespace toile::test
