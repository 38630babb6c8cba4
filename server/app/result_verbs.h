#pragma once
// The verbs that make something of what a drape has left: which there are and what they take.

#include <optional>

#include "server/app/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library names itself so
class App;
}

namespace toile::app {

class ResultVerbs {
 public:
  /// Adds them to the command line, which must not be read when this is gone.
  explicit ResultVerbs(CLI::App& app);
  ResultVerbs(const ResultVerbs&) = delete;
  ResultVerbs& operator=(const ResultVerbs&) = delete;

  /// Does the one that the command line names; nothing where it names another verb.
  std::optional<ExitCode> run() const;

 private:
  MovieOptions movie_options_;
  RenderOptions render_options_;
  ExportOptions export_options_;
  VerifyOptions verify_options_;
  const CLI::App* movie_;
  const CLI::App* render_;
  const CLI::App* export_;
  const CLI::App* verify_;
};

}  // namespace toile::app
