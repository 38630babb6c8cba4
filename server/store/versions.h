#pragma once
// Versions: states of a project that somebody gave a name, to come back to them.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/store/request_context.h"
#include "server/store/store.h"

namespace toile::store {

struct VersionRow {
  std::string id;  ///< "v_" and 20 characters; rises with time
  std::string project_id;
  std::string name;
  int revision = 0;  ///< of the project when it was named
  std::int64_t created_ms = 0;
  std::string document;  ///< the project's text then
  std::string line;      ///< the same state as edits write it; empty where that is the text
  std::map<std::string, std::string> files;  ///< file name in the document → asset id
};

/// A version with what has come of it.
struct ToldVersion {
  VersionRow version;             ///< without document and line
  bool current = false;           ///< the project stands as it did
  std::vector<std::string> jobs;  ///< drapes of this very state, newest first
};

/// Calls are thread-safe and durable, as those of Store, with its errors. What belongs to somebody else is
/// not found. Versions go with their project.
class Versions {
 public:
  static constexpr int kMostVersions = 200;  ///< of a project

  virtual ~Versions() = default;

  /// Names the state that `row` has when the project stands at revision `expected` (or expected is 0); id and
  /// time are the store's to give. Errors: store.conflict, versions.taken (the name), versions.too_many,
  /// quota.bytes.
  virtual Result<VersionRow> add_version(const RequestContext& context, VersionRow row, int expected) = 0;
  virtual Result<VersionRow> version(const RequestContext& context, const std::string& project_id,
                                     const std::string& id) = 0;
  /// Newest first.
  virtual Result<std::vector<ToldVersion>> versions(const RequestContext& context,
                                                    const std::string& project_id) = 0;
  virtual Status remove_version(const RequestContext& context, const std::string& project_id,
                                const std::string& id) = 0;
};

/// Those of a store that keeps versions; null else.
inline Versions* versions_of(Store& store) { return dynamic_cast<Versions*>(&store); }

}  // namespace toile::store
