#include "core/body/mesh_import/sniff.h"

#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "core/body/mesh_import/formats.h"

namespace toile::mesh_import {
namespace {

FileOpening open(const std::filesystem::path& path) {
  FileOpening o;
  std::error_code error;
  o.size = std::filesystem::file_size(path, error);
  o.bytes.resize(kLookAt);
  std::ifstream file(path, std::ios::binary);
  file.read(o.bytes.data(), static_cast<std::streamsize>(o.bytes.size()));
  o.bytes.resize(static_cast<std::size_t>(file.gcount()));
  return o;
}

/// "OBJ, STL and OFF".
std::string format_names() {
  std::string names;
  const std::span<const MeshFormat> formats = mesh_formats();
  for (std::size_t i = 0; i < formats.size(); ++i) {
    if (i > 0) names += i + 1 < formats.size() ? ", " : " and ";
    names += formats[i].name;
  }
  return names;
}

Status sniff(const std::string& name, bool any_format, const FileOpening& opening) {
  const MeshFormat* const format = format_of_name(name);
  if (format == nullptr) {
    if (any_format) return {};
    return Error{"mesh.unreadable", "Meshes are read from " + format_names() + " files.", name};
  }
  if (format->begins(opening) || (any_format && is_utf16(opening))) return {};
  return Error{
      "mesh.unreadable",
      std::string("The file does not begin as a ") + format->ending + " file should, or its header lies.",
      name};
}

}  // namespace

Status sniff_mesh(const std::filesystem::path& path, bool any_format) {
  return sniff(path.string(), any_format, open(path));
}

Status sniff_mesh_bytes(const std::string& name, std::string_view bytes, bool any_format) {
  return sniff(name, any_format, {std::string(bytes.substr(0, kLookAt)), bytes.size()});
}

}  // namespace toile::mesh_import
