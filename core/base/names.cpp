#include "core/base/names.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace toile {

std::string clipped(std::string_view text, std::size_t limit) {
  std::string out(text.substr(0, limit));
  for (char& c : out) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  if (text.size() > limit) out += "...";
  return out;
}

std::string in_quotes(std::string_view text) { return '"' + clipped(text) + '"'; }

namespace {

/// Insertions, deletions and changes of one letter and swaps of two neighbours that turn `a` into `b`
/// (optimal string alignment).
std::size_t letter_changes(std::string_view a, std::string_view b) {
  std::vector<std::size_t> older, old, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    older = std::exchange(old, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = old[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({change, old[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], older[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string_view nearest_name(std::string_view name, std::span<const std::string> names) {
  name = name.substr(0, 60);  // a longer name is near to nothing, and must cost nothing
  std::string_view best;
  // A third of its letters wrong, and it is another word.
  std::size_t fewest = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string& candidate : names) {
    const std::size_t changes = letter_changes(name, std::string_view(candidate).substr(0, 60));
    if (changes < fewest) {
      fewest = changes;
      best = candidate;
    }
  }
  return best;
}

std::string advice(std::string_view name, std::span<const std::string> names) {
  constexpr std::size_t kMostNames = 12;
  if (names.empty()) return "there are none";
  const std::string_view near = nearest_name(name, names);
  std::string out = near.empty() ? "" : "did you mean " + in_quotes(near) + "? ";
  out += names.size() == 1 ? "there is " : "there are ";
  for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i) {
    out += (i > 0 ? ", " : "") + in_quotes(names[i]);
  }
  if (names.size() > kMostNames) out += " and " + std::to_string(names.size() - kMostNames) + " more";
  return out;
}

}  // namespace toile
