#pragma once
// Wavefront OBJ: plain triangles for other programs and for checking a drape from outside.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"

namespace toile::exports {

/// How triangles fall into named objects. Without names the file has `v` and `f` lines only.
struct ObjPanels {
  std::vector<std::string> names;            ///< one per panel; blanks become "_"
  std::span<const Index> panel_of_triangle;  ///< one per triangle, index into names
  /// Flat places of the vertices, m, written as texture coordinates (`vt`, faces `v/vt`); empty: none.
  std::span<const Vec2> rest = {};
};

/// Writes `positions` (m, 9 significant decimals, in their order) and `triangles` (counted from 1 in the
/// file); with panels, one `o` object per panel that has triangles, in the order of the panels. Errors:
/// "export.not_finite", "export.bad_index", "export.write".
Status write_obj(const std::filesystem::path& path, std::span<const Vec3> positions,
                 std::span<const Tri> triangles, const ObjPanels& panels = {});

/// Writes into `directory`, which is made if need be, what a program that is not Toile needs to judge a
/// drape:
/// - rest.obj: the flat pieces, m, z = 0, side by side along x without overlap
/// - final.obj: the same vertices and triangles in the same order, at `positions` (m), with `panels` as
///   write_obj takes them
/// - body.obj: all bodies as one mesh
/// - sewn.json: [[i, j], …], the sewn pairs of vertices, counted from 0
/// Errors: as write_obj, and "export.bad_garment" when arrays of the garment disagree in length.
Status write_check_data(const std::filesystem::path& directory, const sewing::GarmentMesh& garment,
                        std::span<const Vec3> positions, std::span<const body::Body> bodies,
                        const ObjPanels& panels = {});

}  // namespace toile::exports
