#pragma once
// What requests say of jobs that are looked for, and of the words that are put on them.

#include <string>
#include <vector>

#include "core/json/tree.h"
#include "server/http/handlers/api.h"
#include "server/store/job_search.h"

namespace toile::handlers {

/// What read_query takes.
inline const std::vector<std::string> kQueryParameters{"state", "project", "tag", "sweep", "since", "until"};
/// Of ?state (words with commas between them), ?project, ?tag, ?sweep, ?since and ?until (Unix ms). Errors:
/// request.state, request.since, request.until.
Result<store::JobQuery> read_query(const http::HttpRequest& request);

/// "tags" of a request; none where it is not there. Error: request.tags.
Result<store::Tags> read_tags(const json::JsonValue& given);

/// The store's.
store::JobSearch& search_in(const Api& api);
/// As answers have them. A store that does not tell is told of in the log, and the list is empty.
json::JsonValue tags_of(const Api& api, const store::RequestContext& context, const std::string& job);
json::JsonValue tag_list(const store::Tags& tags);

}  // namespace toile::handlers
