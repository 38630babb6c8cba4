#pragma once
// The files that a project document names, wherever they are kept.

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/body/mannequin/mannequin.h"
#include "core/body/mesh_import/import.h"

namespace toile::resolve {

/// Where the files that a document names come from: a folder, a store, a test. Names have passed
/// check_file_name.
struct ProjectFiles {
  /// The DXF file's bytes.
  std::function<Result<std::string>(const std::string& name)> dxf_text;
  /// The mesh in metres, y up, mended.
  std::function<Result<mesh_import::RepairedMesh>(const std::string& name,
                                                  const mesh_import::MeshSettings& settings)>
      body_mesh;
  /// The program's own figure, where one is kept; without it make_mannequin makes it.
  std::function<Result<geometry::TriangleMesh>(const mannequin::MannequinSettings& settings)> mannequin = {};
  /// A picture file's bytes. No drape asks for it: see textures.h.
  std::function<Result<std::string>(const std::string& name)> image_bytes = {};
};

/// A name that stays inside its folder: relative, without "..", without "\". Error: project.path.
Status check_file_name(const std::string& name);

/// The files of a folder. Errors of its functions: project.file (not there, not readable),
/// project.too_large, mesh.*.
ProjectFiles files_in(const std::filesystem::path& folder, const mesh_import::MeshImporter& importer = {});

/// A document's bytes from disk. Errors: project.file, json.too_large.
Result<std::string> read_project_text(const std::filesystem::path& path);

}  // namespace toile::resolve
