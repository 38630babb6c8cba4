#include "core/project/resolve/body_shape.h"

#include <cmath>
#include <utility>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/json/tree.h"

namespace toile::resolve {
namespace {

/// `p` turned about the fixed axes x, then y, then z.
Vec3 turned(Vec3 p, Vec3 angles) {
  const auto turn = [](double& a, double& b, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double first = c * a - s * b;
    b = s * a + c * b;
    a = first;
  };
  turn(p.y, p.z, angles.x);
  turn(p.z, p.x, angles.y);
  turn(p.x, p.y, angles.z);
  return p;
}

bool is_near(Vec3 p) {
  constexpr double kFar = 1000;  // m; crossings are counted on a grid that ends at two kilometres
  return std::abs(p.x) <= kFar && std::abs(p.y) <= kFar && std::abs(p.z) <= kFar;
}

}  // namespace

Vec3 radians(Vec3 degrees) {
  return {radians_from_degrees(degrees.x), radians_from_degrees(degrees.y), radians_from_degrees(degrees.z)};
}

Result<mesh_import::RepairedMesh> mesh_of(const project::ProjectBody& given, OpenedFiles& files,
                                          const std::string& where) {
  if (given.mannequin) {
    Result<geometry::TriangleMesh> mesh = files.mannequin(*given.mannequin);
    if (!mesh) return json::error_at(json::pointer_to(where, "mannequin"), mesh.error());
    return mesh_import::RepairedMesh{std::move(*mesh), {}};
  }
  const std::string place = json::pointer_to(where, "file");
  if (Status name = check_file_name(given.file); !name) return json::error_at(place, name.error());
  Result<mesh_import::RepairedMesh> mesh = files.body_mesh(given);
  if (!mesh) return json::error_at(place, mesh.error());
  return mesh;
}

Status place(const project::ProjectBody& given, const std::string& where, std::vector<Vec3>& vertices) {
  const Vec3 angles = radians(given.rotation);
  for (Vec3& p : vertices) {
    p = turned(p * given.scale, angles) + given.translation;
    if (is_near(p)) continue;
    return Error{"project.body_too_far",
                 "body " + in_quotes(given.id) +
                     " reaches more than a kilometre away; look at its unit, scale and translation",
                 where};
  }
  return {};
}

}  // namespace toile::resolve
