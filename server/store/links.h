#pragma once
// Share links: who has one sees one job of its owner, without an account, and nothing else. Of a link's
// secret only a hash is kept, so that who reads the database can open none.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "server/store/request_context.h"

namespace toile::store {

/// What whoever has a link may take home beside looking.
struct LinkTakes {
  bool pictures = false;  ///< stills in full size, movies
  bool models = false;    ///< GLB, OBJ
  bool report = false;    ///< report.json, and the report as a page
  friend bool operator==(const LinkTakes&, const LinkTakes&) = default;
};

struct LinkRow {
  std::string id;  ///< "l_" and 20 characters; no secret
  OwnerId owner;
  std::string job;
  std::string label;  ///< what its owner calls it
  LinkTakes takes;
  std::int64_t created_ms = 0;
  std::int64_t expires_ms = 0;  ///< Unix time from which it is good for nothing; 0: never
  std::int64_t revoked_ms = 0;  ///< when it was taken back; 0: it was not
};

/// A link with what stands for its owner now.
struct KnownLink {
  LinkRow link;
  bool has_account = false;  ///< the owner has one
  bool locked = false;       ///< and it is locked
};

/// Calls are thread-safe and durable, as those of Store, with its errors.
class Links {
 public:
  static constexpr int kMost = 200;  ///< of an owner that are good

  virtual ~Links() = default;

  /// Keeps the row under the hash of its secret; id and times of creation and of taking back are the store's
  /// to give. What has been no good for a month goes. Errors: store.not_found when the owner has no such job,
  /// links.too_many.
  virtual Result<LinkRow> add_link(LinkRow row, const std::string& secret_hash) = 0;
  /// Also after it has expired or was taken back. Error: store.not_found.
  virtual Result<KnownLink> link_of_secret(const std::string& secret_hash) = 0;
  /// Those that were not taken back and whose job is there, newest first; of every job when `job` is empty.
  virtual Result<std::vector<LinkRow>> links(const OwnerId& owner, const std::string& job) = 0;
  /// Takes it back. Error: store.not_found, also for that of another owner, and the second time.
  virtual Status revoke_link(const OwnerId& owner, const std::string& id) = 0;
};

/// Whether a result file of that name may be taken home.
bool may_take(const LinkTakes& takes, std::string_view result);
/// The words of what may be taken, with commas between them: "pictures,models,report"; empty for nothing.
std::string to_text(const LinkTakes& takes);
/// Error: links.take for a word that is none.
Result<LinkTakes> takes_from(std::string_view text);

struct JobRow;
/// The job as whoever has the link sees it: under the link's id, with the results that may be taken, without
/// document, files and what else leads to other things of its owner.
JobRow shown_by(const LinkRow& link, JobRow job);

}  // namespace toile::store
