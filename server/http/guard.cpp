#include "server/http/guard.h"

#include "core/base/names.h"
#include "server/http/problem.h"
#include "server/http/url.h"

namespace toile::http {
namespace {

bool is_safe(const std::string& method) { return method == "GET" || method == "HEAD"; }

}  // namespace

std::optional<HttpResponse> turned_away(const HttpRequest& request, bool websocket, const Site& site) {
  const std::string host = request.header("host");
  const std::optional<std::string> name = host_name(host);
  if (!name) return problem(400, {"http.host", "a request names its host, as localhost:8460 does", "Host"});
  if (!site.any_host && !is_loopback_name(*name)) {
    return problem(
        421, {"http.host", "this server answers for the loopback only, not for " + in_quotes(host), "Host"});
  }
  const std::string origin = request.header("origin");
  if (origin.empty() || (is_safe(request.method) && !websocket)) return std::nullopt;
  if (origin == "https://" + host || (!site.secure && origin == "http://" + host)) return std::nullopt;
  return problem(403, {"http.origin", "pages of " + in_quotes(origin) + " may not do this", "Origin"});
}

}  // namespace toile::http
