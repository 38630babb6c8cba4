#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::mesh_import {

struct MeshSettings {
  /// m per unit of the file; 0: by the greatest extent e of the mesh. A person or a table is 0.3 to 5 m big,
  /// so e < 5 means metres, e < 50 decimetres, e < 500 centimetres, more millimetres.
  double unit_in_m = 0;
  bool z_up = false;  ///< the file's z points up: turned so that y does
  /// Takes every format that assimp knows by its ending, not only those whose opening we look at first
  /// (core/body/mesh_import/formats.h): for a process that may crash (core/body/mesh_import/import.h).
  bool any_format = false;
};

/// Every triangle of a mesh file (of any of mesh_formats()), metres, y up: the scene's
/// meshes in their places, polygons cut into triangles, equal positions merged, so that a surface that was
/// closed is closed here, and triangles without area removed. Vertices are numbered as they first appear.
/// Files that this one names (materials of an OBJ, buffers of a glTF) are opened too.
///
/// Assimp keeps coordinates as 32-bit floats: seven digits, 0.1 µm on a body in metres.
///
/// Errors, with the file as place: "mesh.not_found", "mesh.empty", "mesh.too_large" (over 256 MiB or 2
/// million triangles), "mesh.huge_face" (over 1,000 corners), "mesh.memory", "mesh.unreadable",
/// "mesh.no_triangles", "mesh.not_finite" (place with the vertex), "mesh.setting".
Result<geometry::TriangleMesh> load_mesh(const std::filesystem::path& path,
                                         const MeshSettings& settings = {});

/// The same of a file's bytes, whose name tells the format. Opens nothing: for what strangers upload, who
/// could otherwise have any file of the machine read as coordinates.
Result<geometry::TriangleMesh> load_mesh_bytes(const std::string& name, std::string_view bytes,
                                               const MeshSettings& settings = {});

/// Of a mesh file.
inline constexpr std::size_t kMostMeshBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMostMeshTriangles = 2'000'000;

}  // namespace toile::mesh_import
