#pragma once
// Everything that can be said of a request once its header is there. Pure.

#include <cstdint>
#include <optional>

#include "server/http/guard.h"
#include "server/http/message.h"
#include "server/http/router.h"

namespace toile::http {

/// What the header says beside its fields.
struct Incoming {
  bool upgrade = false;  ///< to a WebSocket
  bool has_body = false;
  std::optional<std::uint64_t> length;  ///< Content-Length
};

struct Admission {
  const Route* route = nullptr;  ///< null: refused
  HttpResponse refusal;
  /// Who may learn of it. Beneath /api nobody who is not known learns what there is; what is wrong with the
  /// sender's own address or form is told to anybody.
  Access access = Access::kOpen;
};

/// Takes the target apart into the request's segments, query and captures, and finds its route; or says why
/// not: 400, 403, 404, 405, 413, 415, 421, 426.
Admission admit(const Router& router, HttpRequest& request, const Incoming& incoming, const Site& site = {});

}  // namespace toile::http
