#include "server/jobs/job_input.h"

#include "core/project/resolve/resolve.h"
#include "core/project/resolve/textures.h"
#include "server/documents/projects.h"

namespace toile {

Result<DrapeInput> drape_input_of(Documents& documents, const RequestContext& context,
                                  const std::string& document,
                                  const std::map<std::string, std::string>& files) {
  const Project project = TRY(parse_project(document));
  return resolve_project(project, files_in_store(documents, context, files));
}

Result<Textures> textures_of(Documents& documents, const RequestContext& context, const std::string& document,
                             const std::map<std::string, std::string>& files, const Pattern& pattern) {
  const Project project = TRY(parse_project(document));
  return read_textures(project, pattern, files_in_store(documents, context, files));
}

}  // namespace toile
