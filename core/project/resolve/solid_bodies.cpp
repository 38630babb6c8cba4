#include "core/project/resolve/solid_bodies.h"

#include <utility>

#include "core/base/units.h"
#include "core/project/resolve/body_shape.h"
#include "core/project/resolve/make_all.h"
#include "core/project/resolve/motion.h"

namespace toile::resolve {
namespace {

Result<body::Body> body_of(const project::ProjectBody& given, OpenedFiles& files, const std::string& where) {
  mesh_import::RepairedMesh read = TRY(mesh_of(given, files, where));
  body::Body body;
  body.id = given.id;
  body.motion = TRY(motion_of(given, read.mesh, files, where));
  body.mesh = std::move(read.mesh);
  TRY(place(given, where, body.mesh.vertices));
  body.friction = given.friction;
  body.skin_offset = metres_from_mm(given.skin_offset_mm);
  body.restitution = given.restitution;
  body.notes = mesh_import::repair_words(read.repairs);
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
