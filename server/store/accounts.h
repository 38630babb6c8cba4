#pragma once
// Who may come in: accounts, and keys by which requests are known to be theirs. Of a key only a hash is kept,
// so that who reads the database can pass for nobody.

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/store/request_context.h"
#include "server/store/scopes.h"

namespace toile::store {

struct AccountRow {
  OwnerId id;  ///< what its things belong to: "u_" and 20 characters, or kSingleUser
  std::string name;
  bool admin = false;    ///< may be given keys of scope admin
  bool locked = false;   ///< none of its keys is good for anything
  std::string password;  ///< its hash, as server/accounts/password.h makes it; empty: it has none
  std::int64_t created_ms = 0;
};

/// Owner of what the single user of a loopback has made.
inline const OwnerId kSingleUser = "local";

enum class KeyKind : std::uint8_t {
  kToken,    ///< of a program, in the header Authorization
  kSession,  ///< of a browser, in a cookie
};

struct KeyRow {
  std::string id;  ///< "k_" and 20 characters; no secret
  OwnerId owner;
  KeyKind kind = KeyKind::kToken;
  std::string label;  ///< what its owner calls it
  Scopes scopes;
  std::int64_t created_ms = 0;
  std::int64_t expires_ms = 0;  ///< Unix time from which it is good for nothing; 0: never
};

/// A key with the account whose it is.
struct KnownKey {
  KeyRow key;
  AccountRow account;
};

/// Calls are thread-safe and durable, as those of Store, with its errors.
class Accounts {
 public:
  virtual ~Accounts() = default;

  /// Keeps the row; time and, where it is empty, id are the store's to give. Errors: accounts.name for a name
  /// that is no name (1 to 64 of a-z, 0-9, '.', '-', '_', a letter or digit first), accounts.taken when there
  /// is one of that name or id.
  virtual Result<AccountRow> add_account(AccountRow row) = 0;
  /// Error: store.not_found.
  virtual Result<AccountRow> account_named(const std::string& name) = 0;
  /// By name.
  virtual Result<std::vector<AccountRow>> accounts() = 0;
  /// Writes rights, lock and password of the account of that id. Error: store.not_found.
  virtual Status change_account(const AccountRow& row) = 0;

  /// Keeps the row under the hash of its secret; id and creation time are the store's to give. What has
  /// expired by then goes.
  virtual Result<KeyRow> add_key(KeyRow row, const std::string& secret_hash) = 0;
  /// Also of a locked account, and after it has expired. Error: store.not_found.
  virtual Result<KnownKey> key_of_secret(const std::string& secret_hash) = 0;
  /// Newest first.
  virtual Result<std::vector<KeyRow>> keys(const OwnerId& owner) = 0;
  /// Error: store.not_found, also for that of another owner.
  virtual Status remove_key(const OwnerId& owner, const std::string& id) = 0;
  /// Nothing to remove is no error.
  virtual Status remove_keys(const OwnerId& owner, KeyKind kind) = 0;
};

}  // namespace toile::store
