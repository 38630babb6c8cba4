#pragma once
// This program as the reader of mesh files: it calls itself, so that a file which brings the reader down
// brings down nothing else. That costs some 30 ms a file.

#include <optional>

#include "core/body/mesh_import/import.h"

namespace toile::app {

/// Has meshes read by another process of this program.
mesh_import::MeshImporter own_mesh_importer();

/// The other process's part: reads a mesh when that is what these arguments ask for, and gives the exit code.
std::optional<int> read_mesh_for_parent(int argc, char** argv);

}  // namespace toile::app
