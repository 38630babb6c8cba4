#pragma once
// The verbs that tell of the command line itself.

#include <optional>

#include "server/app/exit_code.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library names itself so
class App;
}

namespace toile::app {

class HelpVerbs {
 public:
  /// Adds them to the command line, which must not be read when this is gone.
  explicit HelpVerbs(CLI::App& app);

  /// Does the one that the command line names; nothing where it names another verb.
  std::optional<ExitCode> run() const;

 private:
  const CLI::App& app_;
  const CLI::App* completion_;
  const CLI::App* man_;
};

}  // namespace toile::app
