#include "core/body/mesh_import/sniff.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace toile {
namespace {

constexpr std::size_t kLookAt = 64 << 10;  // bytes; longer than any honest header

struct Opening {
  std::string bytes;        ///< the first kLookAt
  std::uintmax_t size = 0;  ///< of the file
};

Opening open(const std::filesystem::path& path) {
  Opening o;
  std::error_code error;
  o.size = std::filesystem::file_size(path, error);
  o.bytes.resize(kLookAt);
  std::ifstream file(path, std::ios::binary);
  file.read(o.bytes.data(), static_cast<std::streamsize>(o.bytes.size()));
  o.bytes.resize(static_cast<std::size_t>(file.gcount()));
  return o;
}

std::string ending(const std::string& name) {
  std::string e = std::filesystem::path(name).extension().string();
  std::transform(e.begin(), e.end(), e.begin(),
                 [](unsigned char c) { return c < 'A' || c > 'Z' ? c : c + 32; });
  return e;
}

bool starts(const Opening& o, std::string_view with) { return o.bytes.rfind(with, 0) == 0; }

bool is_text(const Opening& o) {
  return o.bytes.find('\0') == std::string::npos &&
         (o.bytes.size() < kLookAt || o.bytes.find('\n') != std::string::npos);
}

// Binary: 80 bytes, a count, 50 bytes each.
bool is_stl(const Opening& o) {
  if (o.size >= 84 && o.bytes.size() >= 84) {
    std::uintmax_t count = 0;
    for (int i = 3; i >= 0; --i) count = count * 256 + static_cast<unsigned char>(o.bytes[80 + i]);
    if (o.size == 84 + 50 * count && count > 0) return true;
  }
  return is_text(o) && o.bytes.find("solid") != std::string::npos &&
         o.bytes.find("facet") != std::string::npos;
}

// A header that ends, and that counts no more elements than the file has bytes.
bool is_ply(const Opening& o) {
  if (!starts(o, "ply")) return false;
  std::istringstream words(o.bytes);
  for (std::string word; words >> word;) {
    if (word == "end_header") return true;
    std::string name;
    std::uintmax_t count = 0;
    if (word == "element" && (!(words >> name >> count) || count > o.size)) return false;
  }
  return false;
}

/// Text of two bytes a character, which assimp turns into what it knows.
bool is_utf16(const Opening& o) { return starts(o, "\xff\xfe") || starts(o, "\xfe\xff"); }

bool fits(const std::string& kind, const Opening& o) {
  if (kind == ".obj" || kind == ".gltf" || kind == ".dae" || kind == ".off") return is_text(o);
  if (kind == ".stl") return is_stl(o);
  if (kind == ".ply") return is_ply(o);
  if (kind == ".glb") return starts(o, "glTF");
  if (kind == ".fbx") return starts(o, "Kaydara FBX Binary") || is_text(o);
  return starts(o, "MM");  // .3ds
}

Status sniff(const std::string& name, bool any_format, const Opening& opening) {
  static constexpr std::array<std::string_view, 9> kKinds{".obj", ".stl", ".ply", ".gltf", ".glb",
                                                          ".fbx", ".dae", ".3ds", ".off"};
  const std::string kind = ending(name);
  if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end()) {
    if (any_format) return {};
    return Error{"mesh.unreadable",
                 "Meshes are read from OBJ, STL, PLY, glTF, GLB, FBX, DAE, 3DS and OFF files.", name};
  }
  if (fits(kind, opening) || (any_format && is_utf16(opening))) return {};
  return Error{"mesh.unreadable",
               "The file does not begin as a " + kind + " file should, or its header lies.", name};
}

}  // namespace

Status sniff_mesh(const std::filesystem::path& path, bool any_format) {
  return sniff(path.string(), any_format, open(path));
}

Status sniff_mesh_bytes(const std::string& name, std::string_view bytes, bool any_format) {
  return sniff(name, any_format, {std::string(bytes.substr(0, kLookAt)), bytes.size()});
}

}  // namespace toile
