#include "server/app/pattern_bytes.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace toile::app {

Result<std::string> pattern_bytes(const std::string& path) {
  constexpr std::uintmax_t kMost = std::uintmax_t{64} << 20;
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) return Error{"pattern.file", "there is no such file", path};
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(status) || !in)
    return Error{"pattern.file", "this is no file that can be read", path};
  if (std::filesystem::file_size(path, failure) > kMost || failure)
    return Error{"pattern.too_large", "a pattern file has at most 64 MiB", path, ErrorKind::kTooLarge};
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) return Error{"pattern.file", "this is no file that can be read", path};
  return bytes;
}

}  // namespace toile::app
