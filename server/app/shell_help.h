#pragma once
// The command line for shells and for man, made of what it takes: nothing is written twice.

#include <string>

#include "server/app/verb_tree.h"

namespace toile::app {

/// A script for bash (4 or later) that completes verbs, options and their choices, and files elsewhere. zsh
/// takes it after `autoload -U bashcompinit; bashcompinit`.
std::string bash_completion(const Verb& program);

/// toile(1) for man, as roff with the macros of man(7). `exit_codes` is a paragraph.
std::string man_page(const Verb& program, const std::string& version, const std::string& exit_codes);

}  // namespace toile::app
