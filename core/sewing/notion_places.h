#pragma once
// Where a garment's notions are on its mesh.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/panel_mesh.h"
#include "core/sewing/garment_mesh.h"
#include "core/sewing/notions.h"

namespace toile::sewing {

/// A point on a triangle: weights, summing to 1, of three vertices.
struct ClothPoint {
  Tri v{kNone, kNone, kNone};
  std::array<double, 3> share{};
};

Vec3 position_of(const ClothPoint& point, std::span<const Vec3> x);

/// The point of a panel's mesh at a flat place (m); nothing where that lies more than a tenth of the mean
/// edge beside the mesh. `first` is the panel's first vertex in the garment.
std::optional<ClothPoint> locate_point(const mesh::PanelMesh& mesh, Index first, Vec2 at);

/// Chains of vertices: one a line or an edge, from its start to its end.
using VertexChains = std::vector<std::vector<Index>>;

/// In the garment's own vertices, one entry for each of its notions.
struct NotionPlaces {
  std::vector<std::array<ClothPoint, 2>> buttons;
  std::vector<VertexChains> elastics;
  std::vector<VertexChains> creases;
};

/// Errors, `where` naming the notion: "button.off_piece" where a point lies more than a tenth of the mean
/// edge beside its panel's mesh.
Result<NotionPlaces> locate_notions(const Notions& notions, const mesh::PanelMeshes& meshes,
                                    const GarmentMesh& garment);

}  // namespace toile::sewing
