#pragma once
// What the reader of a mesh sends its caller through a pipe: a mesh with its repairs, or an error.

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/body/mesh_import/repair.h"

namespace toile::mesh_import {

/// "TOILEMSH", u32 kind (0: error, 1: mesh); then, for an error, three texts (u32 length, bytes); for a mesh
/// the repairs (u32 each, in the struct's order), u32 vertices, u32 triangles, 3 doubles a vertex, 3 u32 a
/// triangle. Little-endian.
std::string mesh_message(const Result<RepairedMesh>& mesh);

/// The message read back, trusting nothing: sizes must fit, coordinates be numbers, corners be vertices.
/// Error: "mesh.crashed" where it is no whole message; else the error sent, its texts cut to a sensible
/// length.
Result<RepairedMesh> parse_mesh_message(std::string_view bytes);

}  // namespace toile::mesh_import
