#pragma once
// Addresses of other servers taken apart. Pure.

#include <string>

#include "core/base/result.h"

namespace toile::http {

struct RemoteUrl {
  std::string origin;  ///< "https://example.org:8443", as HttpClient takes it
  std::string target;  ///< "/told?by=toile"
};

/// Of http and https, with path and query, without user, password and fragment; at most 1000 bytes. Error:
/// client.url.
Result<RemoteUrl> read_remote_url(const std::string& url);

}  // namespace toile::http
