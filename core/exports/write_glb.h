#pragma once
// glTF 2.0 in one binary file (.glb): the draped garment for viewers and other 3D programs.

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/cloth_map.h"
#include "core/base/result.h"
#include "core/base/types.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/image/texture.h"

namespace toile::exports {

/// What goes into the file. The pointed-to arrays must outlive the call.
struct GlbModel {
  const sewing::GarmentMesh* garment = nullptr;  ///< may be null: bodies only
  std::span<const Vec3> positions;               ///< m, one per vertex of the garment
  std::vector<std::string> panel_names;          ///< one per panel
  std::span<const material::Fabric> fabrics;
  std::span<const Index> fabric_of_panel;  ///< index into fabrics, one per panel
  std::span<const body::Body> bodies;
  std::array<double, 3> body_colour{0.55, 0.52, 0.49};  ///< linear RGB, 0 to 1
  const image::Textures* textures = nullptr;            ///< pictures on panels; may be null
  std::span<const analysis::ClothMap> maps{};           ///< of the garment's vertices
};

/// The file's bytes. One node with its mesh per panel that has triangles, named after it, and one per body;
/// POSITION in metres, y up; NORMAL smooth across seams; TEXCOORD_0 of cloth is the flat rest position in
/// metres in the panel's own frame (u, v as drafted, so that a texture repeats in real size), or, of a panel
/// with a picture, where the picture lies; each map as an attribute of its own (MapTrait::attribute), in the
/// map's unit; one double-sided material per fabric, with its linear colour, and one per fabric and picture.
/// Nothing is outside the file, and equal input gives equal bytes. Errors: "export.not_finite",
/// "export.bad_index", "export.bad_garment", "export.too_large" (4 GiB).
Result<std::string> glb_bytes(const GlbModel& model);

/// Writes glb_bytes to `path`. Errors: those, and "export.write".
Status write_glb(const std::filesystem::path& path, const GlbModel& model);

}  // namespace toile::exports
