#include "core/pattern/seams/piece_language.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "core/base/latin_letters.h"
#include "core/base/text.h"
#include "core/pattern/seams/abbreviations.h"
#include "core/pattern/seams/part_codes.h"
#include "core/pattern/seams/parts_of_words.h"
#include "core/pattern/seams/piece_terms.h"
#include "core/pattern/seams/word_stems.h"

namespace toile::seams {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Whether an article of one letter stands there: "l'encolure", "d'épaule".
bool is_elided(std::string_view text, std::size_t at) {
  if (at + 1 >= text.size() || text[at + 1] != '\'' || (at > 0 && is_letter(text[at - 1]))) return false;
  return text[at] == 'l' || text[at] == 'd' || text[at] == 'L' || text[at] == 'D';
}

/// The text with a space for every such article.
std::string without_elided(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (is_elided(text, i)) text[i] = ' ';
  return text;
}

/// Signs in English, apart from each other.
std::string with_signs_told(std::string text) {
  for (const PieceTerm& t : sign_terms()) {
    for (std::size_t at = text.find(t.theirs); at != std::string::npos; at = text.find(t.theirs, at))
      text.replace(at, t.theirs.size(), " " + std::string(t.english) + " ");
  }
  return text;
}

constexpr std::string_view kArticles[] = {"de",  "du",  "des", "la",  "le",  "les", "el",    "los", "las",
                                          "del", "der", "die", "das", "dei", "di",  "della", "do",  "da"};

bool is_article(std::string_view word) {
  return std::find(std::begin(kArticles), std::end(kArticles), word) != std::end(kArticles);
}

/// Both parts of a compound; empty where neither is known.
std::string english_parts(std::string_view word) {
  std::string parts;
  for (const PieceTerm& t : beginnings_of_words()) {
    if (word.size() <= t.theirs.size() || !word.starts_with(t.theirs)) continue;
    parts = t.english;
    word.remove_prefix(t.theirs.size());
    break;
  }
  if (!parts.empty() && word == "band") return parts + " band";
  const PieceTerm* longest = nullptr;
  for (const PieceTerm& t : endings_of_words()) {
    if (!word.ends_with(t.theirs)) continue;
    if (longest == nullptr || t.theirs.size() > longest->theirs.size()) longest = &t;
  }
  if (longest != nullptr) parts += (parts.empty() ? "" : " ") + std::string(longest->english);
  return parts;
}

/// "aermel" as "armel": vowels with two dots are written so where there are none.
std::string without_transcriptions(std::string_view word) {
  std::string out;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool dotted =
        i > 0 && word[i] == 'e' && (word[i - 1] == 'a' || word[i - 1] == 'o' || word[i - 1] == 'u');
    if (!dotted) out += word[i];
  }
  return out;
}

/// Empty where neither the word nor parts of it are known, it shortens none and is no form of one: more parts
/// are more likely what is meant.
std::string english_word(const std::string& word) {
  const std::string plain = without_transcriptions(word);
  for (const std::string& spelled : {word, plain})
    if (const auto told = english_of(spelled)) return std::string(*told);
  const std::string parts = english_parts(word), plain_parts = english_parts(plain);
  if (!parts.empty() || !plain_parts.empty()) return plain_parts.size() > parts.size() ? plain_parts : parts;
  if (const auto told = spelled_out(plain)) return std::string(*told);
  return is_common_word(plain) ? "" : std::string(english_by_stem(plain).value_or(""));
}

/// "Del" is a front (delantero) and "die" a back (dietro) where no word follows that an article could belong
/// to, "on" a front of Turkish where nothing follows at all. What the copy of a piece is called besides
/// counts for nothing, nor does its size ("DEL T42").
void tell_short_faces(std::vector<std::string>& words) {
  std::vector<std::string> own = words;
  while (!own.empty() && (own.back() == "mirrored" || own.back() == "t")) own.pop_back();
  if (own.empty()) return;
  std::string& last = words[own.size() - 1];
  if (last == "die" && own.size() > 1) last = "back";
  if (last == "del" || own == std::vector<std::string>{"on"}) last = "front";
}

/// "B4410 CUFF" is the cuff of a style and of no back: a letter alone before so many digits is no word.
std::string without_style_codes(std::string name) {
  constexpr std::size_t kDigits = 3;
  const auto is = [&](std::size_t i, int (*kind)(int)) {
    return i < name.size() && kind(static_cast<unsigned char>(name[i])) != 0;
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    std::size_t digits = 0;
    while (is(i + 1 + digits, std::isdigit)) ++digits;
    if (is(i, std::isalpha) && (i == 0 || !is(i - 1, std::isalnum)) && digits >= kDigits) name[i] = ' ';
  }
  return name;
}

}  // namespace

std::vector<std::string> words_of_piece(std::string_view name) {
  std::vector<std::string> words = words_of_name(in_latin_letters(
      with_signs_told(without_elided(without_style_codes(with_code_spelled_out(std::string(name)))))));
  tell_short_faces(words);
  std::erase_if(words, [](const std::string& w) { return is_article(w); });
  std::string english;
  for (std::size_t k = 0; k < words.size(); ++k) {
    std::string told;
    if (k + 1 < words.size()) told = english_of(words[k] + " " + words[k + 1]).value_or("");
    if (!told.empty()) {
      ++k;
    } else {
      told = english_word(words[k]);
    }
    english += " " + (told.empty() ? words[k] : told);
  }
  return words_of_name(english);
}

bool tells_part(const std::string& word) {
  static const std::set<std::string> known = [] {
    std::set<std::string> words;
    for (const PieceTerm& term : all_terms())
      for (std::string& w : words_of_name(term.english)) words.insert(std::move(w));
    return words;
  }();
  return known.contains(word);
}

bool tell_both_faces(const std::vector<std::string>& words) {
  const auto has = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  return has("front") && has("back");
}

}  // namespace toile::seams
