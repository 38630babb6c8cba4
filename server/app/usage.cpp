#include "server/app/usage.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "server/app/console.h"

namespace toile::app {
namespace {

/// The innermost verb that was typed; the program itself where none was.
const CLI::App& typed_verb(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  return *at;
}

/// "toile pattern export", as typed.
std::string path_of(const CLI::App& verb) {
  const CLI::App* above = verb.get_parent();
  return (above == nullptr ? "" : path_of(*above) + " ") + verb.get_name();
}

/// What the library calls a missing verb is often one that it does not know.
std::string what_is_wrong(const CLI::App& verb, const CLI::ParseError& e) {
  const std::vector<std::string> rest = verb.remaining();
  const auto below = verb.get_subcommands([](const CLI::App*) { return true; });
  if (below.empty() || (!rest.empty() && rest.front().starts_with('-'))) return e.what();
  std::string names;
  for (const CLI::App* one : below) names += (names.empty() ? "" : ", ") + one->get_name();
  if (rest.empty()) return "say what \"" + path_of(verb) + "\" is to do: " + names;
  return "there is no \"" + path_of(verb) + " " + rest.front() + "\"; there are " + names;
}

}  // namespace

ExitCode instead_of_a_verb(const CLI::App& app, const CLI::ParseError& e) {
  if (e.get_exit_code() == 0) {
    app.exit(e);
    return kDone;
  }
  const CLI::App& verb = typed_verb(app);
  print_error({"usage.arguments", what_is_wrong(verb, e) + "; see " + path_of(verb) + " --help", ""}, false);
  return kBadInput;
}

}  // namespace toile::app
