#pragma once
// "toile pattern …": which verbs there are and what they take. The verbs themselves are in
// pattern_command.cpp.

#include <optional>

#include "server/app/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library names itself so
class App;
}

namespace toile::app {

class PatternVerbs {
 public:
  /// Adds them to the command line, which must not be read when this is gone.
  explicit PatternVerbs(CLI::App& app);
  PatternVerbs(const PatternVerbs&) = delete;
  PatternVerbs& operator=(const PatternVerbs&) = delete;

  /// Does the one that the command line names; nothing where it names another verb.
  std::optional<ExitCode> run() const;

 private:
  PatternImportOptions import_options_;
  PatternLayersOptions layers_options_;
  PatternExportOptions export_options_;
  const CLI::App *import_, *layers_, *export_;
};

}  // namespace toile::app
