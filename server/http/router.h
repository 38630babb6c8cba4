#pragma once
// Which handler a request goes to, and what it may bring along. Pure.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"
#include "server/store/request_context.h"

namespace toile::http {

/// The context says on whose behalf; a handler that asks for nothing of anybody passes over it.
using HttpHandler = std::function<HttpResponse(const store::RequestContext&, const HttpRequest&)>;

/// What a route takes as a body.
enum class BodyKind {
  kUnused,  ///< anything small is read and passed over
  kJson,    ///< application/json
  kFile,    ///< raw bytes of some file type
};

/// What a handler does. Each kind has threads of its own, so that none waits for one that takes longer.
enum class Work {
  kStore,     ///< asks the store: milliseconds
  kDocument,  ///< reads a document and its cloth: editing, showing pieces
  kSubmit,    ///< the same, and waits for the disk with others who do
  kHeavy,     ///< bodies, starts, arrangements: seconds
  kUpload,    ///< reads a stranger's file
};

/// Who may ask, where there are accounts.
enum class Access {
  kByMethod,  ///< GET and HEAD: kRead; all others: kSubmit
  kOpen,      ///< anybody
  kRead,
  kSubmit,
  kAdmin,
};

inline constexpr std::size_t kSmallBody = std::size_t{256} << 10;
inline std::size_t small_body(const HttpRequest&) { return kSmallBody; }

struct Route {
  std::string method;
  std::string pattern;  ///< "/api/v1/jobs/{id}/pause"
  HttpHandler handler;
  BodyKind body = BodyKind::kUnused;
  /// Most bytes that the body may have.
  std::function<std::size_t(const HttpRequest&)> limit = small_body;
  Work work = Work::kStore;
  Access access = Access::kByMethod;
  std::vector<std::string> parameters{};  ///< of the query; any other is refused
  bool any_parameter = false;             ///< none is refused
  bool websocket =
      false;  ///< an upgrade is wanted; the handler says what is wrong with it (status 200: nothing)
};

/// Never kByMethod.
Access access_of(const Route& route);

class Router {
 public:
  void add(Route route);
  /// Takes GET for whatever no other route knows and does not begin with /api.
  void add_page(HttpHandler handler);

  struct Match {
    const Route* route = nullptr;
    std::vector<std::string> captures;
    std::string allow;  ///< with no route but a known path: the methods that it has
  };
  /// HEAD goes where GET goes.
  Match match(const std::string& method, const std::vector<std::string>& segments) const;

 private:
  std::vector<Route> routes_;
  std::vector<std::vector<std::string>> patterns_;  // segments of each
  std::optional<Route> page_;
};

/// Why the body of a request to `route` is refused before it is read, or nothing: 415 for a type that the
/// route does not take, 413 for a Content-Length over its limit.
std::optional<HttpResponse> refused_body(const Route& route, const HttpRequest& request, bool has_body,
                                         std::optional<std::uint64_t> length);

/// The answer where there is no route: 404, or 405 with Allow.
HttpResponse no_route(const HttpRequest& request, const Router::Match& match);

}  // namespace toile::http
