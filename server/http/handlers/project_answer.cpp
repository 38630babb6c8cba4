#include "server/http/handlers/project_answer.h"

#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "server/http/handlers/answer.h"
#include "server/http/problem.h"

namespace toile {

std::vector<JsonMember> project_members(const ProjectRow& project) {
  std::vector<JsonMember> files;
  for (const auto& [name, id] : project.files) files.push_back({name, id});
  return {{"id", project.id},
          {"name", project.name},
          {"revision", static_cast<double>(project.revision)},
          {"created_ms", static_cast<double>(project.created_ms)},
          {"updated_ms", static_cast<double>(project.updated_ms)},
          {"files", std::move(files)}};
}

std::string etag_of(const ProjectRow& project) {
  std::string tag = "\"";  // one append after the other: GCC 12 warns about "…" + a temporary
  tag += std::to_string(project.revision);
  return tag += '"';
}

HttpResponse project_answer(const ProjectRow& project) {
  HttpResponse response = json_answer(200, project_members(project), "document", project.document);
  response.headers.emplace_back("ETag", etag_of(project));
  return response;
}

Result<int> required_revision(const HttpRequest& request) {
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

HttpResponse revision_problem(const Error& error) {
  if (error.kind != ErrorKind::kStale) return problem(error);
  return problem(
      412, {"store.conflict", "the project has changed since; read it again", "If-Match", ErrorKind::kStale});
}

Result<std::map<std::string, std::string>> read_files(const JsonValue& request) {
  std::map<std::string, std::string> out;
  const JsonValue* files = request.find("files");
  if (!files) return out;
  if (!files->object())
    return Error{"request.files", "\"files\" is an object of file name to asset id", "/files"};
  for (const JsonMember& file : *files->object()) {
    if (!file.value.text()) {
      return Error{"request.files", "a file stands for the id of an asset", pointer_to("/files", file.key)};
    }
    out[file.key] = *file.value.text();
  }
  return out;
}

ApiRoute document_route(const char* method, const char* pattern, decltype(ApiRoute::handler) handler) {
  ApiRoute route{.method = method, .pattern = pattern, .handler = std::move(handler)};
  route.body = BodyKind::kJson;
  route.limit = [](const HttpRequest&) { return kMostRequestBytes; };
  route.heavy = true;
  return route;
}

}  // namespace toile
