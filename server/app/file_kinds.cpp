#include "server/app/file_kinds.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "core/base/names.h"
#include "core/base/text.h"
#include "core/body/mannequin/proportions.h"
#include "core/body/mesh_import/formats.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const std::string& path) { return lower_case(fs::path(path).extension().string()); }

bool is_mesh(const std::string& path) { return mesh_import::format_of_name(path) != nullptr; }

/// Drawings that other programs make of patterns.
bool is_picture(const std::string& path) {
  constexpr std::array<std::string_view, 6> kEndings{".svg", ".pdf", ".ai", ".eps", ".png", ".jpg"};
  return std::find(kEndings.begin(), kEndings.end(), ending_of(path)) != kEndings.end();
}

std::string quoted_name(const std::string& path) { return in_quotes(fs::path(path).filename().string()); }

}  // namespace

std::string not_a_project(const std::string& path) {
  const std::string make =
      " toile project new --pattern shirt.dxf --body body.obj --out project.json makes one";
  if (ending_of(path) == ".dxf") return quoted_name(path) + " is a pattern, and this takes a project;" + make;
  if (is_mesh(path)) return quoted_name(path) + " is a mesh, and this takes a project;" + make;
  if (is_picture(path)) return quoted_name(path) + " is a picture, and this takes a project;" + make;
  return "";
}

std::string not_a_pattern(const std::string& path) {
  const std::string read =
      "; patterns are read from DXF (AAMA, ASTM or plain) and from GarmentCode specifications (JSON)";
  if (is_mesh(path)) return quoted_name(path) + " is a mesh, as a body is" + read;
  if (is_picture(path)) return quoted_name(path) + " is no pattern that can be read" + read;
  return "";
}

std::string not_a_body(const std::string& path) {
  if (ending_of(path) == ".dxf" || ending_of(path) == ".json")
    return quoted_name(path) + " is a pattern, and a body is a mesh, such as body.obj";
  if (is_picture(path)) return quoted_name(path) + " is a picture, and a body is a mesh, such as body.obj";
  std::error_code ignored;
  if (mannequin::find_preset(path) == nullptr || fs::exists(path, ignored)) return "";
  return "there is no such file; to have one of the size " + path + ": toile body make --preset " + path +
         " --out " + path + ".obj";
}

}  // namespace toile::app
