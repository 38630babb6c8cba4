#pragma once
// Requests and answers as plain values, so that routes and handlers know nothing of sockets.

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/store/request_context.h"

namespace toile::http {

struct HttpRequest {
  std::string method;                 ///< "GET"
  std::string target;                 ///< as it came, with the query
  std::vector<std::string> segments;  ///< of the path, decoded; "/" has none
  std::map<std::string, std::string> query;
  std::map<std::string, std::string> headers;  ///< names in lower case; of a name that stands twice the last
  std::string body;
  std::string sender;                 ///< the address that it comes from
  std::vector<std::string> captures;  ///< what the {…} of the route stand for, in order

  /// Value of a header or of a query parameter; empty when it is not there.
  std::string header(const std::string& lower_name) const;
  std::string parameter(const std::string& name) const;
};

/// A file that an answer is sent from, piece by piece, open as long as it is needed.
class AnswerFile {
 public:
  /// Null when there is no such regular file.
  static std::shared_ptr<const AnswerFile> open(const std::string& path);
  ~AnswerFile();
  AnswerFile(const AnswerFile&) = delete;
  AnswerFile& operator=(const AnswerFile&) = delete;

  std::uint64_t size() const { return size_; }
  /// At most `most` bytes; none at its end, or where it cannot be read.
  std::string read(std::uint64_t at, std::size_t most) const;

 private:
  AnswerFile(int fd, std::uint64_t size) : fd_(fd), size_(size) {}
  int fd_;
  std::uint64_t size_;
};

/// What a stream shows to somebody who is not its owner.
struct Watched {
  store::RequestContext context;
  std::string job;
};

struct HttpResponse {
  int status = 200;
  std::string content_type;  ///< empty: no body
  std::string body;
  std::shared_ptr<const AnswerFile> file{};  ///< in place of the body
  std::shared_ptr<const Watched> watched{};  ///< of a stream; null: what the request names, to who asks
  std::string code{};                        ///< of a problem, for whoever counts them
  std::vector<std::pair<std::string, std::string>> headers;
};

}  // namespace toile::http
