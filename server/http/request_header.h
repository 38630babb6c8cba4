#pragma once
// What the header of a request says. Internal to http.

#include <boost/beast/http/fields.hpp>
#include <boost/beast/http/message.hpp>

#include <optional>

#include "server/http/message.h"

namespace toile::http {

using RequestHeader = boost::beast::http::request_header<>;

/// The request without its body; names of fields in lower case.
HttpRequest request_of(const RequestHeader& header);

/// What makes it doubtful where this request ends and the next begins, or whom it is meant for. `chunked`: as
/// Beast understands it.
std::optional<HttpResponse> malformed(const RequestHeader& header, bool chunked);

}  // namespace toile::http
