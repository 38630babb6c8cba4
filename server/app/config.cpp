#include "server/app/config.h"

#include <unistd.h>

#include <algorithm>
#include <system_error>
#include <thread>

namespace toile::app {

namespace fs = std::filesystem;

int usual_workers() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMostWorkers);
}

log::LogFormat usual_log() { return ::isatty(2) != 0 ? log::LogFormat::kText : log::LogFormat::kJson; }

ServeOptions completed(ServeOptions options) {
  if (!options.log) options.log = usual_log();
  if (options.workers == 0) options.workers = usual_workers();
  if (options.no_workers) options.workers = 0;
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
