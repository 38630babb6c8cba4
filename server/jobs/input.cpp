#include "server/jobs/input.h"

#include <utility>

#include "core/base/hash.h"
#include "core/base/names.h"
#include "core/drape/worn_part.h"
#include "core/project/resolve/resolve.h"
#include "core/project/resolve/textures.h"
#include "server/documents/projects.h"
#include "server/documents/read_cloth.h"
#include "server/documents/used_files.h"

namespace toile::jobs {

Result<drape::DrapeInput> drape_input_of(documents::Documents& documents,
                                         const store::RequestContext& context, const std::string& document,
                                         const std::map<std::string, std::string>& files) {
  const project::Project project = TRY(project::parse_project(document));
  drape::DrapeInput input =
      TRY(resolve::resolve_project(project, documents::files_in_store(documents, context, files)));
  return drape::worn_part(std::move(input));
}

Result<image::Textures> textures_of(documents::Documents& documents, const store::RequestContext& context,
                                    const std::string& document,
                                    const std::map<std::string, std::string>& files,
                                    const pattern::Pattern& pattern) {
  const project::Project project = TRY(project::parse_project(document));
  return resolve::read_textures(project, pattern, documents::files_in_store(documents, context, files));
}

Result<store::JobRow> row_of_drape(documents::Documents& documents, const store::RequestContext& context,
                                   const std::string& project_id, const JobLimits& limits) {
  const store::ProjectRow project = TRY(documents.store().project(context, project_id));
  // Without the bodies, which may take long: they were read when the project was kept.
  const auto read = TRY(documents::read_cloth(documents, context, project.document, project.files));
  TRY(check_size(limits, read->cloth));
  for (const documents::UsedFile& file : documents::used_files(read->project)) {
    // A drape is worth having without its pictures.
    if (file.kind == "image" || project.files.contains(file.name)) continue;
    return Error{"documents.missing_file", "the file " + in_quotes(file.name) + " is not among the uploads",
                 file.where};
  }
  store::JobRow row;
  row.project_id = project.id;
  row.project_revision = project.revision;
  row.name = project.name;
  row.document = project.document;
  row.files = project.files;
  return row;
}

/// Ids of files are hashes of their bytes.
std::string input_of(const store::JobRow& job, const std::string& engine, int width, int height) {
  if (engine.empty()) return "";
  std::string all = engine + '\n' + std::to_string(width) + ' ' + std::to_string(height) + '\n';
  for (const auto& [name, id] : job.files) all += id + ' ' + name + '\n';
  all += job.document;
  return hash_of(std::string_view(all));
}

}  // namespace toile::jobs
