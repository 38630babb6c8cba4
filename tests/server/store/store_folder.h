#pragma once
// A folder with a store in it, for one test.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "server/store/sqlite/open.h"
#include "tests/server/owners.h"

namespace toile {

/// A new empty folder that goes with the value.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(testing::TempDir() + "toile_XXXXXX") {
    if (::mkdtemp(path_.data()) == nullptr) path_.clear();
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code failure;
    if (!path_.empty()) std::filesystem::remove_all(path_, failure);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The store of a folder; stops the program when it cannot be opened, since no test has a use for that.
inline std::unique_ptr<store::Store> opened(const std::string& folder) {
  Result<std::unique_ptr<store::Store>> store = sqlite::open_sqlite_store(folder);
  if (store) return std::move(*store);
  std::fprintf(stderr, "%s\n", to_string(store.error()).c_str());
  std::abort();
}

inline store::AssetRow named(const std::string& kind, const std::string& name) {
  store::AssetRow row;
  row.kind = kind;
  row.name = name;
  row.info = "{}";
  return row;
}

inline store::ProjectRow some_project(const std::string& name) {
  store::ProjectRow row;
  row.name = name;
  row.document = "{\"toile\": 1}";
  row.files = {{"cut/skirt.dxf", "a_1"}, {"body.obj", "a_2"}};
  return row;
}

inline store::JobRow some_job(const std::string& name) {
  store::JobRow row;
  row.project_id = "p_00000000000000000000";
  row.project_revision = 3;
  row.name = name;
  row.document = "{\"toile\": 1, \"name\": \"\\u00e4\"}";
  row.files = {{"body.obj", "a_2"}};
  return row;
}

/// The code of what went wrong, or "ok".
template <typename Outcome>
std::string code_of(const Outcome& outcome) {
  return outcome.ok() ? "ok" : outcome.error().code;
}

}  // namespace toile
