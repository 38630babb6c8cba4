#pragma once
// The mesh formats that bodies come in. The reader, the service and its page all go by this one table.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace toile::mesh_import {

/// How a file begins: its first bytes, kLookAt of them at most, and its size.
struct FileOpening {
  std::string bytes;
  std::uintmax_t size = 0;
};

/// Bytes to look at; longer than any honest header.
inline constexpr std::size_t kLookAt = 64 << 10;

struct MeshFormat {
  const char* ending;                     ///< of the file's name, lower case, with its point
  const char* name;                       ///< as people call it
  bool (*begins)(const FileOpening& of);  ///< whether a file of this format may begin so
};

/// All of them, in the order in which people are told.
std::span<const MeshFormat> mesh_formats();

/// By the ending of a file's name, in capitals or not; null when there is none.
const MeshFormat* format_of_name(const std::string& file_name);

/// Text of two bytes a character, which assimp turns into what it knows.
bool is_utf16(const FileOpening& opening);

}  // namespace toile::mesh_import
