#include "core/pattern/seams/word_stems.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/pattern/seams/piece_terms.h"

namespace toile::seams {
namespace {

constexpr std::size_t kStem = 5, kEnding = 2;  // letters

/// Single words, sorted.
std::vector<PieceTerm> long_words() {
  std::vector<PieceTerm> words;
  for (const PieceTerm& term : all_terms())
    if (term.theirs.size() >= kStem && term.theirs.find(' ') == std::string_view::npos) words.push_back(term);
  std::stable_sort(words.begin(), words.end(),
                   [](const PieceTerm& a, const PieceTerm& b) { return a.theirs < b.theirs; });
  return words;
}

std::size_t in_common(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

}  // namespace

std::optional<std::string_view> english_by_stem(std::string_view word) {
  static const std::vector<PieceTerm> words = long_words();
  if (word.size() < kStem) return std::nullopt;
  const std::string_view stem = word.substr(0, kStem);
  const auto first =
      std::lower_bound(words.begin(), words.end(), stem,
                       [](const PieceTerm& term, std::string_view s) { return term.theirs < s; });
  std::optional<std::string_view> english;
  for (auto term = first; term != words.end() && term->theirs.starts_with(stem); ++term) {
    const std::size_t shared = in_common(word, term->theirs);
    if (std::max(word.size(), term->theirs.size()) > shared + kEnding) continue;
    if (english && *english != term->english) return std::nullopt;
    english = term->english;
  }
  return english;
}

}  // namespace toile::seams
