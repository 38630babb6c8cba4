#include "core/pattern/seams/sewn_panels.h"

#include <bit>

namespace toile::seams {

SewnPanels::SewnPanels(std::size_t panels)
    : panels_(panels),
      words_((panels + kBits - 1) / kBits),
      runs_(panels * panels, 0),
      beside_(panels * words_, 0),
      left_(words_, 0) {}

/// They are neighbours now, or no longer.
void SewnPanels::flip(Index p, Index q) {
  counted_ = false;
  beside_[static_cast<std::size_t>(p) * words_ + q / kBits] ^= bit(q);
  if (p != q) beside_[static_cast<std::size_t>(q) * words_ + p / kBits] ^= bit(p);
}

void SewnPanels::add(Index p, Index q) {
  if (runs_between(p, q)++ == 0) flip(p, q);
}

void SewnPanels::remove(Index p, Index q) {
  if (--runs_between(p, q) == 0) flip(p, q);
}

int SewnPanels::parts() {
  if (!counted_) parts_ = count_parts();
  counted_ = true;
  return parts_;
}

int SewnPanels::count_parts() {
  for (std::size_t p = 0; p < panels_; ++p) left_[p / kBits] |= bit(static_cast<Index>(p));
  int parts = 0;
  for (std::size_t first = 0; first < panels_; ++first) {
    if ((left_[first / kBits] & bit(static_cast<Index>(first))) == 0) continue;
    ++parts;
    left_[first / kBits] &= ~bit(static_cast<Index>(first));
    open_.push_back(static_cast<Index>(first));
    while (!open_.empty()) {
      const Index p = open_.back();
      open_.pop_back();
      for (std::size_t w = 0; w < words_; ++w) {
        Word found = beside_[static_cast<std::size_t>(p) * words_ + w] & left_[w];
        left_[w] &= ~found;
        for (; found != 0; found &= found - 1)
          open_.push_back(static_cast<Index>(w * kBits + static_cast<std::size_t>(std::countr_zero(found))));
      }
    }
  }
  return parts;
}

}  // namespace toile::seams
