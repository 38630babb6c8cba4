#pragma once

#include <span>
#include <string_view>

#include "core/base/types.h"

namespace toile::print {

/// A size of paper, upright (ISO 216; ANSI Y14.1 for letter).
struct Paper {
  const char* word;
  Vec2 size;  ///< mm
};

inline constexpr double kMargin = 10;  ///< mm that printers leave white

/// All of them; the first unless told otherwise.
inline constexpr Paper kPapers[] = {
    {"a4", {210, 297}}, {"a3", {297, 420}}, {"a0", {841, 1189}}, {"letter", {215.9, 279.4}}};

/// By its word; null when there is none.
inline const Paper* paper_named(std::string_view word) {
  for (const Paper& paper : kPapers)
    if (word == paper.word) return &paper;
  return nullptr;
}

/// What is printed of a page, mm.
inline Vec2 window_of(const Paper& paper) { return paper.size - Vec2{2 * kMargin, 2 * kMargin}; }

}  // namespace toile::print
