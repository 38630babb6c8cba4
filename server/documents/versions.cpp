#include "server/documents/versions.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/project/project.h"
#include "server/documents/edits.h"

namespace toile::documents {
namespace {

store::Versions& versions_in(Documents& documents) {
  store::Versions* const versions = store::versions_of(documents.store());
  TOILE_CHECK(versions != nullptr);
  return *versions;
}

Status check_name(const std::string& name) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (!name.empty() && name.size() <= kLongestVersionName && trimmed(name) == name &&
      std::none_of(name.begin(), name.end(), is_control))
    return {};
  return Error{"versions.name", "a version is named by 1 to 80 bytes on one line, without blanks around",
               "/name"};
}

}  // namespace

Result<store::VersionRow> name_version(Documents& documents, const store::RequestContext& context,
                                       const std::string& project, const std::string& name, int expected) {
  const store::ProjectRow row = TRY(documents.store().project(context, project));
  TRY(check_name(name));
  if (expected != 0 && expected != row.revision)
    return Error{"store.conflict",
                 "the project has changed since; it is at revision " + std::to_string(row.revision), "",
                 ErrorKind::kStale};
  const std::string line = project::write_project_line(TRY(project::parse_project(row.document)));
  store::VersionRow version;
  version.project_id = row.id;
  version.name = name;
  version.revision = row.revision;
  version.document = row.document;
  if (line != row.document) version.line = line;
  version.files = row.files;
  return versions_in(documents).add_version(context, std::move(version), row.revision);
}

Result<store::ProjectRow> restore_version(Documents& documents, const store::RequestContext& context,
                                          const std::string& project, const std::string& version,
                                          int expected) {
  const store::VersionRow was = TRY(versions_in(documents).version(context, project, version));
  return change_project(
      documents, context, project, expected,
      [&](const project::Project&, ProjectFileMap& files, resolve::OpenedFiles&) -> Result<project::Project> {
        for (const auto& [name, id] : was.files) {
          const auto [at, fresh] = files.emplace(name, id);
          if (!fresh && at->second != id)
            return Error{"documents.file_taken",
                         "the project has another file of the name " + name +
                             " by now; make a new project of the drape that you want back",
                         "files: " + name, ErrorKind::kConflict};
        }
        return project::parse_project(was.document);
      });
}

}  // namespace toile::documents
