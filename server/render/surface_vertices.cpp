#include "server/render/surface_vertices.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/mesh/vertex_normals.h"
#include "server/render/panel_make.h"

namespace toile::render {
namespace {

void set(float (&out)[3], Vec3 v) {
  out[0] = static_cast<float>(v.x);
  out[1] = static_cast<float>(v.y);
  out[2] = static_cast<float>(v.z);
}

/// The picture on a panel, or null.
const image::PanelTexture* texture_on(const ClothView& cloth, Index panel) {
  if (cloth.textures == nullptr || cloth.rest.empty()) return nullptr;
  return image::texture_of(*cloth.textures, panel);
}

Index image_on(const ClothView& cloth, Index panel) {
  const image::PanelTexture* const texture = texture_on(cloth, panel);
  return texture == nullptr ? kNone : texture->image;
}

std::vector<std::size_t> drawing_order(const ClothView& cloth) {
  std::vector<std::size_t> order(cloth.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t t) {
    const Index panel = panel_of(cloth, t);
    return std::pair{image_on(cloth, panel), panel};
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

LinearRgb colour_of(const ClothView& cloth, Index panel) {
  const bool known = panel >= 0 && static_cast<std::size_t>(panel) < cloth.colour_of_panel.size();
  return known ? cloth.colour_of_panel[static_cast<std::size_t>(panel)] : kClothColour;
}

class SurfaceMaker {
 public:
  explicit SurfaceMaker(const ClothView& cloth)
      : cloth_(cloth),
        normals_(mesh::vertex_normals(cloth.positions, cloth.triangles, cloth.weld)),
        makes_(panel_makes(cloth)),
        lines_(cloth),
        made_(cloth.positions.size(), {kNone, kNone}) {}

  ClothSurface make() {
    for (const std::size_t t : drawing_order(cloth_)) {
      const Index panel = panel_of(cloth_, t);
      const Index image = image_on(cloth_, panel);
      const ClothLook look = look_of(cloth_, panel);
      if (surface_.runs.empty() || surface_.runs.back().image != image || surface_.runs.back().look != look)
        surface_.runs.push_back({image, look, static_cast<int>(3 * surface_.triangles.size()), 0});
      surface_.runs.back().count += 3;
      Tri corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = vertex(cloth_.triangles[t][i], panel);
      surface_.triangles.push_back(corners);
    }
    return std::move(surface_);
  }

 private:
  /// A vertex is made where its panel is not the one that it was made for last.
  Index vertex(Index v, Index panel) {
    Made& made = made_[static_cast<std::size_t>(v)];
    if (made.vertex != kNone && made.panel == panel) return made.vertex;
    made = {static_cast<Index>(surface_.vertices.size()), panel};
    surface_.vertices.push_back(corner(v, panel));
    return made.vertex;
  }

  ClothVertex corner(Index v, Index panel) const {
    ClothVertex out{};
    set(out.position, cloth_.positions[v]);
    set(out.normal, normals_[v]);
    const LinearRgb colour = cloth_.colour_of_vertex.empty()
                                 ? colour_of(cloth_, panel)
                                 : cloth_.colour_of_vertex[static_cast<std::size_t>(v)];
    set(out.colour, {colour[0], colour[1], colour[2]});
    const Vec2 rest = cloth_.rest.empty() ? Vec2{} : cloth_.rest[v];
    out.rest[0] = static_cast<float>(rest.x);
    out.rest[1] = static_cast<float>(rest.y);
    out.lines = lines_.at(v, panel);
    const PanelMake& make = makes_[static_cast<std::size_t>(std::max(panel, 0))];
    set(out.make, {make.thickness, make.hem, make.stitched_beside});
    const image::PanelTexture* const texture = texture_on(cloth_, panel);
    const Vec2 repeats = texture == nullptr ? Vec2{} : image::texture_at(*texture, rest);
    out.picture_at[0] = static_cast<float>(repeats.x);
    out.picture_at[1] = static_cast<float>(1 - repeats.y);
    return out;
  }

  struct Made {
    Index vertex = kNone, panel = kNone;
  };
  const ClothView& cloth_;
  std::vector<Vec3> normals_;
  std::vector<PanelMake> makes_;
  LineMeasure lines_;
  std::vector<Made> made_;
  ClothSurface surface_;
};

}  // namespace

ClothSurface cloth_surface(const ClothView& cloth) { return SurfaceMaker(cloth).make(); }

std::vector<BodyVertex> body_vertices(const geometry::TriangleMesh& mesh) {
  const std::vector<Vec3> normals = mesh::vertex_normals(mesh.vertices, mesh.triangles);
  std::vector<BodyVertex> out(mesh.vertices.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    set(out[v].position, mesh.vertices[v]);
    set(out[v].normal, normals[v]);
  }
  return out;
}

}  // namespace toile::render
