#pragma once
// How a document's bodies move.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/body/body.h"
#include "core/project/project.h"
#include "core/project/resolve/opened_files.h"

namespace toile::resolve {

/// The keyframes of a body whose mesh is `mesh`, before it is placed; between two mannequins shapes on the
/// way are added. `where` is the body's pointer. Errors: project.keyframe_order, project.keyframe_mesh
/// (another mesh than the body's), project.motion_large, and those of mesh_of and place.
Result<std::vector<body::Keyframe>> motion_of(const project::ProjectBody& given,
                                              const geometry::TriangleMesh& mesh, OpenedFiles& files,
                                              const std::string& where);

}  // namespace toile::resolve
