#include "server/app/send_project.h"

#include <map>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/base/read_file.h"
#include "core/project/project.h"
#include "core/project/resolve/resolve.h"
#include "server/documents/assets.h"
#include "server/documents/used_files.h"

namespace toile::app {

namespace fs = std::filesystem;

Result<std::string> read_upload(const fs::path& path, const std::string& where) {
  std::error_code failure;
  const auto size = fs::is_regular_file(path, failure) ? fs::file_size(path, failure) : 0;
  if (!failure && size > documents::kMostBodyBytes) {
    return Error{"project.too_large", "the file has more than the 100 MiB that are allowed", where,
                 ErrorKind::kTooLarge};
  }
  std::optional<std::string> bytes = read_file(path);
  if (bytes) return std::move(*bytes);
  return Error{"project.file", "cannot read " + in_quotes(path.filename().string()), where};
}

Result<std::string> send_project(Remote& remote, const std::string& path) {
  const std::string document = TRY(resolve::read_project_text(path));
  const project::Project project = TRY(project::parse_project(document));
  std::vector<std::pair<std::string, std::string>> files;
  std::map<std::string, std::string> sent;
  for (const documents::UsedFile& used : documents::used_files(project)) {
    if (sent.contains(used.name)) continue;
    if (Status name = resolve::check_file_name(used.name); !name) return placed_at(name.error(), used.where);
    const std::string bytes = TRY(read_upload(fs::path(path).parent_path() / used.name, used.where));
    const std::string id = TRY(remote.upload(used.kind, fs::path(used.name).filename().string(), bytes));
    sent[used.name] = id;
    files.emplace_back(used.name, id);
  }
  return remote.create_project(document, files);
}

}  // namespace toile::app
