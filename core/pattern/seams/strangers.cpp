#include "core/pattern/seams/strangers.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/pattern/curve.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/piece_language.h"

namespace toile::seams {
namespace {

constexpr double kSmall = 0.25;  // of the largest piece's area

bool is_told(const PieceWords& w) {
  return w.kind != PieceKind::kOther || w.face != 0 || w.flank || w.leg || w.limb || w.stand || w.yoke ||
         w.hem_band || w.bib || w.layer;
}

/// Whether a word of the name is one of garments' parts, although it does not say which: a "button band" is
/// known, but not to be of a front. A piece that has a zip may be any.
bool tells_anything(const std::string& name) {
  const std::vector<std::string> words = words_of_piece(name);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& w) { return w != "zip" && tells_part(w); });
}

bool is_trunk(const PieceWords& w) {
  using enum PieceKind;
  return !w.layer && (w.kind == kTorso || w.kind == kSkirt || w.kind == kLegs || w.kind == kOther);
}

/// Of each panel: whether it is small and neither its name nor its shape tells what it is, beside pieces
/// whose names tell a front and a back. Such a piece is more likely a trim than a part of the shell, and
/// among strips lengths agree by chance.
std::vector<char> find_strangers(const pattern::Pattern& pattern, const SeamModel& m) {
  std::vector<char> strangers(m.words.size(), 0);
  const auto has = [&](int face) {
    return std::any_of(m.words.begin(), m.words.end(),
                       [&](const PieceWords& w) { return is_trunk(w) && w.face == face; });
  };
  if (m.nameless || !has(1) || !has(-1)) return strangers;
  std::vector<double> area;
  for (const pattern::Panel& panel : pattern.panels)
    area.push_back(std::abs(pattern::signed_area(panel.outline)));
  const double largest = *std::max_element(area.begin(), area.end());
  for (std::size_t p = 0; p < strangers.size(); ++p)
    strangers[p] =
        !is_told(m.words[p]) && area[p] < kSmall * largest && !tells_anything(pattern.panels[p].id);
  return strangers;
}

}  // namespace

std::vector<char> sewn_last(const pattern::Pattern& pattern) {
  const SeamModel model = make_seam_model(pattern);
  std::vector<char> last = find_strangers(pattern, model);
  for (std::size_t p = 0; p < last.size(); ++p) last[p] = last[p] || model.words[p].layer;
  return last;
}

}  // namespace toile::seams
