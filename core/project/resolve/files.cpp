#include "core/project/resolve/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/base/names.h"
#include "core/image/read_picture.h"
#include "core/json/tree.h"
#include "core/pattern/dxf/read.h"

namespace toile::resolve {
namespace {

namespace fs = std::filesystem;

Error no_file(const fs::path& path, const std::string& reason) {
  return Error{"project.file", "cannot read " + in_quotes(path.filename().string()) + ": " + reason,
               clipped(path.string(), 300)};
}

/// A body has a few thousand triangles, a scan half a million; a file beyond this would take many seconds to
/// read before it turns out to be of no use.
constexpr std::uintmax_t kMostBodyBytes = std::uintmax_t{32} << 20;

Error too_large(const fs::path& path, const char* code, std::uintmax_t limit) {
  return Error{code, "the file has more than the " + std::to_string(limit >> 20) + " MiB that are allowed",
               clipped(path.string(), 300), ErrorKind::kTooLarge};
}

/// The bytes of a regular file of at most `limit` bytes. A device or a pipe could go on for ever and is
/// refused.
Result<std::string> bytes_of(const fs::path& path, std::size_t limit, const char* code) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) return no_file(path, "there is no such file");
  if (!fs::is_regular_file(status)) return no_file(path, "this is no file");
  std::ifstream in(path, std::ios::binary);
  if (!in) return no_file(path, std::strerror(errno));
  std::string bytes;
  constexpr std::size_t kChunk = std::size_t{1} << 20;
  while (in && bytes.size() <= limit) {
    const std::size_t had = bytes.size();
    bytes.resize(had + std::min(kChunk, limit + 1 - had));
    in.read(bytes.data() + had, static_cast<std::streamsize>(bytes.size() - had));
    bytes.resize(had + static_cast<std::size_t>(in.gcount()));
  }
  if (bytes.size() > limit) return too_large(path, code, limit);
  return bytes;
}

}  // namespace

Status check_file_name(const std::string& name) {
  const auto refused = [&](const char* reason) {
    return Error{"project.path", "the file name " + in_quotes(name) + " " + reason, ""};
  };
  if (name.empty()) return refused("is empty");
  if (std::any_of(name.begin(), name.end(), [](char c) { return c >= 0 && c < 0x20; })) {
    return refused("has a control character in it");
  }
  if (name.find('\\') != std::string::npos) return refused("has a \\ in it; write / between folders");
  if (name.front() == '/' || (name.size() > 1 && name[1] == ':')) {
    return refused("is absolute; a document names files in its own folder or below");
  }
  const std::filesystem::path path(name);
  for (const std::filesystem::path& part : path) {
    if (part == "..") return refused("leaves the document's folder");
  }
  return {};
}

ProjectFiles files_in(const fs::path& folder, const mesh_import::MeshImporter& importer) {
  ProjectFiles files;
  files.dxf_text = [folder](const std::string& name) {
    return bytes_of(folder / name, dxf::DxfSettings{}.max_bytes, "project.too_large");
  };
  files.body_mesh = [folder, importer](
                        const std::string& name,
                        const mesh_import::MeshSettings& settings) -> Result<mesh_import::RepairedMesh> {
    const fs::path path = folder / name;
    std::error_code failure;
    const std::uintmax_t bytes = fs::file_size(path, failure);
    if (!failure && bytes > kMostBodyBytes) return too_large(path, "project.too_large", kMostBodyBytes);
    return importer.file(path, settings);
  };
  files.image_bytes = [folder](const std::string& name) -> Result<std::string> {
    TRY(check_file_name(name));
    return bytes_of(folder / name, image::PictureLimits{}.bytes, "image.too_large");
  };
  return files;
}

Result<std::string> read_project_text(const fs::path& path) {
  return bytes_of(path, json::JsonLimits{}.bytes, "json.too_large");
}

}  // namespace toile::resolve
