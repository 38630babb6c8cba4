// What the reader of a mesh sends its caller through a pipe.

#include "core/body/mesh_import/message.h"

#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  mesh_import::RepairedMesh mesh;
  mesh.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return {mesh_import::mesh_message(mesh),
          mesh_import::mesh_message(Error{"mesh.unreadable", "Nothing can be read.", "a.obj"})};
}

void try_input(std::string_view bytes) {
  const Result<mesh_import::RepairedMesh> mesh = mesh_import::parse_mesh_message(bytes);
  if (!mesh) return;
  const auto count = static_cast<Index>(mesh->mesh.vertices.size());
  for (const Vec3& p : mesh->mesh.vertices) expect(is_finite(p), "coordinates are numbers");
  for (const Tri& tri : mesh->mesh.triangles)
    for (const Index v : tri) expect(v >= 0 && v < count, "corners are vertices");
  expect(mesh_import::mesh_message(mesh) == bytes, "a whole message is the only one that says this");
}

}  // namespace toile::fuzz
