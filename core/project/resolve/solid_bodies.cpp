#include "core/project/resolve/solid_bodies.h"

#include <cmath>
#include <utility>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/project/resolve/make_all.h"

namespace toile::resolve {
namespace {

Vec3 radians(Vec3 degrees) {
  return {radians_from_degrees(degrees.x), radians_from_degrees(degrees.y), radians_from_degrees(degrees.z)};
}

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

bool is_near(Vec3 p) {
  constexpr double kFar = 1000;  // m; crossings are counted on a grid that ends at two kilometres
  return std::abs(p.x) <= kFar && std::abs(p.y) <= kFar && std::abs(p.z) <= kFar;
}

Result<body::Body> body_of(const project::ProjectBody& given, OpenedFiles& files, const std::string& where) {
  mesh_import::RepairedMesh mesh = TRY(mesh_of(given, files, where));
  body::Body body;
  body.id = given.id;
  body.mesh = std::move(mesh.mesh);
  body.friction = given.friction;
  body.skin_offset = metres_from_mm(given.skin_offset_mm);
  body.restitution = given.restitution;
  body.notes = mesh_import::repair_words(mesh.repairs);
  const Vec3 angles = radians(given.rotation);
  for (Vec3& p : body.mesh.vertices) {
    p = turned(p * given.scale, angles) + given.translation;
    if (is_near(p)) continue;
    return Error{"project.body_too_far",
                 "body " + in_quotes(given.id) +
                     " reaches more than a kilometre away; look at its unit, scale and translation",
                 where};
  }
  return body;
}

}  // namespace

Status add_bodies(const std::vector<project::ProjectBody>& given, OpenedFiles& files,
                  std::vector<body::Body>& bodies) {
  const auto made = [&](const project::ProjectBody& one, const std::string& at) {
    return body_of(one, files, at);
  };
  return make_all(given, "/bodies", bodies, made);
}

}  // namespace toile::resolve
