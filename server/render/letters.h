#pragma once
// Words on pictures, in strokes of even width as on a technical drawing: no font file is needed, and they
// come out alike everywhere.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/types.h"

namespace toile::render {

struct Image;

struct Stroke {
  Vec2 from, to;
};

/// Capital letters, digits, "k", "a", "m", "%", "°", ".", "-", "/" and blanks, each with its foot on y = 0,
/// as wide as two thirds of its height; letters are 1 high. Other small letters are drawn as capitals, what
/// is not known as a blank.
std::vector<Stroke> strokes_of(std::string_view text);
/// As wide as its strokes and the room between them, in heights.
double width_of(std::string_view text);

using Rgb8 = std::array<std::uint8_t, 3>;

/// Draws words with the left end of their foot at (x, y), pixels from the upper left corner, `height` pixels
/// high. What lies outside the picture is left out.
void draw_words(Image& image, std::string_view text, double x, double y, double height, Rgb8 colour);

/// Covers a rectangle of pixels; `cover` from 0 to 1 lets what was there through. On a transparent picture it
/// becomes as opaque as that.
void draw_box(Image& image, double left, double top, double right, double bottom, Rgb8 colour, double cover);

}  // namespace toile::render
