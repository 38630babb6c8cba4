// /api/v1/projects/{id}/pattern.dxf, .svg and .pdf: a project's pattern, to take home.

#include <string>
#include <utility>

#include "core/base/hash.h"
#include "core/print/paper.h"
#include "server/documents/pattern_file.h"
#include "server/documents/read_cloth.h"
#include "server/http/handlers/answer.h"
#include "server/http/handlers/api.h"
#include "server/http/problem.h"
#include "server/http/static_files.h"
#include "server/http/url.h"

namespace toile::handlers {
namespace {

using documents::PatternFormat;

const char* ending_of(PatternFormat format) {
  switch (format) {
    case PatternFormat::kDxf:
      return ".dxf";
    case PatternFormat::kSvg:
      return ".svg";
    case PatternFormat::kPdf:
      return ".pdf";
  }
  return "";
}

/// Of ?paper. Error: request.paper.
Result<print::Paper> read_paper(const http::HttpRequest& request) {
  const std::string word = request.parameter("paper");
  if (word.empty()) return print::kPapers[0];
  if (const print::Paper* paper = print::paper_named(word)) return *paper;
  std::string all;
  for (const print::Paper& paper : print::kPapers) all += (all.empty() ? "" : ", ") + std::string(paper.word);
  return Error{"request.paper", "paper is one of " + all, "paper"};
}

/// A browser saves it and shows it in no page: its viewers of PDF do not work in a sandbox.
http::HttpResponse attachment(std::string bytes, const std::string& name) {
  http::HttpResponse response = file_answer(std::move(bytes), http::content_type_of(name), name);
  for (auto& [header, value] : response.headers)
    if (header == "Content-Disposition") value.replace(0, std::string("inline").size(), "attachment");
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

/// The bytes have the tag, since they follow from the program as well as from the project.
http::HttpResponse tagged(http::HttpResponse response, const http::HttpRequest& request) {
  const std::string tag = "\"" + hash_of(response.body) + "\"";
  const bool known = http::names_tag(request.header("if-none-match"), tag);
  response.headers.emplace_back("ETag", tag);
  if (!known) return response;
  response.status = 304;
  response.content_type.clear();
  response.body.clear();
  return response;
}

http::HttpResponse pattern_answer(const Api& api, const store::RequestContext& context,
                                  const http::HttpRequest& request, PatternFormat format) {
  const Result<print::Paper> paper = read_paper(request);
  if (!paper) return http::problem(400, paper.error());
  const Result<store::ProjectRow> project = api.store.project(context, request.captures[0]);
  if (!project) return http::problem(project.error());
  const auto read = documents::read_cloth(api.documents, context, project->document, project->files);
  if (!read) return http::problem(read.error());
  Result<std::string> bytes = documents::pattern_file((*read)->cloth.pattern, project->name, format, *paper);
  if (!bytes) return http::problem(bytes.error());
  const std::string name = (project->name.empty() ? "Pattern" : project->name) + ending_of(format);
  return tagged(attachment(std::move(*bytes), name), request);
}

ApiRoute file_route(const char* pattern, PatternFormat format) {
  ApiRoute route;
  route.pattern = pattern;
  route.work = http::Work::kHeavy;
  route.handler = [format](const Api& api, const store::RequestContext& context,
                           const http::HttpRequest& request) {
    return pattern_answer(api, context, request, format);
  };
  if (format == PatternFormat::kPdf) route.parameters = {"paper"};
  return route;
}

}  // namespace

ApiRoutes pattern_file_routes() {
  return {
      file_route("/api/v1/projects/{id}/pattern.dxf", PatternFormat::kDxf),
      file_route("/api/v1/projects/{id}/pattern.svg", PatternFormat::kSvg),
      file_route("/api/v1/projects/{id}/pattern.pdf", PatternFormat::kPdf),
  };
}

}  // namespace toile::handlers
