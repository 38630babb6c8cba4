#pragma once
// What a browser may do here: the page that this server gave it, and no page of another site that it was led
// to.

#include <optional>

#include "server/http/message.h"

namespace toile::http {

/// How a server is come to.
struct Site {
  bool any_host = false;  ///< under whatever name: who asks has to be known anyhow
  bool secure = false;    ///< by https alone
};

/// Why a request is turned away, or nothing. The Host must be a loopback name (else a name that was rebound
/// to 127.0.0.1 could read everything that the single user has): 400 when it is missing or none, 421 when it
/// is another. Where something may change, and for WebSockets, an Origin must be that same host: 403.
std::optional<HttpResponse> turned_away(const HttpRequest& request, bool websocket, const Site& site = {});

}  // namespace toile::http
