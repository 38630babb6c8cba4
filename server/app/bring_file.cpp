#include "server/app/bring_file.h"

#include <optional>
#include <system_error>

#include "core/base/read_file.h"
#include "core/base/write_file.h"

namespace toile::app {

namespace fs = std::filesystem;

Status bring_file(const fs::path& file, const fs::path& folder, const std::string& name) {
  std::error_code failure;
  const fs::path there = folder / (name.empty() ? file.filename() : fs::path(name));
  if (fs::equivalent(file, there, failure)) return {};
  fs::create_directories(there.parent_path(), failure);
  const std::optional<std::string> bytes = read_file(file);
  if (!bytes)
    return Error{"export.write", "the file cannot be copied here: " + file.string() + " cannot be read",
                 there.string(), ErrorKind::kInternal};
  return write_file(there, *bytes);  // who reads it meanwhile finds the old one or the new one whole
}

}  // namespace toile::app
