#include "server/app/config.h"

#include <unistd.h>

#include <algorithm>
#include <system_error>
#include <thread>

namespace toile::app {

namespace fs = std::filesystem;

ServeOptions completed(ServeOptions options) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  if (!options.log) options.log = ::isatty(2) != 0 ? log::LogFormat::kText : log::LogFormat::kJson;
  if (options.workers == 0) options.workers = std::clamp(cores, 1, kMostWorkers);
  if (options.web.empty()) options.web = shipped_folder("web/dist").string();
  if (options.no_sample) options.sample.clear();
  if (options.sample.empty() && !options.no_sample) options.sample = shipped_folder("samples/skirt").string();
  return options;
}

fs::path shipped_folder(const std::string& relative) {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure).parent_path();
  for (const fs::path& base : {fs::path("."), program / "../..", program / "../share/toile"}) {
    fs::path folder = (base / relative).lexically_normal();
    if (fs::is_directory(folder, failure)) return folder;
  }
  return {};
}

}  // namespace toile::app
