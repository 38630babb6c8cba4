#include "server/render/scene.h"

#include <algorithm>
#include <string>

namespace toile::render {
namespace {

constexpr double kFarthest = 1000;  // m; floats still resolve 0.1 mm there

Status check_points(std::span<const Vec3> points, const std::string& owner) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points[i];
    if (!is_finite(p)) {
      return Error{"render.not_finite", "a position is not a finite number; nothing was drawn",
                   owner + " vertex " + std::to_string(i), ErrorKind::kInternal};
    }
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kFarthest) {
      return Error{"render.too_far", "a position is more than 1 km away; positions are metres",
                   owner + " vertex " + std::to_string(i), ErrorKind::kInternal};
    }
  }
  return {};
}

Status check_triangles(std::span<const Tri> triangles, std::size_t vertex_count, const std::string& owner) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Index corner : triangles[t]) {
      if (corner < 0 || static_cast<std::size_t>(corner) >= vertex_count) {
        return Error{"render.bad_index", "a triangle names a vertex that is not there",
                     owner + " triangle " + std::to_string(t), ErrorKind::kInternal};
      }
    }
  }
  return {};
}

Error bad_length(const std::string& which) {
  return {"render.bad_scene", "an array of the cloth has the wrong length", which, ErrorKind::kInternal};
}

Status check_cloth(const ClothView& cloth) {
  const std::size_t count = cloth.positions.size();
  TRY(check_points(cloth.positions, "cloth"));
  TRY(check_triangles(cloth.triangles, count, "cloth"));
  if (!cloth.weld.empty() && cloth.weld.size() != count) return bad_length("weld");
  if (!cloth.rest.empty() && cloth.rest.size() != count) return bad_length("rest");
  if (!cloth.colour_of_vertex.empty() && cloth.colour_of_vertex.size() != count)
    return bad_length("colour_of_vertex");
  if (!cloth.panel_of_triangle.empty() && cloth.panel_of_triangle.size() != cloth.triangles.size()) {
    return bad_length("panel_of_triangle");
  }
  for (std::size_t v = 0; v < cloth.weld.size(); ++v) {
    if (cloth.weld[v] < 0 || static_cast<std::size_t>(cloth.weld[v]) >= count) {
      return Error{"render.bad_index", "a vertex is sewn to one that is not there",
                   "cloth vertex " + std::to_string(v), ErrorKind::kInternal};
    }
  }
  for (std::size_t v = 0; v < cloth.rest.size(); ++v) {
    if (!is_finite(cloth.rest[v])) {
      return Error{"render.not_finite", "a rest position is not a finite number; nothing was drawn",
                   "cloth vertex " + std::to_string(v), ErrorKind::kInternal};
    }
  }
  return {};
}

Status check_textures(const ClothView& cloth) {
  if (cloth.textures == nullptr) return {};
  for (const auto& image : cloth.textures->images) {
    const image::Picture& picture = image->read.picture;
    const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    if (pixels == 0 || picture.rgba.size() != 4 * pixels)
      return Error{"render.bad_scene", "a picture's pixels do not fit its size", image->name,
                   ErrorKind::kInternal};
  }
  for (const std::optional<image::PanelTexture>& texture : cloth.textures->of_panel) {
    if (!texture) continue;
    if (texture->image < 0 || static_cast<std::size_t>(texture->image) >= cloth.textures->images.size())
      return Error{"render.bad_index", "a panel names a picture that is not there", "", ErrorKind::kInternal};
    if (!is_finite(texture->origin) || !is_finite(texture->across) || !is_finite(texture->up))
      return Error{"render.not_finite", "a picture does not lie at finite places; nothing was drawn", "",
                   ErrorKind::kInternal};
  }
  return {};
}

void add_used(Aabb3& box, std::span<const Vec3> positions, std::span<const Tri> triangles) {
  for (const Tri& t : triangles) {
    for (const Index corner : t) box.add(positions[corner]);
  }
}

}  // namespace

ClothLook look_of(const ClothView& cloth, Index panel) {
  const bool known = panel >= 0 && static_cast<std::size_t>(panel) < cloth.look_of_panel.size();
  return known ? cloth.look_of_panel[static_cast<std::size_t>(panel)] : ClothLook{};
}

Aabb3 cloth_box(const Scene& scene) {
  Aabb3 box;
  add_used(box, scene.cloth.positions, scene.cloth.triangles);
  return box;
}

Aabb3 whole_box(const Scene& scene) {
  Aabb3 box = cloth_box(scene);
  for (const BodyView& body : scene.bodies) add_used(box, body.mesh->vertices, body.mesh->triangles);
  return box;
}

double floor_height(const Scene& scene) {
  if (scene.floor) return *scene.floor;
  const Aabb3 box = whole_box(scene);
  return box.empty() ? 0 : box.low.y;
}

Status check_scene(const Scene& scene) {
  TRY(check_cloth(scene.cloth));
  TRY(check_textures(scene.cloth));
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::string owner = "body " + std::to_string(b);
    const geometry::TriangleMesh* mesh = scene.bodies[b].mesh;
    if (mesh == nullptr) return Error{"render.bad_scene", "a body has no mesh", owner, ErrorKind::kInternal};
    TRY(check_points(mesh->vertices, owner));
    if (Status bad = check_triangles(mesh->triangles, mesh->vertices.size(), owner); !bad.ok()) return bad;
  }
  if (scene.floor && !(std::abs(*scene.floor) <= kFarthest)) {
    return Error{"render.not_finite", "the height of the ground is not within 1 km", "floor",
                 ErrorKind::kInternal};
  }
  return {};
}

}  // namespace toile::render
