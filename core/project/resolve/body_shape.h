#pragma once
// The meshes that a document's bodies are made of.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/body/mesh_import/repair.h"
#include "core/project/project.h"
#include "core/project/resolve/opened_files.h"

namespace toile::resolve {

/// Read or made, not yet placed. Errors: project.path, project.unknown_preset, mannequin.*, mesh.*, and what
/// the files' source gives; places begin with `where`.
Result<mesh_import::RepairedMesh> mesh_of(const project::ProjectBody& given, OpenedFiles& files,
                                          const std::string& where);

/// Angles as a document has them, in the core's unit.
Vec3 radians(Vec3 degrees);

/// Scales, turns and moves it as the document says. Error: project.body_too_far.
Status place(const project::ProjectBody& given, const std::string& where, std::vector<Vec3>& vertices);

}  // namespace toile::resolve
