#include "server/app/bring_file.h"

#include <system_error>

namespace toile::app {

namespace fs = std::filesystem;

Status bring_file(const fs::path& file, const fs::path& folder, const std::string& name) {
  std::error_code failure;
  const fs::path there = folder / (name.empty() ? file.filename() : fs::path(name));
  if (fs::equivalent(file, there, failure)) return {};
  fs::create_directories(there.parent_path(), failure);
  fs::copy_file(file, there, fs::copy_options::overwrite_existing, failure);
  if (!failure) return {};
  return Error{"export.write", "the file cannot be copied here: " + failure.message(), there.string(),
               ErrorKind::kInternal};
}

}  // namespace toile::app
