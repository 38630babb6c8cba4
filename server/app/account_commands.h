#pragma once
// Who may come in, looked after where the store lies: whoever may write its folder may do all this.

#include <string>

#include "server/app/exit_code.h"

namespace toile::app {

struct AccountOptions {
  std::string data = "data";  ///< folder of the store; made when it is not there
  std::string name;
  bool admin = false;
  bool single_user = false;  ///< it has what was made before there were accounts
  bool json = false;
};

ExitCode account_add_command(const AccountOptions& options);
/// Takes a new password from stdin: from a terminal unseen and twice, else its first line. All its sessions
/// end.
ExitCode account_password_command(const AccountOptions& options);
ExitCode account_list_command(const AccountOptions& options);
/// Locked, none of its keys is good for anything; what it has stays, and drapes go on.
ExitCode account_lock_command(const AccountOptions& options, bool locked);

struct TokenOptions {
  std::string data = "data";  ///< folder of the store
  std::string account;        ///< name
  std::string id;             ///< of a token
  std::string scopes = "read,submit";
  std::string label;
  double days = 90;  ///< that it is good for; 0: for ever
  std::string out;   ///< file for it, which nobody else may read; empty: stdout
  bool json = false;
};

ExitCode token_make_command(const TokenOptions& options);
ExitCode token_list_command(const TokenOptions& options);
ExitCode token_revoke_command(const TokenOptions& options);

}  // namespace toile::app
