#pragma once
// Files of the store: contents named by their hash, results named within their job. A file is whole or not
// there, and once a call returns the disk has it. Calls are thread-safe.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/result.h"

namespace toile {

class Blobs {
 public:
  /// Makes blobs/, results/ and an empty scratch/ in `folder`. Errors: store.open, store.full.
  static Result<Blobs> open(const std::filesystem::path& folder);

  /// Keeps the bytes and gives back their blob's name: hash and the ending of `file_name` ("….obj"). Errors:
  /// store.full, store.failed; store.hash_collision when other bytes have the same hash.
  Result<std::string> put_blob(std::string_view bytes, std::string_view file_name) const;
  /// Errors: store.corrupt when the file is gone, or is not what the name and `size` say.
  Result<std::string> blob(const std::string& blob, std::int64_t size) const;
  /// The same without reading more than the size.
  Result<std::filesystem::path> blob_path(const std::string& blob, std::int64_t size) const;

  /// `job_id` is an id. Errors: store.bad_name, store.full, store.failed.
  Status put_result(const std::string& job_id, const std::string& name, std::string_view bytes) const;
  /// Errors: store.bad_name, store.not_found.
  Result<std::string> result(const std::string& job_id, const std::string& name) const;

  std::filesystem::path scratch_folder() const { return folder_ / "scratch"; }

 private:
  explicit Blobs(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::filesystem::path place_of(const std::string& blob) const;
  Status write(const std::filesystem::path& path, std::string_view bytes) const;

  std::filesystem::path folder_;
};

/// Waits until the disk has the folder's list of names. Errors: store.full, store.failed.
Status sync_folder(const std::filesystem::path& folder);

}  // namespace toile
