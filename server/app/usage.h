#pragma once
// A command line that names no verb: asked for help, or not understood.

#include "server/app/exit_code.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library names itself so
class App;
class ParseError;
}  // namespace CLI

namespace toile::app {

/// Prints what --help and --version ask for; else what is not understood, what there is instead, and where
/// to read on.
ExitCode instead_of_a_verb(const CLI::App& app, const CLI::ParseError& e);

}  // namespace toile::app
