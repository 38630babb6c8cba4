#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/project/project.h"

namespace toile::app {

/// What a person says of a body on the command line: "own", a preset with measures over it
/// ("eu40,waist=80,hip=104"), measures alone ("bust=92,waist=74"), or the path of a mesh.
struct BodyWord {
  bool own = false;
  std::string file;                                    ///< path; empty: a mannequin, or the project's own
  std::optional<project::ProjectMannequin> mannequin;  ///< in case
};

/// Errors: usage.body, project.*, with the word as place.
Result<BodyWord> read_body_word(const std::string& word);

}  // namespace toile::app
