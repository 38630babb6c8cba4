#pragma once
// `toile serve`, `toile worker` and `toile submit`: what they take.

#include <CLI/CLI.hpp>

#include <optional>

#include "server/app/commands.h"

namespace toile::app {

class ServiceVerbs {
 public:
  /// Adds them to `app`, which this must outlive.
  explicit ServiceVerbs(CLI::App& app);
  /// The verb that the command line names, when it is one of these.
  std::optional<ExitCode> run() const;

 private:
  ServeOptions serve_;
  WorkerOptions worker_;
  SubmitOptions submit_;
  SweepOptions sweep_;
  const CLI::App *serve_verb_, *worker_verb_, *submit_verb_, *sweep_verb_;
};

}  // namespace toile::app
