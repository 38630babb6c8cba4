#pragma once
// Project document → DrapeInput: files are opened, names become indices, units become the core's.

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/body/mannequin/mannequin.h"
#include "core/body/mesh_import/import.h"
#include "core/drape/drape_input.h"
#include "proto/cpp/project.h"

namespace toile {

/// Where the files that a document names come from: a folder, a store, a test. Names have passed
/// check_file_name.
struct ProjectFiles {
  /// The DXF file's bytes.
  std::function<Result<std::string>(const std::string& name)> dxf_text;
  /// The mesh in metres, y up, mended.
  std::function<Result<RepairedMesh>(const std::string& name, const MeshSettings& settings)> body_mesh;
  /// The program's own figure, where one is kept; without it make_mannequin makes it.
  std::function<Result<TriangleMesh>(const MannequinSettings& settings)> mannequin = {};
  /// A picture file's bytes. No drape asks for it: see project_textures.h.
  std::function<Result<std::string>(const std::string& name)> image_bytes = {};
};

/// A name that stays inside its folder: relative, without "..", without "\". Error: project.path.
Status check_file_name(const std::string& name);

/// Errors: project.duplicate_id, project.unknown_piece, project.unknown_edge, project.unknown_fabric,
/// project.unknown_line, project.unstable_fabric, project.path, project.body_too_far and whatever the files
/// give; dxf.* and pattern.* where a piece cannot be cut. `where` begins with the JSON pointer of the place.
Result<DrapeInput> resolve_project(const Project& project, const ProjectFiles& files);

/// The files of a folder. Errors of its functions: project.file (not there, not readable),
/// project.too_large, mesh.*.
ProjectFiles files_in(const std::filesystem::path& folder, const MeshImporter& importer = {});

/// A document's bytes from disk. Errors: project.file, json.too_large.
Result<std::string> read_project_text(const std::filesystem::path& path);

/// Reads a document and the files beside it. Errors: json.*, project.* and those of resolve_project.
Result<DrapeInput> read_project(const std::filesystem::path& path, const MeshImporter& importer = {});

}  // namespace toile
