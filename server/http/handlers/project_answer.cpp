#include "server/http/handlers/project_answer.h"

#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "server/http/handlers/answer.h"
#include "server/http/problem.h"

namespace toile::handlers {

std::vector<json::JsonMember> project_members(const store::ProjectRow& project) {
  std::vector<json::JsonMember> files;
  for (const auto& [name, id] : project.files) files.push_back({name, id});
  return {{"id", project.id},
          {"name", project.name},
          {"revision", static_cast<double>(project.revision)},
          {"created_ms", static_cast<double>(project.created_ms)},
          {"updated_ms", static_cast<double>(project.updated_ms)},
          {"files", std::move(files)}};
}

std::string etag_of(const store::ProjectRow& project) {
  std::string tag = "\"";  // one append after the other: GCC 12 warns about "…" + a temporary
  tag += std::to_string(project.revision);
  return tag += '"';
}

http::HttpResponse project_answer(const store::ProjectRow& project) {
  http::HttpResponse response = json_answer(200, project_members(project), "document", project.document);
  response.headers.emplace_back("ETag", etag_of(project));
  return response;
}

Result<int> required_revision(const http::HttpRequest& request) {
  const std::string tag = request.header("if-match");
  if (tag.empty()) {
    return Error{"request.if_match", "say which revision this changes: If-Match with the ETag, or *",
                 "If-Match", ErrorKind::kUnconditional};
  }
  if (tag == "*") return 0;
  const Error other{"store.conflict", "this is no revision of the project", "If-Match", ErrorKind::kStale};
  if (tag.size() < 3 || tag.front() != '"' || tag.back() != '"') return other;
  const auto revision = number_in<int>(std::string_view(tag).substr(1, tag.size() - 2));
  if (!revision || *revision < 1) return other;
  return *revision;
}

http::HttpResponse revision_problem(const Error& error) {
  if (error.kind != ErrorKind::kStale) return http::problem(error);
  return http::problem(
      412, {"store.conflict", "the project has changed since; read it again", "If-Match", ErrorKind::kStale});
}

Result<std::map<std::string, std::string>> read_files(const json::JsonValue& request) {
  std::map<std::string, std::string> out;
  const json::JsonValue* files = request.find("files");
  if (!files) return out;
  if (!files->object())
    return Error{"request.files", "\"files\" is an object of file name to asset id", "/files"};
  for (const json::JsonMember& file : *files->object()) {
    if (!file.value.text()) {
      return Error{"request.files", "a file stands for the id of an asset",
                   json::pointer_to("/files", file.key)};
    }
    out[file.key] = *file.value.text();
  }
  return out;
}

ApiRoute document_route(const char* method, const char* pattern, decltype(ApiRoute::handler) handler) {
  ApiRoute route{.method = method, .pattern = pattern, .handler = std::move(handler)};
  route.body = http::BodyKind::kJson;
  route.limit = [](const http::HttpRequest&) { return kMostRequestBytes; };
  route.work = http::Work::kHeavy;
  return route;
}

}  // namespace toile::handlers
