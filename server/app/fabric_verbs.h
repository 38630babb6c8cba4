#pragma once
// "toile fabric …": which verbs there are and what they take. The verbs themselves are in
// fabric_*_command.cpp.

#include <optional>

#include "server/app/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library names itself so
class App;
}

namespace toile::app {

class FabricVerbs {
 public:
  /// Adds them to the command line, which must not be read when this is gone.
  explicit FabricVerbs(CLI::App& app);
  FabricVerbs(const FabricVerbs&) = delete;
  FabricVerbs& operator=(const FabricVerbs&) = delete;

  /// Does the one that the command line names; nothing where it names another verb.
  std::optional<ExitCode> run() const;

 private:
  FabricListOptions list_options_;
  FabricShowOptions show_options_;
  FabricTestOptions test_options_;
  FabricCalibrateOptions calibrate_options_;
  const CLI::App *list_, *show_, *test_, *calibrate_;
};

}  // namespace toile::app
