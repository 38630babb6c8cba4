#pragma once
// Whose request it is and what it is called: the one place where a context is made.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "server/accounts/gate.h"
#include "server/http/message.h"
#include "server/http/router.h"
#include "server/store/request_context.h"

namespace toile::http {

/// Gives out ids for requests: "r_", chance that tells this server's from another's, and a number.
/// Thread-safe.
class RequestIds {
 public:
  RequestIds();
  std::string next();

 private:
  std::string prefix_;
  std::atomic<std::uint64_t> count_{0};
};

/// The one user that there is where there are no accounts: whoever reaches the loopback. Also of what the
/// service does for that user by itself.
store::RequestContext local_user(const std::string& request_id, const Log& log);

/// What a request is called: the caller's X-Request-Id when that is plain (1 to 64 letters, digits, '-', '_',
/// '.'), so that a caller finds its own words in the log, and in the answer; else a new one.
std::string request_id_of(const HttpRequest& request, RequestIds& ids);

/// Nobody: what they are owner of does not exist, and they may do nothing.
store::RequestContext nobody(const std::string& request_id, const Log& log);
store::RequestContext context_of(const accounts::Caller& caller, const std::string& request_id,
                                 const Log& log);

/// The address that the last proxy says a request came to it from, in X-Forwarded-For; nothing when it says
/// none.
std::optional<std::string> forwarded_for(const HttpRequest& request);

/// The cookie of a session: "__Host-" tells a browser to take it by https alone, and from this host alone.
std::string cookie_name(bool secure);
/// A Set-Cookie for `secret`, of that name, that no script reads and no other site sends along; for no time
/// at all it takes the cookie away.
std::string session_cookie(const std::string& name, const std::string& secret, std::chrono::seconds lasts);

/// The name of the cookie of a share link, and a Set-Cookie by which a browser shows its secret on the
/// addresses of that link alone, until it is shut.
std::string link_cookie_name(const std::string& link, bool secure);
std::string link_cookie(const std::string& link, bool secure, const std::string& secret);
/// What a request shows of a share link's secret: a token, else the cookie of `link`; empty: nothing.
std::string link_secret_of(const HttpRequest& request, const std::string& link, bool secure);

accounts::Credentials credentials_of(const HttpRequest& request, const std::string& cookie);

/// 401 with WWW-Authenticate when nobody is known by what was shown; 429 with the time to wait; or what the
/// store has against it.
HttpResponse not_let_in(const Error& error, bool unknown, std::chrono::seconds wait);
/// Why somebody who is known may not, or nothing. 403: their key has not the scope; or it came in a cookie,
/// as pages of others might make a browser send it, where something changes or a WebSocket begins and no
/// Origin says whose page asks (that it is this one's, server/http/guard looks at).
std::optional<HttpResponse> not_allowed(const accounts::Caller& caller, Access access,
                                        const HttpRequest& request, bool websocket);

}  // namespace toile::http
