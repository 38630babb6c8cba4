#pragma once
// Share links in the store's database. Internal to the store.

#include <mutex>
#include <string>
#include <vector>

#include "server/store/ids.h"
#include "server/store/links.h"
#include "server/store/sqlite/database.h"

namespace toile::sqlite {

class SqliteLinks final : public store::Links {
 public:
  /// `mutex` guards the others; all are the store's.
  SqliteLinks(std::mutex& mutex, SqlDatabase& database, store::IdSource& ids)
      : mutex_(mutex), database_(database), ids_(ids) {}

  Result<store::LinkRow> add_link(store::LinkRow row, const std::string& secret_hash) override;
  Result<store::KnownLink> link_of_secret(const std::string& secret_hash) override;
  Result<std::vector<store::LinkRow>> links(const store::OwnerId& owner, const std::string& job) override;
  Status revoke_link(const store::OwnerId& owner, const std::string& id) override;

 private:
  std::mutex& mutex_;
  SqlDatabase& database_;
  store::IdSource& ids_;
};

}  // namespace toile::sqlite
