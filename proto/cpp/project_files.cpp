// The files of a project folder on disk.

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/pattern/dxf_read.h"
#include "proto/cpp/json_codec.h"
#include "proto/cpp/names.h"
#include "proto/cpp/project_pieces.h"
#include "proto/cpp/project_resolve.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

Error no_file(const fs::path& path, const std::string& reason) {
  return Error{"project.file", "cannot read " + in_quotes(path.filename().string()) + ": " + reason,
               clipped(path.string(), 300)};
}

/// The bytes of a regular file of at most `limit` bytes. A device or a pipe could go on for ever and is
/// refused.
Result<std::string> bytes_of(const fs::path& path, std::size_t limit, const char* too_large) {
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
  if (bytes.size() > limit) {
    return Error{too_large,
                 "the file has more than the " + std::to_string(limit >> 20) + " MiB that are allowed",
                 clipped(path.string(), 300)};
  }
  return bytes;
}

}  // namespace

ProjectFiles files_in(const fs::path& folder) {
  ProjectFiles files;
  files.dxf_text = [folder](const std::string& name) {
    return bytes_of(folder / name, DxfSettings{}.max_bytes, "project.too_large");
  };
  files.body_mesh = [folder](const std::string& name, const MeshSettings& settings) {
    return load_mesh(folder / name, settings);
  };
  return files;
}

Result<std::string> read_project_text(const fs::path& path) {
  return bytes_of(path, JsonLimits{}.bytes, "json.too_large");
}

Result<DrapeInput> read_project(const fs::path& path) {
  const Result<std::string> text = read_project_text(path);
  if (!text) return text.error();
  const Result<Project> project = parse_project(*text);
  if (!project) return error_at(clipped(path.string(), 300), project.error());
  Result<DrapeInput> input = resolve_project(*project, files_in(path.parent_path()));
  if (!input) return error_at(clipped(path.string(), 300), input.error());
  return input;
}

}  // namespace toile
