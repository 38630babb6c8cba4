#include "core/exports/write_obj.h"

#include <system_error>

#include "core/base/aabb.h"
#include "core/base/write_file.h"
#include "core/geometry/obj_text.h"

namespace toile::exports {
namespace {

constexpr double kPieceGap = 0.05;  // m between the pieces of rest.obj

Status check_mesh(std::span<const Vec3> positions, std::span<const Tri> triangles) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!is_finite(positions[v])) {
      return Error{"export.not_finite", "a vertex has no finite position; nothing was written",
                   "vertex " + std::to_string(v), ErrorKind::kInternal};
    }
  }
  const auto count = static_cast<Index>(positions.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Index corner : triangles[t]) {
      if (corner < 0 || corner >= count) {
        return Error{"export.bad_index", "a triangle names a vertex that is not there",
                     "triangle " + std::to_string(t), ErrorKind::kInternal};
      }
    }
  }
  return {};
}

Status check_panels(std::size_t position_count, std::size_t triangle_count, const ObjPanels& panels) {
  if (panels.names.empty()) return {};
  if (!panels.rest.empty() && panels.rest.size() != position_count) {
    return Error{"export.bad_index", "not every vertex has a flat place", "", ErrorKind::kInternal};
  }
  if (panels.panel_of_triangle.size() != triangle_count) {
    return Error{"export.bad_index", "panels are named, but not every triangle has one", "",
                 ErrorKind::kInternal};
  }
  const auto count = static_cast<Index>(panels.names.size());
  for (std::size_t t = 0; t < triangle_count; ++t) {
    const Index panel = panels.panel_of_triangle[t];
    if (panel < 0 || panel >= count) {
      return Error{"export.bad_index", "a triangle names a panel that is not there",
                   "triangle " + std::to_string(t), ErrorKind::kInternal};
    }
  }
  return {};
}

std::string obj_text(std::span<const Vec3> positions, std::span<const Tri> triangles,
                     const ObjPanels& panels) {
  geometry::ObjText text;
  text.reserve(positions.size(), triangles.size());
  for (const Vec3& p : positions) text.vertex(p);
  if (panels.names.empty()) {
    for (const Tri& t : triangles) text.face(t);
    return text.take();
  }
  const bool flat = !panels.rest.empty();
  for (const Vec2& p : panels.rest) text.texture_place(p);
  // An object of OBJ is a run of lines: triangles are gathered by panel, in their order within it.
  std::vector<std::vector<Index>> of_panel(panels.names.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    of_panel[panels.panel_of_triangle[t]].push_back(static_cast<Index>(t));
  }
  for (std::size_t panel = 0; panel < of_panel.size(); ++panel) {
    if (of_panel[panel].empty()) continue;
    text.object(panels.names[panel]);
    for (const Index t : of_panel[panel]) {
      if (flat) {
        text.textured_face(triangles[t]);
      } else {
        text.face(triangles[t]);
      }
    }
  }
  return text.take();
}

Status check_garment(const sewing::GarmentMesh& garment, std::size_t position_count) {
  const std::size_t count = garment.rest.size();
  if (position_count != count || garment.panel_of_vertex.size() != count) {
    return Error{"export.bad_garment", "rest shape, panels and positions differ in their count of vertices",
                 "", ErrorKind::kInternal};
  }
  const auto panel_count = static_cast<Index>(garment.first_vertex.size()) - 1;
  for (std::size_t v = 0; v < count; ++v) {
    if (garment.panel_of_vertex[v] < 0 || garment.panel_of_vertex[v] >= panel_count) {
      return Error{"export.bad_garment", "a vertex belongs to no panel", "vertex " + std::to_string(v),
                   ErrorKind::kInternal};
    }
  }
  const auto in_range = [&](Index v) { return v >= 0 && static_cast<std::size_t>(v) < count; };
  for (std::size_t s = 0; s < garment.sewn.size(); ++s) {
    if (!in_range(garment.sewn[s][0]) || !in_range(garment.sewn[s][1])) {
      return Error{"export.bad_index", "a sewn pair names a vertex that is not there",
                   "pair " + std::to_string(s), ErrorKind::kInternal};
    }
  }
  return {};
}

/// The flat pieces with z = 0, moved along x only: each starts a gap after the one before.
std::vector<Vec3> laid_out(const sewing::GarmentMesh& garment) {
  const std::size_t panel_count = garment.first_vertex.empty() ? 0 : garment.first_vertex.size() - 1;
  std::vector<Aabb2> boxes(panel_count);
  for (std::size_t v = 0; v < garment.rest.size(); ++v)
    boxes[garment.panel_of_vertex[v]].add(garment.rest[v]);
  std::vector<double> shift(panel_count);
  double next = 0;
  for (std::size_t panel = 0; panel < panel_count; ++panel) {
    if (boxes[panel].empty()) continue;
    shift[panel] = next - boxes[panel].low.x;
    next += boxes[panel].size().x + kPieceGap;
  }
  std::vector<Vec3> flat(garment.rest.size());
  for (std::size_t v = 0; v < flat.size(); ++v) {
    flat[v] = {garment.rest[v].x + shift[garment.panel_of_vertex[v]], garment.rest[v].y, 0};
  }
  return flat;
}

Status write_bodies(const std::filesystem::path& path, std::span<const body::Body> bodies) {
  geometry::TriangleMesh all;
  for (const body::Body& body : bodies) {
    const auto first = static_cast<Index>(all.vertices.size());
    TRY(check_mesh(body.mesh.vertices, body.mesh.triangles));
    all.vertices.insert(all.vertices.end(), body.mesh.vertices.begin(), body.mesh.vertices.end());
    for (const Tri& t : body.mesh.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return write_obj(path, all.vertices, all.triangles);
}

std::string sewn_text(const std::vector<std::array<Index, 2>>& sewn) {
  std::string text = "[";
  for (std::size_t s = 0; s < sewn.size(); ++s) {
    text += (s == 0 ? "[" : ",\n [") + std::to_string(sewn[s][0]) + ", " + std::to_string(sewn[s][1]) + "]";
  }
  return text + "]\n";
}

}  // namespace

Status write_obj(const std::filesystem::path& path, std::span<const Vec3> positions,
                 std::span<const Tri> triangles, const ObjPanels& panels) {
  TRY(check_mesh(positions, triangles));
  TRY(check_panels(positions.size(), triangles.size(), panels));
  return write_file(path, obj_text(positions, triangles, panels));
}

Status write_check_data(const std::filesystem::path& directory, const sewing::GarmentMesh& garment,
                        std::span<const Vec3> positions, std::span<const body::Body> bodies,
                        const ObjPanels& panels) {
  TRY(check_garment(garment, positions.size()));
  std::error_code failed;
  std::filesystem::create_directories(directory, failed);
  if (failed)
    return Error{"export.write", "cannot make the directory: " + failed.message(), directory.string(),
                 ErrorKind::kInternal};

  TRY(write_obj(directory / "rest.obj", laid_out(garment), garment.triangles));
  TRY(write_obj(directory / "final.obj", positions, garment.triangles, panels));
  TRY(write_bodies(directory / "body.obj", bodies));
  return write_file(directory / "sewn.json", sewn_text(garment.sewn));
}

}  // namespace toile::exports
