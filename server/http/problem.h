#pragma once
// Errors as application/problem+json (RFC 9457).

#include <string>

#include "core/base/result.h"
#include "server/http/message.h"

namespace toile::http {

/// The phrase of a status, "Not Found".
std::string status_phrase(int status);

/// What an error of the core or of a service means to whoever asked: 404 for what is not there, 409, 412 and
/// 428 for conflicts, 413 for too much, 400 for what is no JSON, 422 for documents and files that cannot be
/// used, 429, 503 and 507 for what may go well later, 500 for faults of ours and of what lies under us.
int status_of(ErrorKind kind);

/// {"type": "about:blank", "title", "status", "code", "detail", "where"}. With 429 and 503 goes a
/// Retry-After.
HttpResponse problem(int status, const Error& error);
HttpResponse problem(const Error& error);

}  // namespace toile::http
