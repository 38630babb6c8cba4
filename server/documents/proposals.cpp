#include "server/documents/proposals.h"

#include <vector>

#include "core/pattern/propose_seams.h"
#include "proto/cpp/json_codec.h"
#include "proto/cpp/project.h"
#include "proto/cpp/project_bodies.h"
#include "proto/cpp/project_new.h"

namespace toile {

Result<std::string> proposals_json(const std::string& document, const ProjectFiles& files) {
  Result<Project> project = parse_project(document);
  if (!project) return project.error();
  *project = without_bodies(std::move(*project));  // they take long to make, and say nothing of seams
  const Result<DrapeInput> input = resolve_project(*project, files);
  if (!input) return input.error();
  std::vector<JsonValue> proposals;
  for (const SeamProposal& proposal : propose_seams(input->pattern))
    proposals.push_back(proposal_json(input->pattern, proposal));
  return write_json_line(std::vector<JsonMember>{{"proposals", std::move(proposals)}}) + "\n";
}

}  // namespace toile
