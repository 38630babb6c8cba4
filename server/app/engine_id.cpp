#include "server/app/engine_id.h"

#include <string_view>

#include "core/base/hash.h"
#include "core/base/read_file.h"

namespace toile::app {

std::string engine_of_this_program() {
  const std::optional<std::string> bytes = read_file("/proc/self/exe");
  return bytes ? hash_of(std::string_view(*bytes)) : std::string();
}

}  // namespace toile::app
