#include "server/documents/used_files.h"

#include <cstddef>

#include "core/json/tree.h"

namespace toile::documents {

std::vector<UsedFile> used_files(const project::Project& project) {
  std::vector<UsedFile> used;
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const std::optional<project::ProjectDxf>& from = project.pieces[i].from;
    const std::optional<project::ProjectTexture>& texture = project.pieces[i].texture;
    const std::string piece = json::pointer_to("/pieces", i);
    if (from) used.push_back({from->dxf, "dxf", json::pointer_to(json::pointer_to(piece, "from"), "dxf")});
    if (texture)
      used.push_back(
          {texture->image, "image", json::pointer_to(json::pointer_to(piece, "texture"), "image")});
  }
  for (std::size_t i = 0; i < project.bodies.size(); ++i) {
    const std::string body = json::pointer_to("/bodies", i), motion = json::pointer_to(body, "motion");
    if (!project.bodies[i].mannequin)
      used.push_back({project.bodies[i].file, "body", json::pointer_to(body, "file")});
    for (std::size_t k = 0; k < project.bodies[i].motion.size(); ++k) {
      const project::ProjectKeyframe& keyframe = project.bodies[i].motion[k];
      if (!keyframe.mannequin)
        used.push_back({keyframe.file, "body", json::pointer_to(json::pointer_to(motion, k), "file")});
    }
  }
  return used;
}

}  // namespace toile::documents
