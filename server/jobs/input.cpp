#include "server/jobs/input.h"

#include "core/drape/worn_part.h"
#include "core/project/resolve/resolve.h"
#include "core/project/resolve/textures.h"
#include "server/documents/projects.h"

namespace toile::jobs {

Result<drape::DrapeInput> drape_input_of(documents::Documents& documents,
                                         const store::RequestContext& context, const std::string& document,
                                         const std::map<std::string, std::string>& files) {
  const project::Project project = TRY(project::parse_project(document));
  drape::DrapeInput input =
      TRY(resolve::resolve_project(project, documents::files_in_store(documents, context, files)));
  return drape::worn_part(std::move(input));
}

Result<image::Textures> textures_of(documents::Documents& documents, const store::RequestContext& context,
                                    const std::string& document,
                                    const std::map<std::string, std::string>& files,
                                    const pattern::Pattern& pattern) {
  const project::Project project = TRY(project::parse_project(document));
  return resolve::read_textures(project, pattern, documents::files_in_store(documents, context, files));
}

}  // namespace toile::jobs
