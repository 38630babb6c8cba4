#include "server/documents/proposals.h"

#include <vector>

#include "core/json/tree.h"
#include "core/pattern/seams/propose.h"
#include "core/project/bodies.h"
#include "core/project/create/create.h"
#include "core/project/project.h"

namespace toile {

Result<std::string> proposals_json(const std::string& document, const ProjectFiles& files) {
  Project project = TRY(parse_project(document));
  project = without_bodies(std::move(project));  // they take long to make, and say nothing of seams
  const DrapeInput input = TRY(resolve_project(project, files));
  std::vector<JsonValue> proposals;
  for (const SeamProposal& proposal : propose_seams(input.pattern))
    proposals.push_back(proposal_json(input.pattern, proposal));
  return write_json_line(std::vector<JsonMember>{{"proposals", std::move(proposals)}}) + "\n";
}

}  // namespace toile
