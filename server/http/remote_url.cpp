#include "server/http/remote_url.h"

#include <boost/url/parse.hpp>
#include <boost/url/url_view.hpp>

#include "core/base/names.h"

namespace toile::http {

Result<RemoteUrl> read_remote_url(const std::string& url) {
  constexpr std::size_t kLongest = 1000;  // bytes
  const auto parsed = url.size() <= kLongest
                          ? boost::urls::parse_uri(url)
                          : boost::system::result<boost::urls::url_view>(boost::urls::error::not_a_base);
  const bool known = url.starts_with("https://") || url.starts_with("http://");
  if (!parsed || !known || parsed->has_userinfo() || parsed->has_fragment() ||
      parsed->encoded_host().empty() || (parsed->has_port() && parsed->port().empty())) {
    return Error{"client.url",
                 "the address is https://HOST/PATH or http://HOST/PATH, without user and #, not " +
                     in_quotes(clipped(url)),
                 ""};
  }
  RemoteUrl parts;
  parts.origin = std::string(parsed->scheme()) + "://" + std::string(parsed->encoded_host_and_port());
  const std::string path(parsed->encoded_path());
  parts.target = path.empty() ? "/" : path;
  if (parsed->has_query()) parts.target += "?" + std::string(parsed->encoded_query());
  return parts;
}

}  // namespace toile::http
