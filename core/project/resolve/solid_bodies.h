#pragma once
// The bodies of a document, as they stand in space.

#include <vector>

#include "core/base/result.h"
#include "core/body/body.h"
#include "core/project/project.h"
#include "core/project/resolve/opened_files.h"

namespace toile::resolve {

/// Errors: project.path, project.body_too_far, and whatever the files give.
Status add_bodies(const std::vector<project::ProjectBody>& given, OpenedFiles& files,
                  std::vector<body::Body>& bodies);

}  // namespace toile::resolve
