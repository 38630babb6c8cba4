#include "core/body/mesh_import/formats.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

#include "core/base/text.h"

namespace toile::mesh_import {
namespace {

bool starts(const FileOpening& o, std::string_view with) { return o.bytes.starts_with(with); }

bool is_text(const FileOpening& o) {
  return o.bytes.find('\0') == std::string::npos &&
         (o.bytes.size() < kLookAt || o.bytes.find('\n') != std::string::npos);
}

// Binary: 80 bytes, a count, 50 bytes each.
bool is_stl(const FileOpening& o) {
  if (o.size >= 84 && o.bytes.size() >= 84) {
    std::uintmax_t count = 0;
    for (std::size_t i = 84; i-- > 80;) count = count * 256 + static_cast<unsigned char>(o.bytes[i]);
    if (o.size == 84 + 50 * count && count > 0) return true;
  }
  return is_text(o) && o.bytes.find("solid") != std::string::npos &&
         o.bytes.find("facet") != std::string::npos;
}

// A header that ends, and that counts no more elements than the file has bytes.
bool is_ply(const FileOpening& o) {
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

bool is_glb(const FileOpening& o) { return starts(o, "glTF"); }
bool is_fbx(const FileOpening& o) { return starts(o, "Kaydara FBX Binary") || is_text(o); }
bool is_3ds(const FileOpening& o) { return starts(o, "MM"); }

// A line more is a format more, as far as assimp reads it.
constexpr std::array<MeshFormat, 9> kFormats{{{".obj", "OBJ", is_text},
                                              {".stl", "STL", is_stl},
                                              {".ply", "PLY", is_ply},
                                              {".gltf", "glTF", is_text},
                                              {".glb", "GLB", is_glb},
                                              {".fbx", "FBX", is_fbx},
                                              {".dae", "DAE", is_text},
                                              {".3ds", "3DS", is_3ds},
                                              {".off", "OFF", is_text}}};

}  // namespace

std::span<const MeshFormat> mesh_formats() { return kFormats; }

const MeshFormat* format_of_name(const std::string& file_name) {
  const std::string ending = lower_case(std::filesystem::path(file_name).extension().string());
  const auto found =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const MeshFormat& f) { return f.ending == ending; });
  return found == kFormats.end() ? nullptr : &*found;
}

bool is_utf16(const FileOpening& o) { return starts(o, "\xff\xfe") || starts(o, "\xfe\xff"); }

}  // namespace toile::mesh_import
