// The project that a new store begins with.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/names.h"
#include "core/base/read_file.h"
#include "core/project/project.h"
#include "server/documents/assets.h"
#include "server/documents/projects.h"
#include "server/documents/used_files.h"

namespace toile::documents {
namespace {

Result<std::string> read_sample(const std::filesystem::path& path) {
  if (auto bytes = read_file(path)) return std::move(*bytes);
  return Error{"project.file", "cannot read the sample's file " + in_quotes(path.filename().string()),
               path.string()};
}

/// The project with this very document, when a start was cut off between adding it and remembering that.
Result<std::optional<std::string>> added_before(Documents& documents, const store::RequestContext& context,
                                                const std::string& document) {
  constexpr int kPage = 100;
  std::string cursor;
  for (;;) {
    const std::vector<store::ProjectRow> page = TRY(documents.store().projects(context, cursor, kPage));
    for (const store::ProjectRow& row : page) {
      if (row.document == document) return std::optional(row.id);
    }
    if (page.size() < kPage) return std::optional<std::string>();
    cursor = page.back().id;
  }
}

Result<std::string> add(Documents& documents, const store::RequestContext& context,
                        const std::filesystem::path& folder, const std::string& document) {
  const project::Project project = TRY(project::parse_project(document));
  ProjectFileMap files;
  for (const UsedFile& used : used_files(project)) {
    if (files.contains(used.name)) continue;
    const std::string bytes = TRY(read_sample(folder / used.name));
    const std::string name = std::filesystem::path(used.name).filename().string();
    const store::AssetRow asset = TRY(add_asset(documents, context, used.kind, name, bytes));
    files[used.name] = asset.id;
  }
  const store::Made<store::ProjectRow> row = TRY(create_project(documents, context, document, files));
  return row.id;
}

}  // namespace

Status add_sample_project(Documents& documents, const store::RequestContext& context,
                          const std::filesystem::path& folder) {
  const std::optional<std::string> known = TRY(documents.store().get_setting(context, kSampleSetting));
  if (known) return {};
  const std::string document = TRY(resolve::read_project_text(folder / "project.json"));
  const std::optional<std::string> before = TRY(added_before(documents, context, document));
  const std::string id =
      TRY(before ? Result<std::string>(*before) : add(documents, context, folder, document));
  return documents.store().put_setting(context, kSampleSetting, id);
}

}  // namespace toile::documents
