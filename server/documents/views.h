#pragma once
// What a page shows of a project beside the cloth: its flat pieces and its bodies.

#include <optional>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"
#include "core/json/tree.h"
#include "core/project/project.h"
#include "core/project/resolve/resolve.h"
#include "server/documents/read_cloth.h"

namespace toile::documents {

/// {"pieces": [{"id", "fabric", "colour", "grain", "outline", "holes", "edges": [{"id", "points", "curves",
/// "length_mm", "loop"}], "notches": [{"at", "depth_mm", "inwards"}], "lines": [{"id", "points"}]}], "seams":
/// [{…, "length_a_mm", "length_b_mm", "issues": [{"code", "error", "message", "where"}]}]}. Millimetres, y
/// up; points are curves flattened to 0.2 mm, curves their four control points; loop 0 is the outline, 1 the
/// first hole. Outlines counter-clockwise, first point not repeated; colour is linear RGB.
std::string pieces_json(const ReadCloth& read);

/// A piece's picture as pieces_json() has it; null: it has none.
json::JsonValue texture_json(const std::optional<project::ProjectTexture>& texture);

/// Whether a body of it has keyframes; not of what is no document.
bool has_moving_bodies(const std::string& document);

/// All bodies of a project in their places as one mesh, little endian: uint32 vertices, uint32 triangles,
/// float32 x, y, z of each vertex (m, y up), three uint32 a triangle. Errors: json.*,
/// project.*, dxf.*, pattern.*, mesh.*, … as reading the project gives them.
Result<std::string> body_bytes(const std::string& document, const resolve::ProjectFiles& files);
/// The same of meshes that are there.
std::string mesh_bytes(std::span<const geometry::TriangleMesh> meshes);

}  // namespace toile::documents
