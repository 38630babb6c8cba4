#include "server/http/handlers/answer.h"

#include <algorithm>

#include "core/base/names.h"
#include "core/base/text.h"
#include "server/http/problem.h"

namespace toile::handlers {

http::HttpResponse json_answer(int status, std::string text) {
  http::HttpResponse response;
  response.status = status;
  response.content_type = "application/json";
  response.body = std::move(text);
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

http::HttpResponse json_answer(int status, std::vector<json::JsonMember> members) {
  return json_answer(status, json::write_json_line(std::move(members)) + "\n");
}

std::string json_with(std::vector<json::JsonMember> members, const std::string& key,
                      const std::string& json) {
  const bool first = members.empty();
  std::string text = json::write_json_line(std::move(members));
  text.pop_back();
  return text + (first ? "" : ", ") + "\"" + key + "\": " + json + "}";
}

http::HttpResponse json_answer(int status, std::vector<json::JsonMember> members, const std::string& key,
                               const std::string& json) {
  if (json.empty()) return json_answer(status, std::move(members));
  return json_answer(status, json_with(std::move(members), key, json) + "\n");
}

http::HttpResponse no_content() {
  http::HttpResponse response;
  response.status = 204;
  return response;
}

http::HttpResponse created(http::HttpResponse answer, const std::string& location) {
  answer.status = 201;
  answer.headers.emplace_back("Location", location);
  return answer;
}

http::HttpResponse made_answer(http::HttpResponse answer, bool anew, const std::string& location) {
  answer = created(std::move(answer), location);
  if (!anew) answer.status = 200;
  return answer;
}

Result<json::JsonValue> read_object(const http::HttpRequest& request, const std::vector<std::string>& known,
                                    const json::JsonLimits& limits) {
  Result<json::JsonValue> tree = json::parse_json(request.body, limits);
  if (!tree) return tree;
  if (!tree->object()) return Error{"request.object", "the body is a JSON object", "/"};
  for (const json::JsonMember& member : *tree->object()) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    return Error{"request.unknown_key",
                 "the key " + in_quotes(member.key) + " is not known here; " + advice(member.key, known),
                 json::pointer_to("", member.key)};
  }
  return tree;
}

Result<Page> read_page(const http::HttpRequest& request) {
  Page page;
  page.cursor = request.parameter("cursor");
  const std::string limit = request.parameter("limit");
  if (limit.empty()) return page;
  constexpr int kMost = 100;
  page.limit = number_in<int>(limit).value_or(0);
  if (page.limit >= 1 && page.limit <= kMost) return page;
  return Error{"request.limit", "limit is a number from 1 to 100", "limit"};
}

http::HttpResponse file_answer(std::string bytes, const std::string& content_type, const std::string& name) {
  std::string plain = name;  // in a header: letters, digits and a few signs
  for (char& c : plain) {
    const bool fits = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                      c == '.' || c == '-' || c == '_';
    if (!fits) c = '_';
  }
  http::HttpResponse response;
  response.content_type = content_type;
  response.body = std::move(bytes);
  response.headers = {{"Content-Disposition", "inline; filename=\"" + plain + "\""},
                      {"Content-Security-Policy", "default-src 'none'; sandbox"}};
  return response;
}

http::HttpResponse file_answer_from(const std::string& path, const std::string& content_type,
                                    const std::string& name) {
  http::HttpResponse response = file_answer("", content_type, name);
  response.file = http::AnswerFile::open(path);
  if (response.file) return response;
  return http::problem({"store.corrupt", "a file of the store is gone", name, ErrorKind::kSystem});
}

}  // namespace toile::handlers
