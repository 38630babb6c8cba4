#include "server/app/usage.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/names.h"
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

/// Where an option was typed that the verb does not have: that, and the nearest that it has. The library
/// tells of required ones that are missing first, of which the typed one may be a slip of the pen.
std::string unknown_option(const CLI::App& verb) {
  const std::vector<std::string> rest = verb.remaining();
  const auto typed =
      std::find_if(rest.begin(), rest.end(), [](const std::string& word) { return word.starts_with("--"); });
  if (typed == rest.end() || *typed == "--") return "";
  const std::string name = typed->substr(0, typed->find('='));
  std::vector<std::string> known;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& one : option->get_lnames()) known.push_back("--" + one);
  const std::string_view near = nearest_name(name, known);
  return "there is no option " + in_quotes(name) +
         (near.empty() ? std::string() : "; did you mean " + in_quotes(near) + "?");
}

/// What the library calls a missing verb is often one that it does not know.
std::string what_is_wrong(const CLI::App& verb, const CLI::ParseError& e) {
  if (const std::string unknown = unknown_option(verb); !unknown.empty()) return unknown;
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
