#include "server/render/legend.h"

#include <algorithm>

#include "server/render/still.h"

namespace toile::render {

void draw_legend(Image& image, const Legend& legend) {
  if (legend.colours.empty()) return;
  constexpr Rgb8 kPaper{255, 255, 255}, kInk{40, 44, 52};
  constexpr double kShare = 0.5;  // of the picture's width, and no more than of its height
  const double band =
      kShare * std::min(image.width, image.height) / static_cast<double>(legend.colours.size());
  const double letters = band / 5.5, title = 1.25 * letters;  // "-0.75" has room below its bound
  const double gap = letters, margin = 1.5 * band / 4;
  const double left = margin + 2 * gap, wide = band * static_cast<double>(legend.colours.size());
  const double foot = image.height - margin - gap;
  const double bar = foot - 1.8 * letters, top = bar - 0.5 * band;
  const double words = top - gap;
  draw_box(image, margin, words - title - gap, left + wide + 2 * gap, foot + gap, kPaper, 0.85);
  std::string heading = legend.title;
  std::transform(heading.begin(), heading.end(), heading.begin(), [](unsigned char letter) {
    return static_cast<char>(letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter);
  });
  draw_words(image, heading + "  " + legend.unit, left, words, title, kInk);
  for (std::size_t i = 0; i < legend.colours.size(); ++i) {
    const double from = left + band * static_cast<double>(i);
    draw_box(image, from, top, from + band, bar, legend.colours[i], 1);
  }
  for (std::size_t i = 0; i < legend.bounds.size(); ++i) {
    const double at = left + band * static_cast<double>(i);
    const double half = 0.5 * width_of(legend.bounds[i]) * letters;
    draw_words(image, legend.bounds[i], at - half, foot, letters, kInk);
  }
}

}  // namespace toile::render
