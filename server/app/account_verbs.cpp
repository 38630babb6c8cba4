#include "server/app/account_verbs.h"

#include <string>

#include "server/app/exit_codes_text.h"

namespace toile::app {
namespace {

void add_data(CLI::App& verb, std::string& data, bool& json) {
  verb.add_option("--data", data, "Folder of the server's store")->capture_default_str();
  verb.add_flag("--json", json, "Print as JSON");
}

}  // namespace

void AccountVerbs::add_account(CLI::App& app) {
  CLI::App* account =
      app.add_subcommand("account", "Who may use a server: add accounts, list them, lock them");
  account->require_subcommand(1);
  CLI::App* add = account->add_subcommand("add", "Add an account");
  add->add_option("name", account_.name, "1 to 64 of a-z, 0-9, '.', '-' and '_'")->required();
  add->add_flag("--admin", account_.admin, "It may be given tokens that look after the whole service");
  add->add_flag("--single-user", account_.single_user,
                "It gets what was made while there were no accounts (one account can)");
  add_data(*add, account_.data, account_.json);
  add->footer(
      std::string("Once there is an account, toile serve lets in only who has one. It takes effect with the\n"
                  "server's next start.\n\n"
                  "Examples:\n"
                  "  toile account add anna --single-user --admin\n"
                  "  toile account password anna\n"
                  "  toile token make anna --out anna.token\n\n") +
      kExitCodes);
  CLI::App* password = account->add_subcommand("password", "Give an account a password, read from stdin");
  password->add_option("name", account_.name, "Account")->required();
  add_data(*password, account_.data, account_.json);
  account_password_ = password;
  CLI::App* list = account->add_subcommand("list", "List accounts, with what each keeps");
  add_data(*list, account_.data, account_.json);
  CLI::App* lock = account->add_subcommand("lock", "Let an account in no more; what it has stays");
  lock->add_option("name", account_.name, "Account")->required();
  add_data(*lock, account_.data, account_.json);
  CLI::App* unlock = account->add_subcommand("unlock", "Let an account in again, by the keys that it had");
  unlock->add_option("name", account_.name, "Account")->required();
  add_data(*unlock, account_.data, account_.json);
  account_add_ = add;
  account_list_ = list;
  account_lock_ = lock;
  account_unlock_ = unlock;
}

void AccountVerbs::add_token(CLI::App& app) {
  CLI::App* token = app.add_subcommand("token", "Tokens by which programs are known: make, list, revoke");
  token->require_subcommand(1);
  CLI::App* make = token->add_subcommand("make", "Make a token and print it, this once");
  make->add_option("account", token_.account, "Whose it is")->required();
  make->add_option("--scopes", token_.scopes, "What it is good for: read, submit, admin, with commas between")
      ->capture_default_str();
  make->add_option("--days", token_.days, "Days after which it is good for nothing; 0: never")
      ->check(CLI::Range(0.0, 36500.0))
      ->capture_default_str();
  make->add_option("--label", token_.label, "What to call it in lists");
  make->add_option("-o,--out", token_.out, "File to write it to, for its owner's eyes only");
  add_data(*make, token_.data, token_.json);
  make->footer(std::string("Of a token only a hash is kept: it cannot be shown again.\n\n"
                           "Examples:\n"
                           "  toile token make anna --out anna.token\n"
                           "  TOILE_TOKEN=$(toile token make anna --scopes read --days 1) …\n\n") +
               kExitCodes);
  CLI::App* list =
      token->add_subcommand("list", "List an account's keys: tokens, and browsers that are logged in");
  list->add_option("account", token_.account, "Account")->required();
  add_data(*list, token_.data, token_.json);
  CLI::App* revoke = token->add_subcommand("revoke", "From now on a key is good for nothing");
  revoke->add_option("account", token_.account, "Whose it is")->required();
  revoke->add_option("id", token_.id, "As toile token list names it")->required();
  add_data(*revoke, token_.data, token_.json);
  token_make_ = make;
  token_list_ = list;
  token_revoke_ = revoke;
}

AccountVerbs::AccountVerbs(CLI::App& app) {
  add_account(app);
  add_token(app);
}

std::optional<ExitCode> AccountVerbs::run() const {
  if (account_add_->parsed()) return account_add_command(account_);
  if (account_password_->parsed()) return account_password_command(account_);
  if (account_list_->parsed()) return account_list_command(account_);
  if (account_lock_->parsed()) return account_lock_command(account_, true);
  if (account_unlock_->parsed()) return account_lock_command(account_, false);
  if (token_make_->parsed()) return token_make_command(token_);
  if (token_list_->parsed()) return token_list_command(token_);
  if (token_revoke_->parsed()) return token_revoke_command(token_);
  return std::nullopt;
}

}  // namespace toile::app
