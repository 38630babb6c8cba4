#pragma once
// `toile account` and `toile token`: what they take.

#include <CLI/CLI.hpp>

#include <optional>

#include "server/app/account_commands.h"

namespace toile::app {

class AccountVerbs {
 public:
  /// Adds them to `app`, which this must outlive.
  explicit AccountVerbs(CLI::App& app);
  /// The verb that the command line names, when it is one of these.
  std::optional<ExitCode> run() const;

 private:
  void add_account(CLI::App& app);
  void add_token(CLI::App& app);

  AccountOptions account_;
  TokenOptions token_;
  const CLI::App *account_add_ = nullptr, *account_list_ = nullptr, *account_lock_ = nullptr,
                 *account_password_ = nullptr, *account_unlock_ = nullptr;
  const CLI::App *token_make_ = nullptr, *token_list_ = nullptr, *token_revoke_ = nullptr;
};

}  // namespace toile::app
