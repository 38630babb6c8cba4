#include "core/project/resolve/opened_files.h"

#include <optional>

#include "core/base/names.h"
#include "core/json/tree.h"
#include "core/project/bodies.h"

namespace toile::resolve {
namespace {

std::optional<double> mm_per_unit(const std::string& unit) {
  if (unit == "mm") return 1;
  if (unit == "cm") return 10;
  if (unit == "inch") return 25.4;
  return std::nullopt;
}

mesh_import::MeshSettings mesh_settings(const project::ProjectBody& given) {
  mesh_import::MeshSettings settings;
  if (given.unit == "m") settings.unit_in_m = 1;
  if (given.unit == "cm") settings.unit_in_m = 1e-2;
  if (given.unit == "mm") settings.unit_in_m = 1e-3;
  settings.z_up = given.up == "z";
  return settings;
}

}  // namespace

/// A graded file is read anew for each of its sizes, but its bytes come once.
Result<const std::string*> OpenedFiles::dxf_text(const std::string& name) {
  if (const auto kept = texts_.find(name); kept != texts_.end()) return &kept->second;
  std::string text = TRY(source_.dxf_text(name));
  return &texts_.emplace(name, std::move(text)).first->second;
}

Result<const dxf::DxfDrawing*> OpenedFiles::drawing(const project::ProjectDxf& from) {
  const Reading key{from.dxf, from.units, from.size, from.layers};
  if (const auto kept = drawings_.find(key); kept != drawings_.end()) return &kept->second;
  TRY(check_file_name(from.dxf));
  const std::string* text = TRY(dxf_text(from.dxf));
  dxf::DxfSettings settings;
  settings.mm_per_unit = mm_per_unit(from.units);
  if (!from.size.empty()) settings.size = from.size;
  for (const auto& [layer, word] : from.layers) settings.layers[layer] = TRY(dxf::role_named(word));
  Result<dxf::DxfDrawing> drawing = dxf::read_dxf(*text, settings);
  if (!drawing) return json::error_at(clipped(from.dxf), drawing.error());
  return &drawings_.emplace(key, std::move(*drawing)).first->second;
}

Result<mesh_import::RepairedMesh> OpenedFiles::body_mesh(const project::ProjectBody& body) {
  const mesh_import::MeshSettings settings = mesh_settings(body);
  const std::tuple key{body.file, settings.unit_in_m, settings.z_up};
  if (const auto kept = meshes_.find(key); kept != meshes_.end()) return kept->second;
  mesh_import::RepairedMesh mesh = TRY(source_.body_mesh(body.file, settings));
  return meshes_.emplace(key, std::move(mesh)).first->second;
}

Result<geometry::TriangleMesh> OpenedFiles::mannequin(const project::ProjectMannequin& given) {
  for (const auto& [made_for, mesh] : mannequins_)
    if (made_for == given) return mesh;
  const mannequin::MannequinSettings settings = TRY(project::mannequin_settings(given));
  if (source_.mannequin) {
    geometry::TriangleMesh mesh = TRY(source_.mannequin(settings));
    return mannequins_.emplace_back(given, std::move(mesh)).second;
  }
  mannequin::Mannequin made = TRY(mannequin::make_mannequin(settings));
  return mannequins_.emplace_back(given, std::move(made.mesh)).second;
}

Result<const mannequin::Mannequin*> OpenedFiles::made_mannequin(const project::ProjectMannequin& given) {
  for (const auto& [made_for, made] : made_)
    if (made_for == given) return &made;
  const mannequin::MannequinSettings settings = TRY(project::mannequin_settings(given));
  return &made_.emplace_back(given, TRY(mannequin::make_mannequin(settings))).second;
}

}  // namespace toile::resolve
