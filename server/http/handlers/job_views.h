#pragma once
// What is to be seen of a job, for its owner and for who has a share link to it. Of each the first capture is
// the job's id, the second, where it has one, a result's name.

#include <vector>

#include "core/json/tree.h"
#include "server/http/handlers/api.h"

namespace toile::handlers {

/// A job with what it is doing now; no progress once it has ended and its figures are in the report.
std::vector<json::JsonMember> job_members_now(const Api& api, const store::RequestContext& context,
                                              const store::JobRow& job);

http::HttpResponse job_result(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request);

/// A picture among the results, made smaller (?width). What has ended never changes, so that whoever has it
/// keeps it.
http::HttpResponse small_job_result(const Api& api, const store::RequestContext& context,
                                    const http::HttpRequest& request);

/// The report as a page, made when it is asked for: a drape costs nothing for what nobody looks at.
http::HttpResponse job_report_page(const Api& api, const store::RequestContext& context,
                                   const http::HttpRequest& request);

/// Colours, fabrics and prints of the pieces as they were when the job was made.
http::HttpResponse job_pieces(const Api& api, const store::RequestContext& context,
                              const http::HttpRequest& request);

/// The bodies under the cloth, as one mesh.
http::HttpResponse job_body(const Api& api, const store::RequestContext& context,
                            const http::HttpRequest& request);

}  // namespace toile::handlers
