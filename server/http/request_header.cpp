#include "server/http/request_header.h"

#include <boost/beast/core/string.hpp>

#include <algorithm>
#include <string>

#include "core/base/text.h"
#include "server/http/problem.h"

namespace toile::http {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;

std::string text_of(beast::string_view view) { return {view.data(), view.size()}; }

}  // namespace

HttpRequest request_of(const RequestHeader& header) {
  HttpRequest request;
  request.method = text_of(header.method_string());
  request.target = text_of(header.target());
  for (const auto& field : header) {
    request.headers[lower_case(text_of(field.name_string()))] = text_of(field.value());
  }
  return request;
}

std::optional<HttpResponse> malformed(const RequestHeader& header, bool chunked) {
  const auto refused = [](const char* code, const char* words, const char* where) {
    return problem(400, {code, words, where});
  };
  const beast::string_view length = header[http::field::content_length];
  const bool digits = std::all_of(length.begin(), length.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (header.count(http::field::content_length) > 1 || !digits) {
    return refused("http.content_length", "a request has one Content-Length, a number", "Content-Length");
  }
  const beast::string_view coding = header[http::field::transfer_encoding];
  const bool only_chunked = chunked && beast::iequals(coding, "chunked");  // "gzip, chunked" is chunked too
  if (header.count(http::field::transfer_encoding) > 0 && !only_chunked) {
    return refused("http.transfer_encoding", "only chunked is understood here", "Transfer-Encoding");
  }
  if (header.count(http::field::host) > 1) return refused("http.host", "a request has one Host", "Host");
  return std::nullopt;
}

}  // namespace toile::http
