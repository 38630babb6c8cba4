#pragma once
// What a still shows. Views only: the arrays stay with their owner and must outlive the call.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/aabb.h"
#include "core/base/result.h"
#include "core/base/types.h"
#include "core/body/body.h"
#include "core/image/texture.h"
#include "server/render/cloth_look.h"

namespace toile::render {

using LinearRgb = std::array<double, 3>;  ///< linear light, 0 to 1

/// A garment. Its arrays are GarmentMesh's.
struct ClothView {
  std::span<const Vec3> positions;  ///< m
  std::span<const Tri> triangles;
  std::span<const Index> panel_of_triangle;   ///< one per triangle; may be empty: all panel 0
  std::span<const Index> weld;                ///< one per vertex: least sewn vertex; may be empty
  std::vector<LinearRgb> colour_of_panel;     ///< one per panel; panels past its end take kClothColour
  std::span<const Vec2> rest;                 ///< m, one per vertex, carries weave and pictures; may be empty
  const image::Textures* textures = nullptr;  ///< pictures on panels; may be null
  std::vector<ClothLook> look_of_panel{};     ///< as colours; past its end the default
  std::vector<LinearRgb> colour_of_vertex{};  ///< in place of panels' colours; empty: those
};

inline constexpr LinearRgb kClothColour{0.30, 0.40, 0.55};
inline constexpr LinearRgb kMannequinColour{0.56, 0.52, 0.48};

struct BodyView {
  const geometry::TriangleMesh* mesh = nullptr;
  LinearRgb colour = kMannequinColour;
};

struct Scene {
  ClothView cloth;  ///< may be empty
  std::vector<BodyView> bodies;
  std::optional<double> floor;  ///< m, height of the ground; without it, the lowest point of all
};

/// Around what of the cloth is drawn, m; empty without cloth.
Aabb3 cloth_box(const Scene& scene);
/// How a panel looks.
ClothLook look_of(const ClothView& cloth, Index panel);

/// Of the cloth and all bodies.
Aabb3 whole_box(const Scene& scene);

/// Height of the ground, m; 0 for an empty scene.
double floor_height(const Scene& scene);

/// Whether the scene can be drawn. Errors: "render.not_finite", "render.too_far" (more than 1 km from the
/// origin), "render.bad_index", "render.bad_scene" (arrays of different lengths), each with the place.
Status check_scene(const Scene& scene);

}  // namespace toile::render
