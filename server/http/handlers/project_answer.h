#pragma once
// What all handlers of projects share: the project as JSON, its ETag, and the revision that a request names.

#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "server/http/handlers/api.h"
#include "server/http/message.h"
#include "server/store/store.h"

namespace toile {

/// A document of 4 MiB and what stands around it in a request: the names of its files.
inline constexpr std::size_t kMostRequestBytes = (std::size_t{4} << 20) + kSmallBody;

/// All but the document.
std::vector<JsonMember> project_members(const ProjectRow& project);
std::string etag_of(const ProjectRow& project);
/// With document and ETag.
HttpResponse project_answer(const ProjectRow& project);

/// The revision of If-Match, 0 for "*". Errors: request.if_match when there is none; store.conflict when it
/// is no revision of ours.
Result<int> required_revision(const HttpRequest& request);
/// problem() of an error that may be one of required_revision, or store.conflict of any call.
HttpResponse revision_problem(const Error& error);

/// "files" of a request: file name → asset id; none when it is not there. Error: request.files.
Result<std::map<std::string, std::string>> read_files(const JsonValue& request);

/// A route that takes a document, or as much.
ApiRoute document_route(const char* method, const char* pattern, decltype(ApiRoute::handler) handler);

}  // namespace toile
