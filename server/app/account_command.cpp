#include <sys/stat.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/base/write_file.h"
#include "core/json/tree.h"
#include "server/accounts/passwords.h"
#include "server/accounts/secrets.h"
#include "server/app/account_commands.h"
#include "server/app/console.h"
#include "server/app/read_password.h"
#include "server/store/now.h"
#include "server/store/sqlite/open.h"

namespace toile::app {
namespace {

using Members = std::vector<json::JsonMember>;

/// Beside the server that has it open, or alone.
Result<std::unique_ptr<store::Store>> open_store(const std::string& folder) {
  ::umask(0077);  // as the server does: what lies there is for nobody else
  Result<std::unique_ptr<store::Store>> store = sqlite::open_sqlite_store(folder);
  if (store || store.error().kind != ErrorKind::kConflict) return store;
  return sqlite::join_sqlite_store(folder);
}

/// "2026-03-01", in UTC; "never" for 0.
std::string date_of(std::int64_t unix_ms) {
  if (unix_ms == 0) return "never";
  const auto seconds = static_cast<std::time_t>(unix_ms / 1000);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  std::string text(16, '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%d", &utc));
  return text;
}

const char* word_of(store::KeyKind kind) { return kind == store::KeyKind::kSession ? "session" : "token"; }

Members members_of(const store::AccountRow& account) {
  return {{"id", account.id},
          {"name", account.name},
          {"admin", account.admin},
          {"locked", account.locked},
          {"created_ms", static_cast<double>(account.created_ms)}};
}

Members members_of(const store::KeyRow& key) {
  return {{"id", key.id},
          {"kind", std::string(word_of(key.kind))},
          {"label", key.label},
          {"scopes", to_text(key.scopes)},
          {"created_ms", static_cast<double>(key.created_ms)},
          {"expires_ms", static_cast<double>(key.expires_ms)}};
}

void print_json(Members members) { std::printf("%s\n", json::write_json_line(std::move(members)).c_str()); }

Status print_accounts(store::Store& store, bool as_json) {
  const std::vector<store::AccountRow> accounts = TRY(store.accounts()->accounts());
  std::vector<json::JsonValue> list;
  for (const store::AccountRow& account : accounts) {
    const store::Usage usage = TRY(store.usage(store::RequestContext(account.id)));
    Members members = members_of(account);
    members.push_back({"bytes", static_cast<double>(usage.bytes)});
    members.push_back({"jobs", static_cast<double>(usage.jobs)});
    list.emplace_back(std::move(members));
    if (as_json) continue;
    std::printf("%-24s %s%s since %s, %.1f MB, %d drapes\n", account.name.c_str(),
                account.admin ? "admin, " : "", account.locked ? "locked," : "good,",
                date_of(account.created_ms).c_str(), static_cast<double>(usage.bytes) / 1e6, usage.jobs);
  }
  if (as_json) print_json({{"accounts", std::move(list)}});
  return {};
}

Status lock(store::Store& store, const std::string& name, bool locked) {
  store::AccountRow account = TRY(store.accounts()->account_named(name));
  account.locked = locked;
  return store.accounts()->change_account(account);
}

Status set_password(store::Store& store, const std::string& name, const std::string& password) {
  store::AccountRow account = TRY(store.accounts()->account_named(name));
  account.password = TRY(accounts::hash_of_password(password));
  TRY(store.accounts()->change_account(account));
  return store.accounts()->remove_keys(account.id, store::KeyKind::kSession);
}

struct NewToken {
  store::KeyRow key;
  std::string secret;
};

Result<NewToken> make_token(store::Store& store, const TokenOptions& options) {
  constexpr std::size_t kLongestLabel = 100;
  const store::AccountRow account = TRY(store.accounts()->account_named(options.account));
  store::KeyRow key;
  key.owner = account.id;
  key.label = clipped(options.label, kLongestLabel);
  key.scopes = TRY(store::scopes_from(options.scopes));
  if (key.scopes.has(store::Scope::kAdmin) && !account.admin) {
    return Error{"accounts.scope", "only accounts that were added with --admin may have the scope admin",
                 account.name};
  }
  constexpr double kDayMs = 86'400'000;
  if (options.days > 0) key.expires_ms = store::now_ms() + static_cast<std::int64_t>(options.days * kDayMs);
  std::string secret = accounts::new_secret();
  key = TRY(store.accounts()->add_key(std::move(key), accounts::hash_of_secret(secret)));
  return NewToken{std::move(key), std::move(secret)};
}

Status hand_over(const NewToken& made, const TokenOptions& options) {
  if (!options.out.empty()) {
    TRY(write_file(options.out, made.secret + "\n"));
  }
  if (options.json) {
    Members members = members_of(made.key);
    if (options.out.empty()) members.push_back({"token", made.secret});
    print_json(std::move(members));
  } else if (options.out.empty()) {
    std::printf("%s\n", made.secret.c_str());
  }
  std::fprintf(stderr, "%s of %s, good for %s, until %s; it is not shown again\n", made.key.id.c_str(),
               options.account.c_str(), to_text(made.key.scopes).c_str(),
               date_of(made.key.expires_ms).c_str());
  return {};
}

Status print_keys(store::Store& store, const TokenOptions& options) {
  const store::AccountRow account = TRY(store.accounts()->account_named(options.account));
  const std::vector<store::KeyRow> keys = TRY(store.accounts()->keys(account.id));
  std::vector<json::JsonValue> list;
  for (const store::KeyRow& key : keys) {
    list.emplace_back(members_of(key));
    if (options.json) continue;
    const bool over = key.expires_ms > 0 && key.expires_ms <= store::now_ms();
    std::printf("%s  %-8s %-18s %s %s  %s\n", key.id.c_str(), word_of(key.kind), to_text(key.scopes).c_str(),
                over ? "ended" : "until", date_of(key.expires_ms).c_str(), key.label.c_str());
  }
  if (options.json) print_json({{"keys", std::move(list)}});
  return {};
}

ExitCode ended(const Status& done, bool as_json) { return done ? kDone : fail(done.error(), as_json); }

}  // namespace

ExitCode account_add_command(const AccountOptions& options) {
  const Result<std::unique_ptr<store::Store>> store = open_store(options.data);
  if (!store) return fail(store.error(), options.json);
  store::AccountRow row;
  row.name = options.name;
  row.admin = options.admin;
  if (options.single_user) row.id = store::kSingleUser;
  const Result<store::AccountRow> added = (*store)->accounts()->add_account(std::move(row));
  if (!added) return fail(added.error(), options.json);
  if (options.json) {
    print_json(members_of(*added));
  } else {
    std::printf("%s may come in, from the server's next start on; toile token make %s gives it a token\n",
                added->name.c_str(), added->name.c_str());
  }
  return kDone;
}

ExitCode account_password_command(const AccountOptions& options) {
  const Result<std::string> password = read_password();
  if (!password) return fail(password.error(), options.json);
  const Result<std::unique_ptr<store::Store>> store = open_store(options.data);
  if (!store) return fail(store.error(), options.json);
  return ended(set_password(**store, options.name, *password), options.json);
}

ExitCode account_list_command(const AccountOptions& options) {
  const Result<std::unique_ptr<store::Store>> store = open_store(options.data);
  if (!store) return fail(store.error(), options.json);
  return ended(print_accounts(**store, options.json), options.json);
}

ExitCode account_lock_command(const AccountOptions& options, bool locked) {
  const Result<std::unique_ptr<store::Store>> store = open_store(options.data);
  if (!store) return fail(store.error(), options.json);
  return ended(lock(**store, options.name, locked), options.json);
}

ExitCode token_make_command(const TokenOptions& options) {
  const Result<std::unique_ptr<store::Store>> store = open_store(options.data);
  if (!store) return fail(store.error(), options.json);
  const Result<NewToken> made = make_token(**store, options);
  if (!made) return fail(made.error(), options.json);
  return ended(hand_over(*made, options), options.json);
}

ExitCode token_list_command(const TokenOptions& options) {
  const Result<std::unique_ptr<store::Store>> store = open_store(options.data);
  if (!store) return fail(store.error(), options.json);
  return ended(print_keys(**store, options), options.json);
}

ExitCode token_revoke_command(const TokenOptions& options) {
  const Result<std::unique_ptr<store::Store>> store = open_store(options.data);
  if (!store) return fail(store.error(), options.json);
  const Result<store::AccountRow> account = (*store)->accounts()->account_named(options.account);
  if (!account) return fail(account.error(), options.json);
  return ended((*store)->accounts()->remove_key(account->id, options.id), options.json);
}

}  // namespace toile::app
