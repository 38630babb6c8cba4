#pragma once
// Requests and answers as plain values, so that routes and handlers know nothing of sockets.

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace toile::http {

struct HttpRequest {
  std::string method;                 ///< "GET"
  std::string target;                 ///< as it came, with the query
  std::vector<std::string> segments;  ///< of the path, decoded; "/" has none
  std::map<std::string, std::string> query;
  std::map<std::string, std::string> headers;  ///< names in lower case; of a name that stands twice the last
  std::string body;
  std::vector<std::string> captures;  ///< what the {…} of the route stand for, in order

  /// Value of a header or of a query parameter; empty when it is not there.
  std::string header(const std::string& lower_name) const;
  std::string parameter(const std::string& name) const;
};

struct HttpResponse {
  int status = 200;
  std::string content_type;  ///< empty: no body
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers;
};

}  // namespace toile::http
