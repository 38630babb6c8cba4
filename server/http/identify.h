#pragma once
// Whose request it is and what it is called: the one place where a context is made.

#include <atomic>
#include <cstdint>
#include <string>

#include "server/http/message.h"
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

/// The one user that there is until there are accounts: whoever reaches the loopback. Also of what the
/// service does for that user by itself.
store::RequestContext local_user(const std::string& request_id, const Log& log);

/// The context of a request. Its id is the caller's X-Request-Id when that is plain (1 to 64 letters, digits,
/// '-', '_', '.'), so that a caller finds its own words in the log, and in the answer; else a new one.
store::RequestContext identify(const HttpRequest& request, RequestIds& ids, const Log& log);

}  // namespace toile::http
