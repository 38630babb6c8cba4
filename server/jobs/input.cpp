#include "server/jobs/input.h"

#include <memory>
#include <set>
#include <utility>

#include "core/base/hash.h"
#include "core/base/names.h"
#include "core/drape/worn_part.h"
#include "core/project/resolve/resolve.h"
#include "core/project/resolve/textures.h"
#include "core/warm/hung_garment.h"
#include "server/documents/assets.h"
#include "server/documents/projects.h"
#include "server/documents/read_cloth.h"
#include "server/documents/used_files.h"

namespace toile::jobs {

namespace {

/// Keeps how the garment of a job hung, and gives back the file's id.
Result<std::string> kept_shape(documents::Documents& documents, const store::RequestContext& context,
                               const std::string& from) {
  const Result<store::JobRow> job = documents.store().job(context, from);
  if (!job)
    return Error{"jobs.from", "there is no job " + in_quotes(from) + " to go on from", "/from",
                 ErrorKind::kInput};
  if (!store::is_final(job->state) || !job->results.contains(kShapeFile))
    return Error{"jobs.no_shape",
                 "the job " + in_quotes(from) + " has no shape to go on from: it has not ended, or left none",
                 "/from", ErrorKind::kConflict};
  const std::string bytes = TRY(documents.store().result_bytes(context, from, kShapeFile));
  return TRY(documents::add_asset(documents, context, "shape", kShapeFile, bytes)).id;
}

}  // namespace

Result<drape::DrapeInput> drape_input_of(documents::Documents& documents,
                                         const store::RequestContext& context, const std::string& document,
                                         const std::map<std::string, std::string>& files) {
  const project::Project project = TRY(project::parse_project(document));
  drape::DrapeInput input =
      TRY(resolve::resolve_project(project, documents::files_in_store(documents, context, files)));
  if (const auto shape = files.find(kShapeFile); shape != files.end()) {
    const std::string bytes = TRY(documents.store().asset_bytes(context, shape->second));
    input.before = std::make_shared<const warm::HungGarment>(TRY(warm::decode_hung(bytes)));
  }
  return drape::worn_part(std::move(input));
}

Result<image::Textures> textures_of(documents::Documents& documents, const store::RequestContext& context,
                                    const std::string& document,
                                    const std::map<std::string, std::string>& files,
                                    const pattern::Pattern& pattern) {
  const project::Project project = TRY(project::parse_project(document));
  return resolve::read_textures(project, pattern, documents::files_in_store(documents, context, files));
}

Result<store::JobRow> row_of_project(documents::Documents& documents, const store::RequestContext& context,
                                     const store::ProjectRow& project, const JobLimits& limits) {
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

Result<store::JobRow> row_of_drape(documents::Documents& documents, const store::RequestContext& context,
                                   const std::string& project_id, const JobLimits& limits,
                                   const std::string& from) {
  const store::ProjectRow project = TRY(documents.store().project(context, project_id));
  store::JobRow row = TRY(row_of_project(documents, context, project, limits));
  if (!from.empty()) row.files[kShapeFile] = TRY(kept_shape(documents, context, from));
  return row;
}

Result<store::JobRow> row_of_drape_on(documents::Documents& documents, const store::RequestContext& context,
                                      const std::string& project_id, const JobLimits& limits,
                                      const std::string& shape) {
  store::JobRow row = TRY(row_of_drape(documents, context, project_id, limits));
  if (!shape.empty())
    row.files[kShapeFile] = TRY(documents::add_asset(documents, context, "shape", kShapeFile, shape)).id;
  return row;
}

Result<manifest::Manifest> inputs_of(documents::Documents& documents, const store::RequestContext& context,
                                     const store::JobRow& job) {
  const project::Project project = TRY(project::parse_project(job.document));
  manifest::Manifest out;
  out.document = manifest::mark_of("project.json", project);
  out.settings = project.settings;
  std::set<std::string> named{kShapeFile};
  for (const documents::UsedFile& file : documents::used_files(project)) named.insert(file.name);
  for (const auto& [name, id] : job.files) {
    if (!named.contains(name)) continue;  // an upload that the document does not use
    const std::string bytes = TRY(documents.store().asset_bytes(context, id));
    out.inputs.push_back(manifest::mark_of(name, std::string_view(bytes)));
  }
  return out;
}

/// Ids of files are hashes of their bytes.
std::string input_of(const store::JobRow& job, const std::string& engine, int width, int height) {
  if (engine.empty()) return "";
  std::string all = std::to_string(width) + ' ' + std::to_string(height) + '\n';
  if (!job.pictures) all = "no pictures\n";
  for (const auto& [name, id] : job.files) all.append(id).append(" ").append(name).append("\n");
  all += job.document;
  return engine + "-" + hash_of(std::string_view(all));
}

bool is_of_engine(const std::string& input, const std::string& engine) {
  return !engine.empty() && input.starts_with(engine + "-");
}

}  // namespace toile::jobs
