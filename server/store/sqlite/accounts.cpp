#include "server/store/sqlite/accounts.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

#include "core/base/names.h"
#include "server/store/now.h"
#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {
namespace {

constexpr const char* kAccountColumns = "id, name, admin, locked, password, created_ms";
constexpr const char* kKeyColumns = "id, owner, kind, label, scopes, created_ms, expires_ms";

std::string_view word_of(store::KeyKind kind) {
  return kind == store::KeyKind::kSession ? "session" : "token";
}

store::AccountRow account_at(const SqlStatement& row, int first) {
  store::AccountRow account;
  account.id = row.text(first);
  account.name = row.text(first + 1);
  account.admin = row.integer(first + 2) != 0;
  account.locked = row.integer(first + 3) != 0;
  account.password = row.text(first + 4);
  account.created_ms = row.integer(first + 5);
  return account;
}

Result<store::AccountRow> account_from(const SqlStatement& row) { return account_at(row, 0); }

Result<store::KeyRow> key_from(const SqlStatement& row) {
  store::KeyRow key;
  key.id = row.text(0);
  key.owner = row.text(1);
  const std::string kind = row.text(2);
  key.kind = kind == word_of(store::KeyKind::kSession) ? store::KeyKind::kSession : store::KeyKind::kToken;
  if (kind != word_of(key.kind)) {
    return Error{"store.corrupt", "a row of the database is damaged", key.id, ErrorKind::kSystem};
  }
  key.label = row.text(3);
  key.scopes = TRY(store::scopes_from(row.text(4)));
  key.created_ms = row.integer(5);
  key.expires_ms = row.integer(6);
  return key;
}

Result<store::KnownKey> known_key_from(const SqlStatement& row) {
  constexpr int kKeyColumnCount = 7;
  const store::KeyRow key = TRY(key_from(row));
  return store::KnownKey{key, account_at(row, kKeyColumnCount)};
}

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

Status check_name(const std::string& name) {
  constexpr std::size_t kLongest = 64;
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return is_letter_or_digit(c) || c == '.' || c == '-' || c == '_';
  });
  if (plain && !name.empty() && name.size() <= kLongest && is_letter_or_digit(name.front())) return {};
  return Error{"accounts.name",
               "an account's name has 1 to 64 of a-z, 0-9, '.', '-' and '_', a letter or digit first, and " +
                   in_quotes(name) + " has not",
               ""};
}

}  // namespace

Result<store::AccountRow> SqliteAccounts::add_account(store::AccountRow row) {
  TRY(check_name(row.name));
  const std::lock_guard hold(mutex_);
  row.created_ms = store::now_ms();
  if (row.id.empty()) row.id = TRY(ids_.next('u', row.created_ms));
  const int made = TRY(database_.run(
      "INSERT INTO accounts (id, name, admin, locked, password, created_ms) VALUES (?, ?, ?, ?, ?, ?)"
      " ON CONFLICT DO NOTHING",
      {row.id, row.name, std::int64_t{row.admin}, std::int64_t{row.locked}, row.password, row.created_ms}));
  if (made == 1) return row;
  return Error{"accounts.taken",
               row.id == store::kSingleUser ? "there is an account " + in_quotes(row.name) +
                                                  ", or one that has what the single user made"
                                            : "there is an account " + in_quotes(row.name) + " already",
               "", ErrorKind::kConflict};
}

Result<store::AccountRow> SqliteAccounts::account_named(const std::string& name) {
  const std::lock_guard hold(mutex_);
  return row_of(database_.prepare(select(kAccountColumns, "FROM accounts WHERE name = ?"), {name}),
                account_from, "account", name);
}

Result<std::vector<store::AccountRow>> SqliteAccounts::accounts() {
  const std::lock_guard hold(mutex_);
  return rows_of(database_.prepare(select(kAccountColumns, "FROM accounts ORDER BY name")), account_from);
}

Status SqliteAccounts::change_account(const store::AccountRow& row) {
  const std::lock_guard hold(mutex_);
  const int changed =
      TRY(database_.run("UPDATE accounts SET admin = ?, locked = ?, password = ? WHERE id = ?",
                        {std::int64_t{row.admin}, std::int64_t{row.locked}, row.password, row.id}));
  return changed == 1 ? Status() : Status(not_found("account", row.name));
}

Result<store::KeyRow> SqliteAccounts::add_key(store::KeyRow row, const std::string& secret_hash) {
  const std::lock_guard hold(mutex_);
  row.created_ms = store::now_ms();
  row.id = TRY(ids_.next('k', row.created_ms));
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  TRY(database_.run("DELETE FROM keys WHERE expires_ms > 0 AND expires_ms <= ?", {row.created_ms}));
  const std::string scopes = to_text(row.scopes);
  TRY(
      database_.run("INSERT INTO keys (hash, id, owner, kind, label, scopes, created_ms, expires_ms)"
                    " VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
                    {secret_hash, row.id, row.owner, word_of(row.kind), row.label, scopes, row.created_ms,
                     row.expires_ms}));
  TRY(transaction.commit());
  return row;
}

Result<store::KnownKey> SqliteAccounts::key_of_secret(const std::string& secret_hash) {
  const std::lock_guard hold(mutex_);
  return row_of(
      database_.prepare(
          "SELECT k.id, k.owner, k.kind, k.label, k.scopes, k.created_ms, k.expires_ms, a.id, a.name,"
          " a.admin, a.locked, a.password, a.created_ms"
          " FROM keys k JOIN accounts a ON a.id = k.owner WHERE k.hash = ?",
          {secret_hash}),
      known_key_from, "key", "");
}

Result<std::vector<store::KeyRow>> SqliteAccounts::keys(const store::OwnerId& owner) {
  const std::lock_guard hold(mutex_);
  return rows_of(
      database_.prepare(select(kKeyColumns, "FROM keys WHERE owner = ? ORDER BY id DESC"), {owner}),
      key_from);
}

Status SqliteAccounts::remove_key(const store::OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  const int gone = TRY(database_.run("DELETE FROM keys WHERE owner = ? AND id = ?", {owner, id}));
  return gone > 0 ? Status() : Status(not_found("key", id));
}

Status SqliteAccounts::remove_keys(const store::OwnerId& owner, store::KeyKind kind) {
  const std::lock_guard hold(mutex_);
  TRY(database_.run("DELETE FROM keys WHERE owner = ? AND kind = ?", {owner, word_of(kind)}));
  return {};
}

}  // namespace toile::sqlite
