#include "core/pattern/seams/named_layers.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/base/aabb.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/seams/abbreviations.h"
#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/piece_language.h"

namespace toile::seams {
namespace {

using Words = std::vector<std::string>;

/// Of a name, but for what says which copy of a piece it is: "mirrored", numbers.
Words part_words(const std::string& name) {
  Words words = words_of_piece(name);
  std::erase_if(words, [](const std::string& w) {
    return w == "mirrored" ||
           std::any_of(w.begin(), w.end(), [](unsigned char c) { return std::isdigit(c); });
  });
  std::sort(words.begin(), words.end());
  return words;
}

/// What `longer` says besides all of `shorter`; nothing where it does not say all of that.
Words besides(const Words& longer, const Words& shorter) {
  Words extra;
  if (shorter.empty() || !std::includes(longer.begin(), longer.end(), shorter.begin(), shorter.end()))
    return extra;
  std::set_difference(longer.begin(), longer.end(), shorter.begin(), shorter.end(),
                      std::back_inserter(extra));
  return extra;
}

/// Whether nobody knows the word. Shorter ones are codes of sides and sizes.
bool is_strange(const std::string& word) {
  constexpr std::size_t kLeast = 3;
  return word.size() >= kLeast && !tells_part(word) && !is_common_word(word);
}

/// The piece's outline as its runs are sampled, its grain up, within a box of one by one; `size`: mm.
std::vector<Vec2> normed_outline(const SeamModel& m, Index panel, Vec2& size) {
  const Vec2 up = m.up[panel], right{up.y, -up.x};
  std::vector<Vec2> points;
  for (const Index r : runs_of(m, panel))
    for (std::size_t k = 0; k + 1 < SeamRun::kSamples; ++k)
      points.push_back({dot(m.runs[r].at[k], right), dot(m.runs[r].at[k], up)});
  Aabb<Vec2> box;
  for (const Vec2 p : points) box.add(p);
  size = box.size();
  for (Vec2& p : points) p = {(p.x - box.low.x) / size.x, (p.y - box.low.y) / size.y};
  return points;
}

/// Of two outlines in one box the share of the area of both together that both have, the second turned over
/// or upside down where that is more.
double overlap(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  constexpr int kGrid = 24;
  double most = 0;
  for (const bool over : {false, true}) {
    for (const bool round : {false, true}) {
      int both = 0, any = 0;
      for (int i = 0; i < kGrid; ++i) {
        for (int j = 0; j < kGrid; ++j) {
          const Vec2 p{(i + 0.5) / kGrid, (j + 0.5) / kGrid};
          const bool in_a = geometry::contains(a, p);
          const bool in_b = geometry::contains(b, {over ? 1 - p.x : p.x, round ? 1 - p.y : p.y});
          both += in_a && in_b;
          any += in_a || in_b;
        }
      }
      if (any > 0) most = std::max(most, static_cast<double>(both) / any);
    }
  }
  return most;
}

/// Whether the two have one form, but for the allowances that one of them is cut with.
bool have_one_form(const SeamModel& m, Index p, Index q) {
  constexpr double kShare = 0.12, kAllowances = 25;  // of the larger one's width and height; mm
  constexpr double kOverlap = 0.85;
  Vec2 a, b;
  const std::vector<Vec2> x = normed_outline(m, p, a), y = normed_outline(m, q, b);
  const auto near = [&](double u, double v) {
    return std::abs(u - v) < std::max(kAllowances, kShare * std::max(u, v)) &&
           std::min(u, v) > 0.5 * std::max(u, v);
  };
  return near(a.x, b.x) && near(a.y, b.y) && overlap(x, y) > kOverlap;
}

}  // namespace

void find_named_layers(const pattern::Pattern& pattern, SeamModel& m) {
  const auto count = static_cast<Index>(pattern.panels.size());
  std::vector<Words> words;
  std::vector<double> area;
  for (const pattern::Panel& panel : pattern.panels) {
    words.push_back(part_words(panel.id));
    area.push_back(std::abs(pattern::signed_area(panel.outline)));
  }
  // The one word by which p's name is longer than q's; empty where it is no such name.
  const auto strange_word = [&](Index p, Index q) {
    if (m.words[q].layer) return std::string();
    const Words extra = besides(words[p], words[q]);
    return extra.size() == 1 && is_strange(extra.front()) ? extra.front() : std::string();
  };
  std::map<std::string, std::set<Words>> forms;  // that each word stands before or after
  for (Index p = 0; p < count; ++p) {
    for (Index q = 0; q < count; ++q) {
      const std::string word = strange_word(p, q);
      const bool frills = m.words[p].kind == PieceKind::kFrill;  // tiers of one form and unlike length
      if (!word.empty() && !frills && have_one_form(m, p, q)) forms[word].insert(words[q]);
    }
  }
  // One alone may be another version of that piece: "front", "front plain".
  constexpr std::size_t kSeveral = 2;
  const auto is_of_layers = [&](const std::string& word) {
    const auto met = forms.find(word);
    return met != forms.end() && met->second.size() >= kSeveral;
  };
  constexpr double kNoLarger = 1.1;
  std::vector<Index> layers;
  for (Index p = 0; p < count; ++p)
    for (Index q = 0; q < count; ++q)
      if (is_of_layers(strange_word(p, q)) && area[p] < kNoLarger * area[q]) layers.push_back(p);
  for (const Index p : layers) m.words[p].layer = true;
}

}  // namespace toile::seams
