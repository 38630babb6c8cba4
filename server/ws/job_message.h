#pragma once
// Jobs as JSON: the same words over HTTP and on the stream. Keys are those of JobRow and JobProgress;
// proto/openapi.yaml and proto/asyncapi.yaml describe them.

#include <string>
#include <vector>

#include "core/json/tree.h"
#include "server/jobs/publisher.h"
#include "server/store/store.h"

namespace toile::ws {

/// What a person or a page wants to know of a job; without its document, files and report.
std::vector<json::JsonMember> job_members(const store::JobRow& job);
std::vector<json::JsonMember> progress_members(const jobs::JobProgress& progress);

/// {"type": "job", …job, "progress": {…}}: the first message of a stream.
std::string job_message(const store::JobRow& job, const jobs::JobProgress& progress);
/// {"type": "progress", …progress}
std::string progress_message(const jobs::JobProgress& progress);
/// {"type": "ended", …progress, "job": {…}}: the last message of a stream.
std::string ended_message(const store::JobRow& job, const jobs::JobProgress& last);
/// {"type": "error", "code", "detail", "where"}: a command of the viewer was refused; the stream goes on.
std::string error_message(const Error& error);

}  // namespace toile::ws
