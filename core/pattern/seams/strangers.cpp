#include "core/pattern/seams/strangers.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/curve.h"

namespace toile::seams {
namespace {

constexpr double kSmall = 0.25;  // of the largest piece's area

bool is_told(const PieceWords& w) {
  return w.kind != PieceKind::kOther || w.face != 0 || w.flank || w.leg || w.limb || w.stand || w.yoke ||
         w.hem_band || w.bib || w.layer;
}

bool is_trunk(const PieceWords& w) {
  using enum PieceKind;
  return !w.layer && (w.kind == kTorso || w.kind == kSkirt || w.kind == kLegs || w.kind == kOther);
}

}  // namespace

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
    strangers[p] = !is_told(m.words[p]) && area[p] < kSmall * largest;
  return strangers;
}

std::vector<char> sewn_last(const pattern::Pattern& pattern) {
  const SeamModel model = make_seam_model(pattern);
  std::vector<char> last = find_strangers(pattern, model);
  for (std::size_t p = 0; p < last.size(); ++p) last[p] = last[p] || model.words[p].layer;
  return last;
}

}  // namespace toile::seams
