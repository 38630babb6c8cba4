#pragma once
// What many handlers need to read a request and to write an answer.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "server/http/message.h"

namespace toile::handlers {

http::HttpResponse json_answer(int status, std::string text);
http::HttpResponse json_answer(int status, std::vector<json::JsonMember> members);
/// The same with one more member whose value is JSON text already; passed over when it is empty.
http::HttpResponse json_answer(int status, std::vector<json::JsonMember> members, const std::string& key,
                               const std::string& json);
/// One line of JSON: `members` and, at its end, the member whose value is JSON text already.
std::string json_with(std::vector<json::JsonMember> members, const std::string& key, const std::string& json);

/// 204: it is gone.
http::HttpResponse no_content();
http::HttpResponse created(http::HttpResponse answer, const std::string& location);
/// 201 for what this request made, 200 for what an earlier one with the same key did; with its place.
http::HttpResponse made_answer(http::HttpResponse answer, bool anew, const std::string& location);

/// A request's JSON object. Errors: json.*, request.object, request.unknown_key when a member is not one of
/// `known`.
Result<json::JsonValue> read_object(const http::HttpRequest& request, const std::vector<std::string>& known,
                                    const json::JsonLimits& limits);

/// What somebody may send who has not said or shown yet who they are.
inline constexpr std::size_t kStrangerBytes = 4096;
inline constexpr json::JsonLimits kStrangerLimits{.bytes = kStrangerBytes, .depth = 8};

/// Bytes of a name that a user gives to something of theirs.
inline constexpr std::size_t kLongestLabel = 80;

/// What read_page takes.
inline const std::vector<std::string> kPageParameters{"cursor", "limit"};
/// A page of a list.
struct Page {
  std::string cursor;
  int limit = 50;
};
/// Of ?cursor and ?limit (1 to 100). Error: request.limit.
Result<Page> read_page(const http::HttpRequest& request);

/// The rows of a page, for which one more than its limit was asked, as JSON under `name`, and "next": the
/// cursor of the page after it or null.
template <typename Row, typename Make>
http::HttpResponse page_answer(const char* name, const Page& page, std::vector<Row> rows, Make make) {
  json::JsonValue next;
  if (rows.size() > static_cast<std::size_t>(page.limit)) {
    rows.resize(static_cast<std::size_t>(page.limit));
    next = json::JsonValue(rows.back().id);
  }
  std::vector<json::JsonValue> items;
  items.reserve(rows.size());
  for (const Row& row : rows) items.push_back(make(row));
  return json_answer(200, {{name, std::move(items)}, {"next", std::move(next)}});
}

/// Bytes that are somebody's own: shown for what `content_type` says and nothing else.
http::HttpResponse file_answer(std::string bytes, const std::string& content_type, const std::string& name);

/// The same, sent from the file at `path`. 500 when it is gone.
http::HttpResponse file_answer_from(const std::string& path, const std::string& content_type,
                                    const std::string& name);

}  // namespace toile::handlers
