#pragma once
// Projects of the store: a document is kept only when it can be read, its files are there and a drape can be
// made of it.

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/project/resolve/resolve.h"
#include "server/documents/documents.h"

namespace toile::documents {

/// File name in the document → asset id.
using ProjectFileMap = std::map<std::string, std::string>;

/// Keeps a new project under the name that the document gives. Errors: json.*, project.*, dxf.*, mesh.*,
/// pattern.*, … of reading it; documents.missing_file (with the first place that names a file which is not
/// there), documents.wrong_kind, documents.unknown_asset, documents.too_many_files; store.*. First in `where`
/// stands a JSON pointer into {"document": …, "files": …}, as they come in a request. With an
/// idempotency key that made this very project before, gives that one back (Store::create_project).
Result<store::Made<store::ProjectRow>> create_project(Documents& documents,
                                                      const store::RequestContext& context,
                                                      const std::string& document,
                                                      const ProjectFileMap& files,
                                                      const std::string& idempotency_key = "");
/// Replaces it when it stands at revision `expected` (0: at any). Errors: those, store.not_found,
/// store.conflict.
Result<store::ProjectRow> replace_project(Documents& documents, const store::RequestContext& context,
                                          const std::string& id, const std::string& document,
                                          const ProjectFileMap& files, int expected);

/// Whether the files may come to those that a project has: they are this owner's, not too many, and none
/// bears the name of another. Errors: documents.unknown_asset, documents.too_many_files,
/// documents.file_taken, each with a pointer into {"files": …}; store.*.
Status check_more_files(Documents& documents, const store::RequestContext& context, const ProjectFileMap& has,
                        const ProjectFileMap& more);
/// Whether `name` stands for an uploaded image. Errors, at `where`: documents.missing_file,
/// documents.wrong_kind; store.*.
Status check_image(Documents& documents, const store::RequestContext& context, const ProjectFileMap& files,
                   const std::string& name, const std::string& where);

/// The files of a project or a job, for resolve_project and read_textures. `documents` outlives it. Errors of
/// its functions: documents.missing_file, documents.wrong_kind, mesh.*, store.*.
resolve::ProjectFiles files_in_store(Documents& documents, const store::RequestContext& context,
                                     ProjectFileMap files);

/// The same of a map that may get more files as time goes by.
resolve::ProjectFiles growing_files_in_store(Documents& documents, const store::RequestContext& context,
                                             const std::shared_ptr<const ProjectFileMap>& files);

/// The setting that holds the sample project's id once it has been added.
inline constexpr const char* kSampleSetting = "sample_project";
/// Adds the project in `folder` (project.json and the files that it names) the first time, and never again:
/// whoever deletes the sample is rid of it. Errors: project.file and those of add_asset and create_project.
Status add_sample_project(Documents& documents, const store::RequestContext& context,
                          const std::filesystem::path& folder);

}  // namespace toile::documents
