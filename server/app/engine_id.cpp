#include "server/app/engine_id.h"

#include <fstream>
#include <iterator>
#include <string_view>

#include "core/base/hash.h"

namespace toile::app {

std::string engine_of_this_program() {
  std::ifstream in("/proc/self/exe", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return in.is_open() && !in.bad() ? hash_of(std::string_view(bytes)) : std::string();
}

}  // namespace toile::app
