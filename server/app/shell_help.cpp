#include "server/app/shell_help.h"

#include <algorithm>
#include <vector>

namespace toile::app {
namespace {

void add_all(const Verb& verb, std::vector<const Verb*>& all) {
  all.push_back(&verb);
  for (const Verb& below : verb.verbs) add_all(below, all);
}

/// The program and all its verbs, each before those below it.
std::vector<const Verb*> all_verbs(const Verb& program) {
  std::vector<const Verb*> all;
  add_all(program, all);
  return all;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// What may be typed after a verb: the verbs below it and its options.
std::string words_after(const Verb& verb) {
  std::vector<std::string> words;
  for (const Verb& below : verb.verbs) words.push_back(below.name.substr(below.name.rfind(' ') + 1));
  for (const VerbOption& option : verb.options)
    if (!option.positional) words.insert(words.end(), option.names.begin(), option.names.end());
  return joined(words, " ");
}

/// Each of its names after the verb, as a pattern of bash's case.
std::string case_of(const Verb& verb, const VerbOption& option) {
  std::vector<std::string> patterns;
  for (const std::string& name : option.names) patterns.push_back("\"" + verb.name + " " + name + "\"");
  return joined(patterns, " | ");
}

/// roff reads a line's first '.' or ''' as a request, and '\' as an escape; '-' is a hyphen unless escaped.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool first = out.empty() || out.back() == '\n';
    if (first && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

std::string option_entry(const VerbOption& option) {
  std::string head;
  for (const std::string& name : option.names)
    head += (head.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  const std::string value = option.choices.empty() ? option.value : joined(option.choices, "|");
  if (!option.positional && !value.empty()) head += " \\fI" + roff(value) + "\\fR";
  if (option.required) head += " (required)";
  return ".TP\n" + head + "\n" + roff(option.description) + "\n";
}

/// Lines stand as they are, since the notes hold commands.
std::string as_it_stands(const std::string& text) { return ".PP\n.nf\n" + roff(text) + "\n.fi\n"; }

std::string verb_entry(const Verb& verb) {
  std::string text = ".SS \"toile " + roff(verb.name) + "\"\n" + roff(verb.description) + ".\n";
  for (const bool positional : {true, false})
    for (const VerbOption& option : verb.options)
      if (option.positional == positional) text += option_entry(option);
  if (!verb.notes.empty()) text += as_it_stands(verb.notes);
  return text;
}

}  // namespace

std::string bash_completion(const Verb& program) {
  const std::vector<const Verb*> verbs = all_verbs(program);
  std::vector<std::string> paths;
  std::string values, words;
  for (const Verb* verb : verbs) {
    if (!verb->name.empty()) paths.push_back("\"" + verb->name + "\"");
    for (const VerbOption& option : verb->options) {
      if (option.choices.empty() || option.positional) continue;
      values += "    " + case_of(*verb, option) + ") COMPREPLY=($(compgen -W \"" +
                joined(option.choices, " ") + "\" -- \"$cur\")); return ;;\n";
    }
    const bool ends = verb->verbs.empty();  // what follows, but for options, is a file or a name
    words += "    \"" + verb->name + "\") words=\"" + words_after(*verb) + "\"" +
             (ends ? "; [[ $cur == -* ]] || words='' ;;\n" : " ;;\n");
  }
  return "# toile for bash: source <(toile completion). Files are completed where nothing else fits.\n"
         "_toile() {\n"
         "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} path='' words='' word\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case \"${path:+$path }$word\" in\n"
         "    " +
         joined(paths, " | ") +
         ") path=\"${path:+$path }$word\" ;;\n"
         "    esac\n"
         "  done\n"
         "  case \"$path $prev\" in\n" +
         values +
         "  esac\n"
         "  case \"$path\" in\n" +
         words +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n"
         "}\n"
         "complete -o default -F _toile toile\n";
}

std::string man_page(const Verb& program, const std::string& version, const std::string& exit_codes) {
  std::string text = ".\\\" -*- coding: utf-8 -*-\n.TH TOILE 1 \"\" \"toile " + roff(version) +
                     "\"\n.SH NAME\ntoile \\- drapes garments from flat sewing patterns\n"
                     ".SH SYNOPSIS\n.B toile\n\\fIVERB\\fR [\\fIOPTION\\fR...]\n.SH DESCRIPTION\n" +
                     roff(program.description) + "\n" + as_it_stands(program.notes) + ".SH VERBS\n";
  for (const Verb* verb : all_verbs(program))
    if (!verb->name.empty() && verb->verbs.empty()) text += verb_entry(*verb);
  return text + ".SH \"EXIT STATUS\"\n" + roff(exit_codes);
}

}  // namespace toile::app
