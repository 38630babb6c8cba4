#pragma once
// The page: files of one folder.

#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "server/http/message.h"

namespace toile::http {

/// Answers GET from the files below a folder. What the bundler has named by its content (assets/…) may be
/// kept for ever, the rest is asked for again.
class StaticFiles {
 public:
  explicit StaticFiles(const std::filesystem::path& folder);

  /// `request.segments` have passed parse_target. 404 where there is no regular file, or one that a link
  /// leads out of the folder to; "/" is index.html, or a few words when the page has not been built.
  /// Text is compressed for who takes it, once for as long as the file stays the same.
  HttpResponse get(const HttpRequest& request) const;

 private:
  struct Compressed {
    std::filesystem::file_time_type written;
    std::string bytes;
  };
  void compress(const HttpRequest& request, const std::filesystem::path& path, HttpResponse& response) const;

  mutable std::mutex mutex_;
  mutable std::map<std::filesystem::path, Compressed> compressed_;
  std::filesystem::path folder_;  ///< canonical; empty: there is none
};

/// The media type of a file name's ending.
std::string content_type_of(const std::string& name);

}  // namespace toile::http
