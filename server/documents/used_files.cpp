#include "server/documents/used_files.h"

#include <cstddef>

#include "core/json/tree.h"

namespace toile {

std::vector<UsedFile> used_files(const Project& project) {
  std::vector<UsedFile> used;
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const std::optional<ProjectDxf>& from = project.pieces[i].from;
    const std::optional<ProjectTexture>& texture = project.pieces[i].texture;
    const std::string piece = pointer_to("/pieces", i);
    if (from) used.push_back({from->dxf, "dxf", pointer_to(pointer_to(piece, "from"), "dxf")});
    if (texture) used.push_back({texture->image, "image", pointer_to(pointer_to(piece, "texture"), "image")});
  }
  for (std::size_t i = 0; i < project.bodies.size(); ++i) {
    if (project.bodies[i].mannequin) continue;
    used.push_back({project.bodies[i].file, "body", pointer_to(pointer_to("/bodies", i), "file")});
  }
  return used;
}

}  // namespace toile
