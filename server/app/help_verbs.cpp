#include "server/app/help_verbs.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

#include "server/app/exit_codes_text.h"
#include "server/app/shell_help.h"

namespace toile::app {

HelpVerbs::HelpVerbs(CLI::App& app) : app_(app) {
  CLI::App* completion =
      app.add_subcommand("completion", "Print a script that completes toile's words in bash");
  completion->footer(
      std::string("Examples:\n"
                  "  source <(toile completion)\n"
                  "  toile completion > ~/.local/share/bash-completion/completions/toile\n"
                  "  autoload -U bashcompinit; bashcompinit; source <(toile completion)   # in zsh\n\n") +
      kExitCodes);
  CLI::App* man = app.add_subcommand("man", "Print toile's page for man");
  man->footer(std::string("Examples:\n"
                          "  toile man | man -l -\n"
                          "  toile man > ~/.local/share/man/man1/toile.1\n\n") +
              kExitCodes);
  completion_ = completion;
  man_ = man;
}

std::optional<ExitCode> HelpVerbs::run() const {
  std::string text;
  if (completion_->parsed()) text = bash_completion(verb_tree(app_));
  if (man_->parsed()) text = man_page(verb_tree(app_), TOILE_VERSION, kExitCodes);
  if (text.empty()) return std::nullopt;
  std::fwrite(text.data(), 1, text.size(), stdout);
  return kDone;
}

}  // namespace toile::app
