#include "core/pattern/seams/abbreviations.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "core/pattern/seams/piece_terms.h"

namespace toile::seams {
namespace {

/// What names of pieces say in English: these are shortened, too.
constexpr std::string_view kTrade[] = {
    "front",       "back",      "sleeve",      "collar",   "cuff",        "waistband", "facing",
    "lining",      "pocket",    "yoke",        "hood",     "placket",     "skirt",     "bodice",
    "pants",       "leg",       "neck",        "waist",    "hem",         "band",      "belt",
    "strap",       "tie",       "gusset",      "binding",  "interlining", "fusible",   "stand",
    "flap",        "fly",       "lapel",       "shoulder", "side",        "left",      "right",
    "undercollar", "topsleeve", "undersleeve", "ruffle",   "peplum",      "neckband",  "bottom",
    "insert",      "panel",     "upper",       "lower",    "inner",       "outer",     "patch"};

/// Words besides that are none of a piece and shorten nothing: sizes, cloth, what is done with a piece.
constexpr std::string_view kOther[] = {
    "the",      "and",   "for",     "with",   "from",   "one",  "two",        "cut",    "fold",
    "pair",     "pairs", "main",    "self",   "shell",  "size", "med",        "lrg",    "sml",
    "reg",      "std",   "alt",     "new",    "rev",    "ref",  "lot",        "mod",    "blk",
    "wht",      "top",   "tot",     "total",  "out",    "vent", "center",     "centre", "slit",
    "dart",     "half",  "body",    "base",   "block",  "lace", "mesh",       "cotton", "lin",
    "contrast", "cont",  "fabric",  "int",    "ext",    "cord", "drawstring", "gore",   "godet",
    "tier",     "frill", "flounce", "canvas", "welt",   "bag",  "stay",       "guard",  "shield",
    "loop",     "tab",   "fusing",  "piping", "crotch", "pant", "trouser",    "rib",    "knit"};

bool is_vowel(char c) { return std::string_view("aeiouy").find(c) != std::string_view::npos; }

bool is_of(std::string_view word, const auto& words) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

bool begins(std::string_view word, std::string_view term) {
  constexpr std::size_t kLeast = 4;  // letters: three begin too much
  return word.size() >= kLeast && !is_vowel(word.back()) && term.starts_with(word);
}

/// Whether the word has the term's letters in their order, without what is left out.
bool leads_through(std::string_view word, std::string_view term) {
  std::size_t met = 0;
  for (const char c : term)
    if (met < word.size() && word[met] == c) ++met;
  return met == word.size();
}

/// Whether the word is what stays of a term without vowels, so large a share of its letters at least: it goes
/// on with the next letter, or the next consonant.
bool without_vowels(std::string_view word, std::string_view term, double least_share) {
  if (static_cast<double>(word.size()) < least_share * static_cast<double>(term.size())) return false;
  if (std::count_if(word.begin(), word.end(), is_vowel) > 1 || !leads_through(word, term)) return false;
  const std::size_t consonant = static_cast<std::size_t>(
      std::find_if(term.begin() + 1, term.end(), [](char c) { return !is_vowel(c); }) - term.begin());
  return word[1] == term[1] || (consonant < term.size() && word[1] == term[consonant]);
}

bool shortens(std::string_view word, std::string_view term, double least_share) {
  return term.size() > word.size() && word.front() == term.front() &&
         (begins(word, term) || without_vowels(word, term, least_share));
}

/// The one that all are; nothing where there is none, or another.
std::optional<std::string_view> only_one(const std::vector<std::string_view>& meanings) {
  const bool one =
      !meanings.empty() && std::all_of(meanings.begin(), meanings.end(),
                                       [&](std::string_view m) { return m == meanings.front(); });
  return one ? std::optional(meanings.front()) : std::nullopt;
}

}  // namespace

bool is_common_word(std::string_view word) { return is_of(word, kTrade) || is_of(word, kOther); }

std::optional<std::string_view> spelled_out(std::string_view word) {
  constexpr std::size_t kLeastWord = 3, kLeastTerm = 5;
  constexpr double kEnglishShare = 0.4, kShare = 0.55;  // of the term's letters: many are foreign
  if (word.size() < kLeastWord || is_common_word(word)) return std::nullopt;
  std::vector<std::string_view> english, all;
  for (const std::string_view term : kTrade)
    if (shortens(word, term, kEnglishShare)) english.push_back(term);
  if (!english.empty()) return only_one(english);
  for (const PieceTerm& term : all_terms())
    if (term.theirs.size() >= kLeastTerm && shortens(word, term.theirs, kShare)) all.push_back(term.english);
  return only_one(all);
}

}  // namespace toile::seams
