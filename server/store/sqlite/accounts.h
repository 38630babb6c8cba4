#pragma once
// Accounts and keys in the store's database. Internal to the store.

#include <mutex>
#include <string>
#include <vector>

#include "server/store/accounts.h"
#include "server/store/ids.h"
#include "server/store/sqlite/database.h"

namespace toile::sqlite {

class SqliteAccounts final : public store::Accounts {
 public:
  /// `mutex` guards the others; all are the store's.
  SqliteAccounts(std::mutex& mutex, SqlDatabase& database, store::IdSource& ids)
      : mutex_(mutex), database_(database), ids_(ids) {}

  Result<store::AccountRow> add_account(store::AccountRow row) override;
  Result<store::AccountRow> account_named(const std::string& name) override;
  Result<std::vector<store::AccountRow>> accounts() override;
  Status change_account(const store::AccountRow& row) override;
  Result<store::KeyRow> add_key(store::KeyRow row, const std::string& secret_hash) override;
  Result<store::KnownKey> key_of_secret(const std::string& secret_hash) override;
  Result<std::vector<store::KeyRow>> keys(const store::OwnerId& owner) override;
  Status remove_key(const store::OwnerId& owner, const std::string& id) override;
  Status remove_keys(const store::OwnerId& owner, store::KeyKind kind) override;

 private:
  std::mutex& mutex_;
  SqlDatabase& database_;
  store::IdSource& ids_;
};

}  // namespace toile::sqlite
