#include "server/documents/proposals.h"

#include <vector>

#include "core/json/tree.h"
#include "core/pattern/seams/propose.h"
#include "core/project/bodies.h"
#include "core/project/create/create.h"
#include "core/project/project.h"

namespace toile::documents {

Result<std::string> proposals_json(const std::string& document, const resolve::ProjectFiles& files) {
  project::Project project = TRY(project::parse_project(document));
  project = project::without_bodies(std::move(project));  // they take long to make, and say nothing of seams
  const drape::DrapeInput input = TRY(resolve::resolve_project(project, files));
  std::vector<json::JsonValue> proposals;
  for (const seams::SeamProposal& proposal : seams::propose_seams(input.pattern))
    proposals.push_back(create::proposal_json(input.pattern, proposal));
  return json::write_json_line(std::vector<json::JsonMember>{{"proposals", std::move(proposals)}}) + "\n";
}

}  // namespace toile::documents
