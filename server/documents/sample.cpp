// The project that a new store begins with.

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "proto/cpp/names.h"
#include "proto/cpp/project.h"
#include "server/documents/assets.h"
#include "server/documents/projects.h"
#include "server/documents/used_files.h"

namespace toile {
namespace {

Result<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.good() || in.eof()) return bytes;
  return Error{"project.file", "cannot read the sample's file " + in_quotes(path.filename().string()),
               path.string()};
}

/// The project with this very document, when a start was cut off between adding it and remembering that.
Result<std::optional<std::string>> added_before(Store& store, const OwnerId& owner,
                                                const std::string& document) {
  constexpr int kPage = 100;
  std::string cursor;
  for (;;) {
    const Result<std::vector<ProjectRow>> page = store.projects(owner, cursor, kPage);
    if (!page) return page.error();
    for (const ProjectRow& row : *page) {
      if (row.document == document) return std::optional(row.id);
    }
    if (page->size() < kPage) return std::optional<std::string>();
    cursor = page->back().id;
  }
}

Result<std::string> add(Store& store, const OwnerId& owner, const std::filesystem::path& folder,
                        const std::string& document) {
  const Result<Project> project = parse_project(document);
  if (!project) return project.error();
  ProjectFileMap files;
  for (const UsedFile& used : used_files(*project)) {
    if (files.contains(used.name)) continue;
    const Result<std::string> bytes = read_file(folder / used.name);
    if (!bytes) return bytes.error();
    const std::string name = std::filesystem::path(used.name).filename().string();
    const Result<AssetRow> asset = add_asset(store, owner, used.kind, name, *bytes);
    if (!asset) return asset.error();
    files[used.name] = asset->id;
  }
  const Result<Made<ProjectRow>> row = create_project(store, owner, document, files);
  if (!row) return row.error();
  return row->id;
}

}  // namespace

Status add_sample_project(Store& store, const OwnerId& owner, const std::filesystem::path& folder) {
  const Result<std::optional<std::string>> known = store.get_setting(owner, kSampleSetting);
  if (!known) return known.error();
  if (*known) return {};
  const Result<std::string> document = read_project_text(folder / "project.json");
  if (!document) return document.error();
  const Result<std::optional<std::string>> before = added_before(store, owner, *document);
  if (!before) return before.error();
  const Result<std::string> id =
      *before ? Result<std::string>(**before) : add(store, owner, folder, *document);
  if (!id) return id.error();
  return store.put_setting(owner, kSampleSetting, *id);
}

}  // namespace toile
