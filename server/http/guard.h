#pragma once
// Who may talk to a server on the loopback: programs of this machine and the page that it served itself, and
// no page of another site that a browser was led to.

#include <optional>

#include "server/http/message.h"

namespace toile::http {

/// Why a request is turned away, or nothing. The Host must be a loopback name (else a name that was rebound
/// to 127.0.0.1 could read everything): 400 when it is missing or none, 421 when it is another. Where
/// something may change, and for WebSockets, an Origin must be that same host: 403.
std::optional<HttpResponse> turned_away(const HttpRequest& request, bool websocket);

}  // namespace toile::http
