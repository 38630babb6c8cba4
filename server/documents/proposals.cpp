#include "server/documents/proposals.h"

#include <vector>

#include "core/base/processors.h"
#include "core/json/tree.h"
#include "core/pattern/seams/propose.h"
#include "core/project/create/create.h"

namespace toile::documents {

std::string proposals_json(const pattern::Pattern& pattern) {
  std::vector<json::JsonValue> proposals =
      create::proposals_json(pattern, seams::propose_seams(pattern, {}, on_all_processors()));
  return json::write_json_line(std::vector<json::JsonMember>{{"proposals", std::move(proposals)}}) + "\n";
}

}  // namespace toile::documents
