#include "core/base/read_file.h"

#include <cstddef>
#include <fstream>
#include <vector>

namespace toile {

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in.is_open()) return std::nullopt;
  std::string bytes;
  std::vector<char> chunk(std::size_t{1} << 16);
  // Not by iterators over the buffer: of a folder these throw instead of failing.
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0)
    bytes.append(chunk.data(), static_cast<std::size_t>(in.gcount()));
  if (in.bad()) return std::nullopt;
  return bytes;
}

}  // namespace toile
