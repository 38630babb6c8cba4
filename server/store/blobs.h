#pragma once
// Files of the store: contents named by their hash, results named within their job. A file is whole or not
// there, and once a call returns the disk has it. Calls are thread-safe.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "server/store/failures.h"
#include "server/store/store.h"

namespace toile::store {

class Blobs {
 public:
  /// Makes blobs/, results/, checkpoints/, logs/ and scratch/ in `folder`; when nobody else has it open
  /// (`alone`) the last is emptied. What fails later is counted in `failures`. Errors: store.open,
  /// store.full.
  static Result<Blobs> open(const std::filesystem::path& folder,
                            std::shared_ptr<Failures> failures = std::make_shared<Failures>(),
                            bool alone = true);

  /// Keeps the bytes and gives back their blob's name: hash and the ending of `file_name` ("….obj"). Errors:
  /// store.full, store.failed; store.hash_collision when other bytes have the same hash.
  Result<std::string> put_blob(std::string_view bytes, std::string_view file_name) const;
  /// Errors: store.corrupt when the file is gone, or is not what the name and `size` say.
  Result<std::string> blob(const std::string& blob, std::int64_t size) const;
  /// The same without reading more than the size.
  Result<std::filesystem::path> blob_path(const std::string& blob, std::int64_t size) const;

  /// Gives a file that is on the disk its name.
  using Naming = std::function<Status()>;
  /// Does so or refuses: asked once the bytes are on the disk.
  using NamingGate = std::function<Status(const Naming&)>;
  /// `job_id` is an id. Errors: store.bad_name, store.full, store.failed; those of `gate`.
  Status put_result(const std::string& job_id, const std::string& name, std::string_view bytes,
                    const NamingGate& gate = {}) const;
  /// `kept` says what it must be; without a hash it may be anything. Errors: store.bad_name,
  /// store.not_found, store.corrupt.
  Result<std::string> result(const std::string& job_id, const std::string& name,
                             const ResultFile& kept = {}) const;
  Result<std::filesystem::path> result_path(const std::string& job_id, const std::string& name) const;
  /// Gives `to` a result of `from`: the same file under a second name, for results are never written in
  /// place. Durable once sync_results() returns. Errors: store.bad_name, store.full, store.failed.
  Status share_result(const std::string& from, const std::string& to, const std::string& name) const;
  Status sync_results(const std::string& job_id) const;
  Status remove_results(const std::string& job_id) const;

  /// Names of what there is, in no order; what the store has not named itself is passed over.
  std::vector<std::string> blob_names() const;
  std::vector<std::string> jobs_with_results() const;
  std::vector<std::string> result_names(const std::string& job_id) const;
  /// Removes single files. What stays for some reason is tried again at the next start.
  void remove_blob(const std::string& blob) const;
  void remove_result(const std::string& job_id, const std::string& name) const;

  /// The checkpoint of a job: one at a time. Errors: store.full, store.failed.
  Status put_checkpoint(const std::string& job_id, std::string_view bytes, const NamingGate& gate = {}) const;
  /// When it was put, Unix time; 0 where there is none.
  std::int64_t checkpoint_ms(const std::string& job_id) const;
  /// Error: store.not_found.
  Result<Store::KeptCheckpoint> checkpoint(const std::string& job_id) const;
  Status remove_checkpoint(const std::string& job_id) const;
  /// Removes those of all other jobs.
  void keep_checkpoints_of(const std::set<std::string>& job_ids) const;

  /// What was written of a job; empty when nothing was, or when it cannot be read.
  std::string log(const std::string& job_id) const;
  void remove_log(const std::string& job_id) const;
  std::vector<std::string> jobs_with_logs() const;

  std::filesystem::path log_folder() const { return folder_ / "logs"; }
  std::filesystem::path scratch_folder() const { return folder_ / "scratch"; }

 private:
  Blobs(std::filesystem::path folder, std::shared_ptr<Failures> failures)
      : folder_(std::move(folder)), failures_(std::move(failures)) {}
  std::filesystem::path place_of(const std::string& blob) const;
  Status write(const std::filesystem::path& path, std::string_view bytes, const NamingGate& gate = {}) const;

  Error corrupt(const char* message, const std::string& what) const;

  std::filesystem::path folder_;
  std::shared_ptr<Failures> failures_;
};

/// Waits until the disk has the folder's list of names. Errors: store.full, store.failed.
Status sync_folder(const std::filesystem::path& folder);

}  // namespace toile::store
