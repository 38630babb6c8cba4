#include "server/http/static_files.h"

#include <algorithm>
#include <map>
#include <optional>
#include <system_error>

#include "core/base/names.h"
#include "core/base/read_file.h"
#include "server/http/compress.h"
#include "server/http/problem.h"

namespace toile::http {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;
constexpr std::size_t kLeastWorthwhile = 1024;  // bytes; less fits one packet either way

/// Only this server's own scripts, styles and connections.
constexpr const char* kContentPolicy =
    "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; worker-src 'self' "
    "blob:; "
    "connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'self'";

constexpr const char* kNoPage = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<title>Toile</title>
<h1>Toile is running</h1>
<p>The page has not been built: it needs Node. Install the package nodejs and run <code>./run</code> again.
<p>The service itself is here: <a href="/api/v1/jobs">jobs</a>, <a href="/api/v1/projects">projects</a>,
<a href="/healthz">health</a>, <a href="/metrics">figures</a>.
</html>
)";

bool is_text(const std::string& content_type) {
  return content_type.starts_with("text/") || content_type == "application/json" ||
         content_type == "image/svg+xml" || content_type == "application/wasm";
}

/// The file below `folder` that the segments name.
std::optional<fs::path> find_file(const fs::path& folder, const std::vector<std::string>& segments) {
  fs::path path = folder;
  for (const std::string& segment : segments) {
    if (segment.empty() || segment.front() == '.') return std::nullopt;
    path /= segment;
  }
  std::error_code failure;
  const fs::path real = fs::canonical(path, failure);
  if (failure || !fs::is_regular_file(real, failure) || fs::file_size(real, failure) > kMostBytes) {
    return std::nullopt;
  }
  const auto [rest, ignored] = std::mismatch(folder.begin(), folder.end(), real.begin(), real.end());
  if (rest != folder.end()) return std::nullopt;
  return real;
}

HttpResponse html(std::string body) {
  HttpResponse response;
  response.content_type = "text/html; charset=utf-8";
  response.body = std::move(body);
  response.headers = {{"Cache-Control", "no-cache"}, {"Content-Security-Policy", kContentPolicy}};
  return response;
}

}  // namespace

std::string content_type_of(const std::string& name) {
  static const std::map<std::string, std::string> types{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".mjs", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".map", "application/json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".jpg", "image/jpeg"},
      {".ico", "image/x-icon"},
      {".woff2", "font/woff2"},
      {".wasm", "application/wasm"},
      {".txt", "text/plain; charset=utf-8"},
      {".obj", "model/obj"},
      {".glb", "model/gltf-binary"},
      {".dxf", "image/vnd.dxf"},
      {".pdf", "application/pdf"},
      {".mp4", "video/mp4"},
      {".avi", "video/x-msvideo"},
  };
  const auto found = types.find(fs::path(name).extension().string());
  return found == types.end() ? "application/octet-stream" : found->second;
}

StaticFiles::StaticFiles(const fs::path& folder) {
  std::error_code failure;
  if (!folder.empty()) folder_ = fs::canonical(folder, failure);
  if (failure || !fs::is_directory(folder_, failure)) folder_.clear();
}

HttpResponse StaticFiles::get(const HttpRequest& request) const {
  const bool start = request.segments.empty();
  const std::vector<std::string> segments = start ? std::vector<std::string>{"index.html"} : request.segments;
  const auto path = folder_.empty() ? std::nullopt : find_file(folder_, segments);
  std::optional<std::string> bytes = path ? read_file(*path) : std::nullopt;
  if (!bytes && start) return html(kNoPage);
  if (!bytes) {
    return problem(404, {"http.not_found", "there is nothing at this address", clipped(request.target, 200)});
  }
  const std::string type = content_type_of(segments.back());
  HttpResponse response;
  if (type.starts_with("text/html")) {
    response = html(std::move(*bytes));
  } else {
    const bool hashed = segments.front() == "assets";
    response.content_type = type;
    response.body = std::move(*bytes);
    response.headers.emplace_back("Cache-Control",
                                  hashed ? "public, max-age=31536000, immutable" : "no-cache");
  }
  compress(request, *path, response);
  return response;
}

void StaticFiles::compress(const HttpRequest& request, const fs::path& path, HttpResponse& response) const {
  if (!is_text(response.content_type) || response.body.size() < kLeastWorthwhile) return;
  response.headers.emplace_back("Vary", "Accept-Encoding");
  if (!takes_gzip(request.header("accept-encoding"))) return;
  std::error_code failure;
  const fs::file_time_type written = fs::last_write_time(path, failure);
  const std::lock_guard hold(mutex_);
  Compressed& kept = compressed_[path];
  if (kept.bytes.empty() || kept.written != written) kept = {written, gzipped(response.body)};
  if (kept.bytes.empty()) return;
  response.body = kept.bytes;
  response.headers.emplace_back("Content-Encoding", "gzip");
}

}  // namespace toile::http
