#include "server/documents/projects.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/json/tree.h"
#include "core/project/project.h"
#include "server/documents/used_files.h"

namespace toile::documents {
namespace {

constexpr std::size_t kMostFiles = 1000;

/// Every asset that the map names is this owner's.
Status check_assets(Documents& documents, const store::RequestContext& context, const ProjectFileMap& files) {
  if (files.size() > kMostFiles) {
    return Error{"documents.too_many_files", "a project has at most 1000 files", "/files"};
  }
  for (const auto& [name, id] : files) {
    const Result<store::AssetRow> asset = documents.store().asset(context, id);
    if (asset) continue;
    if (asset.error().kind != ErrorKind::kNotFound) return asset.error();
    return Error{"documents.unknown_asset", "there is no uploaded file " + in_quotes(id),
                 json::pointer_to("/files", name)};
  }
  return {};
}

/// The first place whose file is not in the map, with the names of all such files in the message.
Status check_missing(const std::vector<UsedFile>& used, const ProjectFileMap& files) {
  std::vector<std::string> missing;
  std::string where;
  for (const UsedFile& file : used) {
    if (files.contains(file.name)) continue;
    if (missing.empty()) where = file.where;
    if (std::find(missing.begin(), missing.end(), file.name) == missing.end()) missing.push_back(file.name);
  }
  if (missing.empty()) return {};
  constexpr std::size_t kMostNamed = 5;
  std::string names;
  for (std::size_t i = 0; i < std::min(missing.size(), kMostNamed); ++i) {
    names += (i > 0 ? ", " : "") + in_quotes(missing[i]);
  }
  if (missing.size() > kMostNamed) names += " and " + std::to_string(missing.size() - kMostNamed) + " more";
  return Error{"documents.missing_file", "the document names files that are not among its uploads: " + names,
               where};
}

Error wrong_kind(const store::AssetRow& asset, const std::string& wanted, const std::string& where) {
  return {"documents.wrong_kind",
          in_quotes(asset.name) + " was uploaded as " + in_quotes(asset.kind) + ", and " + in_quotes(wanted) +
              " is wanted here",
          where};
}

Status check_kinds(Documents& documents, const store::RequestContext& context,
                   const std::vector<UsedFile>& used, const ProjectFileMap& files) {
  for (const UsedFile& file : used) {
    const store::AssetRow asset = TRY(documents.store().asset(context, files.at(file.name)));
    if (asset.kind != file.kind) return wrong_kind(asset, file.kind, file.where);
  }
  return {};
}

/// The same; a pointer into the document becomes one into {"document": …, "files": …}.
template <typename ResultOrStatus>
ResultOrStatus in_document(ResultOrStatus result) {
  if (result || !result.error().where.starts_with('/')) return result;
  Error error = result.error();
  error.where.insert(0, "/document");
  return error;
}

/// A row of the document with its name, once a drape could be made of it.
Result<store::ProjectRow> checked(Documents& documents, const store::RequestContext& context,
                                  const std::string& document, const ProjectFileMap& files) {
  const project::Project project = TRY(in_document(project::parse_project(document)));
  const std::vector<UsedFile> used = used_files(project);
  TRY(in_document(check_missing(used, files)));
  TRY(check_assets(documents, context, files));
  TRY(in_document(check_kinds(documents, context, used, files)));
  TRY(in_document(resolve::resolve_project(project, files_in_store(documents, context, files))));
  store::ProjectRow row;
  row.name = project.name;
  row.document = document;
  row.files = files;
  return row;
}

/// The asset behind a name.
Result<std::string> asset_id_of(const ProjectFileMap& files, const std::string& name) {
  const auto found = files.find(name);
  if (found != files.end()) return found->second;
  return Error{"documents.missing_file", "the file " + in_quotes(name) + " is not among the uploads", ""};
}

}  // namespace

Result<store::Made<store::ProjectRow>> create_project(Documents& documents,
                                                      const store::RequestContext& context,
                                                      const std::string& document,
                                                      const ProjectFileMap& files,
                                                      const std::string& idempotency_key) {
  store::ProjectRow row = TRY(checked(documents, context, document, files));
  return documents.store().create_project(context, std::move(row), idempotency_key);
}

Result<store::ProjectRow> replace_project(Documents& documents, const store::RequestContext& context,
                                          const std::string& id, const std::string& document,
                                          const ProjectFileMap& files, int expected) {
  TRY(documents.store().project(context, id));  // is it there? before any work is done for it
  store::ProjectRow row = TRY(checked(documents, context, document, files));
  row.id = id;
  return documents.store().replace_project(context, row, expected);
}

Status check_more_files(Documents& documents, const store::RequestContext& context, const ProjectFileMap& has,
                        const ProjectFileMap& more) {
  ProjectFileMap all = has;
  for (const auto& [name, id] : more) {
    const auto [at, anew] = all.emplace(name, id);
    if (anew || at->second == id) continue;
    return Error{"documents.file_taken",
                 "the project has another file of the name " + in_quotes(name) + "; give this one another",
                 json::pointer_to("/files", name)};
  }
  if (all.size() > kMostFiles) return check_assets(documents, context, all);
  return check_assets(documents, context, more);
}

Status check_image(Documents& documents, const store::RequestContext& context, const ProjectFileMap& files,
                   const std::string& name, const std::string& where) {
  const std::vector<UsedFile> used{{name, "image", where}};
  TRY(check_missing(used, files));
  return check_kinds(documents, context, used, files);
}

resolve::ProjectFiles files_in_store(Documents& documents, const store::RequestContext& context,
                                     ProjectFileMap files) {
  return growing_files_in_store(documents, context, std::make_shared<const ProjectFileMap>(std::move(files)));
}

resolve::ProjectFiles growing_files_in_store(Documents& documents, const store::RequestContext& context,
                                             const std::shared_ptr<const ProjectFileMap>& map) {
  resolve::ProjectFiles out;
  const auto bytes_of = [&documents, context, map](const char* kind) {
    return [&documents, context, map, kind](const std::string& name) -> Result<std::string> {
      const std::string id = TRY(asset_id_of(*map, name));
      const store::AssetRow asset = TRY(documents.store().asset(context, id));
      if (asset.kind != kind) return wrong_kind(asset, kind, "");
      return documents.store().asset_bytes(context, id);
    };
  };
  out.dxf_text = bytes_of("dxf");
  out.image_bytes = bytes_of("image");
  out.body_mesh = [&documents, context, map](
                      const std::string& name,
                      const mesh_import::MeshSettings& settings) -> Result<mesh_import::RepairedMesh> {
    const std::string id = TRY(asset_id_of(*map, name));
    const std::shared_ptr<const mesh_import::RepairedMesh> mesh =
        TRY(documents.bodies().mesh(documents.store(), context, id, settings));
    return *mesh;
  };
  out.mannequin =
      [&documents](const mannequin::MannequinSettings& settings) -> Result<geometry::TriangleMesh> {
    const std::shared_ptr<const mannequin::Mannequin> made = TRY(documents.mannequins().get(settings));
    return made->mesh;
  };
  return out;
}

}  // namespace toile::documents
