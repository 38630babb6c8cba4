#include "server/app/verb_tree.h"

#include <CLI/CLI.hpp>

#include "server/app/exit_codes_text.h"

namespace toile::app {
namespace {

/// "TEXT:{mm,cm}" is a value TEXT with two choices, "ENUM:value in {json->1,text->0}" one of two words. What
/// follows a colon otherwise is a check's own word.
void take_type(const std::string& type, VerbOption& option) {
  option.value = type.substr(0, type.find(':'));
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return;
  std::string word;
  for (const char c : type.substr(open + 1, close - open - 1) + ",") {
    if (c != ',') {
      word += c;
      continue;
    }
    option.choices.push_back(word.substr(0, word.find("->")));
    word.clear();
  }
}

VerbOption option_of(const CLI::Option& from) {
  VerbOption option;
  option.description = from.get_description();
  option.positional = from.get_positional();
  option.required = from.get_required();
  if (option.positional) {
    option.names = {from.get_name(true, false)};
  } else {
    for (const std::string& name : from.get_snames()) option.names.push_back("-" + name);
    for (const std::string& name : from.get_lnames()) option.names.push_back("--" + name);
  }
  if (from.get_items_expected_max() > 0) take_type(from.get_type_name(), option);
  return option;
}

std::string without_exit_codes(std::string footer) {
  const std::size_t at = footer.find(kExitCodes);
  if (at != std::string::npos) footer.erase(at);
  while (!footer.empty() && footer.back() == '\n') footer.pop_back();
  return footer;
}

Verb tree_under(const CLI::App& app, const std::string& path) {
  Verb verb{path, app.get_description(), without_exit_codes(app.get_footer()), {}, {}};
  for (const CLI::Option* option : app.get_options()) verb.options.push_back(option_of(*option));
  for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; }))
    verb.verbs.push_back(tree_under(*below, (path.empty() ? "" : path + " ") + below->get_name()));
  return verb;
}

}  // namespace

Verb verb_tree(const CLI::App& app) { return tree_under(app, ""); }

}  // namespace toile::app
