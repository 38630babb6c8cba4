#pragma once
// What the command line takes, as values: for whatever is made of it besides its own help.

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library names itself so
class App;
}

namespace toile::app {

struct VerbOption {
  std::vector<std::string> names;  ///< "-o", "--out"; of a positional its name alone
  std::string description;
  std::string value;                 ///< what it takes, e.g. "TEXT"; empty for a flag
  std::vector<std::string> choices;  ///< the only values, where there are few
  bool positional = false, required = false;
};

/// A verb, or the program itself, with the verbs below it.
struct Verb {
  std::string name;  ///< as typed: "pattern export"; empty for the program
  std::string description, notes;
  std::vector<VerbOption> options;
  std::vector<Verb> verbs;
};

/// Of the program's command line; `notes` are what stands under a verb's help, without the exit codes.
Verb verb_tree(const CLI::App& app);

}  // namespace toile::app
