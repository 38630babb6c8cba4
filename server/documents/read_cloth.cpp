#include "server/documents/read_cloth.h"

#include <cstddef>
#include <utility>

#include "core/project/bodies.h"
#include "core/project/resolve/resolve.h"

namespace toile::documents {
namespace {

std::size_t bytes_of(const pattern::Loop& loop) {
  std::size_t bytes = 0;
  for (const pattern::PanelEdge& edge : loop.edges)
    bytes += sizeof edge + edge.curves.size() * sizeof(pattern::CubicBezier);
  return bytes;
}

/// About: a document's values take some four times the bytes of its text; the pattern's curves are counted.
std::size_t bytes_of(const std::string& key, const drape::DrapeInput& cloth) {
  std::size_t bytes = 5 * key.size();
  for (const pattern::Panel& panel : cloth.pattern.panels) {
    bytes += sizeof panel + bytes_of(panel.outline);
    for (const pattern::Loop& hole : panel.holes) bytes += bytes_of(hole);
    for (const pattern::InnerLine& line : panel.lines)
      bytes += sizeof line + line.points.size() * sizeof(Vec2);
  }
  return bytes;
}

}  // namespace

std::string key_of(const store::OwnerId& owner, const std::string& document, const ProjectFileMap& files) {
  std::string key = owner + '\n' + document;
  for (const auto& [name, id] : files) key.append("\n").append(name).append("\t").append(id);
  return key;
}

std::shared_ptr<const ReadCloth> kept_cloth(Documents& documents, const store::OwnerId& owner,
                                            const std::string& document, const ProjectFileMap& files) {
  return documents.cloths().find(key_of(owner, document, files));
}

std::shared_ptr<const ReadCloth> keep_cloth(Documents& documents, const store::OwnerId& owner,
                                            const std::string& document, const ProjectFileMap& files,
                                            ReadCloth read) {
  read.cloth.bodies.clear();  // meshes are kept elsewhere, and nobody looks for them here
  const std::string key = key_of(owner, document, files);
  const std::size_t bytes = bytes_of(key, read.cloth);
  auto kept = std::make_shared<const ReadCloth>(std::move(read));
  documents.cloths().keep(key, kept, bytes);
  return kept;
}

Result<std::shared_ptr<const ReadCloth>> read_cloth(Documents& documents,
                                                    const store::RequestContext& context,
                                                    const std::string& document,
                                                    const ProjectFileMap& files) {
  if (auto kept = kept_cloth(documents, context.owner, document, files)) return kept;
  project::Project project = TRY(project::parse_project(document));
  drape::DrapeInput cloth = TRY(
      resolve::resolve_project(project::without_bodies(project), files_in_store(documents, context, files)));
  return keep_cloth(documents, context.owner, document, files, {std::move(project), std::move(cloth)});
}

}  // namespace toile::documents
