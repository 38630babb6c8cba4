#pragma once
// Project document → DrapeInput: files are opened, names become indices, units become the core's.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/body/mesh_import/import.h"
#include "core/drape/drape_input.h"
#include "core/project/project.h"
#include "core/project/resolve/opened_files.h"
#include "core/project/resolve/textures.h"

namespace toile::resolve {

/// Errors: project.duplicate_id, project.unknown_piece, project.unknown_edge, project.unknown_fabric,
/// project.unknown_line, project.unstable_fabric, project.path, project.body_too_far and whatever the files
/// give; dxf.* and pattern.* where a piece cannot be cut. `where` begins with the JSON pointer of the place.
Result<drape::DrapeInput> resolve_project(const project::Project& project, OpenedFiles& files);
/// For whoever resolves it but once.
Result<drape::DrapeInput> resolve_project(const project::Project& project, const ProjectFiles& files);

/// A document from disk and what it says, handed on so that nobody has to read it again.
struct ResolvedProject {
  project::Project project;
  drape::DrapeInput input;
  ProjectFiles files;  ///< beside the document
  std::filesystem::path path;
};

/// Told of a pattern file that was read, with its bytes.
using FileNote = std::function<void(const std::string& name, std::string_view bytes)>;

/// Reads a document and the files beside it. Errors: json.*, project.* and those of resolve_project.
Result<ResolvedProject> read_project(const std::filesystem::path& path,
                                     const mesh_import::MeshImporter& importer = {},
                                     const FileNote& note = {});

/// The pictures of the document. Errors: those of textures.h, with the document's name first in `where`.
Result<image::Textures> read_textures(const ResolvedProject& read);

}  // namespace toile::resolve
