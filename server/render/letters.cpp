#include "server/render/letters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "server/render/still.h"

namespace toile::render {
namespace {

constexpr double kWide = 4, kTall = 6, kAdvance = 6;  // of the grid that letters are drawn on
constexpr double kStroke = 0.11;                      // of the height

/// Lines of a letter: places on the grid as two digits, x and y; a comma lifts the pen.
struct Letter {
  char32_t code;
  std::string_view lines;
};

constexpr Letter kLetters[] = {
    {U'A', "00 26 40,12 32"},
    {U'B', "00 06 36 45 44 33 03,33 42 41 30 00"},
    {U'C', "45 36 16 05 01 10 30 41"},
    {U'D', "00 06 26 44 42 20 00"},
    {U'E', "46 06 00 40,03 33"},
    {U'F', "46 06 00,03 33"},
    {U'G', "45 36 16 05 01 10 30 41 43 23"},
    {U'H', "00 06,40 46,03 43"},
    {U'I', "20 26"},
    {U'J', "46 41 30 10 01"},
    {U'K', "00 06,46 03 40"},
    {U'L', "06 00 40"},
    {U'M', "00 06 23 46 40"},
    {U'N', "00 06 40 46"},
    {U'O', "10 01 05 16 36 45 41 30 10"},
    {U'P', "00 06 36 45 44 33 03"},
    {U'Q', "10 01 05 16 36 45 41 30 10,22 40"},
    {U'R', "00 06 36 45 44 33 03,23 40"},
    {U'S', "45 36 16 05 04 13 33 42 41 30 10 01"},
    {U'T', "06 46,26 20"},
    {U'U', "06 01 10 30 41 46"},
    {U'V', "06 20 46"},
    {U'W', "06 10 23 30 46"},
    {U'X', "00 46,06 40"},
    {U'Y', "06 23 46,23 20"},
    {U'Z', "06 46 00 40"},
    {U'0', "10 01 05 16 36 45 41 30 10"},
    {U'1', "15 26 20"},
    {U'2', "05 16 36 45 44 00 40"},
    {U'3', "05 16 36 45 44 33 23,33 42 41 30 10 01"},
    {U'4', "30 36 02 42"},
    {U'5', "46 06 03 33 42 41 30 10 01"},
    {U'6', "45 36 16 05 01 10 30 41 42 33 13 02"},
    {U'7', "06 46 10"},
    {U'8', "13 04 05 16 36 45 44 33 13 02 01 10 30 41 42 33"},
    {U'9', "01 10 30 41 45 36 16 05 04 13 33 44"},
    {U'k', "00 06,34 02 30"},
    {U'a', "34 30,33 24 14 03 01 10 20 31"},
    {U'm', "00 04,03 14 23 20,23 34 43 40"},
    {U'%', "00 46,06 16 15 05 06,30 40 41 31 30"},
    {U'°', "15 26 35 24 15"},
    {U'.', "20 20"},
    {U'-', "03 43"},
    {U'/', "00 46"},
};

std::vector<char32_t> codes_of(std::string_view text) {
  std::vector<char32_t> codes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool degree = text.substr(i).starts_with("°");
    codes.push_back(degree ? U'°' : static_cast<char32_t>(static_cast<unsigned char>(text[i])));
    if (degree) ++i;
  }
  return codes;
}

std::string_view lines_of(char32_t code) {
  const auto known = [&](char32_t wanted) {
    return std::find_if(std::begin(kLetters), std::end(kLetters),
                        [&](const Letter& letter) { return letter.code == wanted; });
  };
  const auto own = known(code);
  if (own != std::end(kLetters)) return own->lines;
  const bool small = code >= U'a' && code <= U'z';
  const auto capital = known(small ? code - U'a' + U'A' : code);
  return capital == std::end(kLetters) ? std::string_view() : capital->lines;
}

double distance_to(Vec2 p, const Stroke& stroke) {
  const Vec2 along = stroke.to - stroke.from;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - stroke.from, along) / squared, 0.0, 1.0) : 0;
  return length(p - (stroke.from + along * t));
}

void blend(Image& image, int x, int y, Rgb8 colour, double cover) {
  if (cover <= 0 || x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  const auto at =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
  const double below = image.opacity.empty() ? 1 : image.opacity[at] / 255.0;
  const double whole = cover + below * (1 - cover);
  for (std::size_t c = 0; c < 3; ++c) {
    std::uint8_t& channel = image.rgb[3 * at + c];
    const double mixed = (colour[c] * cover + channel * below * (1 - cover)) / whole;
    channel = static_cast<std::uint8_t>(std::lround(mixed));
  }
  if (!image.opacity.empty()) image.opacity[at] = static_cast<std::uint8_t>(std::lround(255 * whole));
}

int first_pixel(double place) { return static_cast<int>(std::floor(std::max(place, -1.0))); }
int last_pixel(double place, int side) { return static_cast<int>(std::ceil(std::min(place, side + 0.0))); }

}  // namespace

std::vector<Stroke> strokes_of(std::string_view text) {
  std::vector<Stroke> strokes;
  double left = 0;
  for (const char32_t code : codes_of(text)) {
    const std::string_view lines = lines_of(code);
    for (std::size_t i = 0; i + 5 <= lines.size(); i += 3) {
      if (lines[i + 2] == ',') continue;
      const auto place = [&](std::size_t k) {
        return Vec2{(left + (lines[k] - '0')) / kTall, (lines[k + 1] - '0') / kTall};
      };
      strokes.push_back({place(i), place(i + 3)});
    }
    left += kAdvance;
  }
  return strokes;
}

double width_of(std::string_view text) {
  const auto count = static_cast<double>(codes_of(text).size());
  return std::max(0.0, count * kAdvance - (kAdvance - kWide)) / kTall;
}

void draw_words(Image& image, std::string_view text, double x, double y, double height, Rgb8 colour) {
  const std::vector<Stroke> strokes = strokes_of(text);
  const double half = 0.5 * std::max(1.0, kStroke * height);
  for (int py = first_pixel(y - height - half); py <= last_pixel(y + half, image.height); ++py) {
    for (int px = first_pixel(x - half); px <= last_pixel(x + width_of(text) * height + half, image.width);
         ++px) {
      const Vec2 p{(px + 0.5 - x) / height, (y - py - 0.5) / height};
      double nearest = std::numeric_limits<double>::max();
      for (const Stroke& stroke : strokes) nearest = std::min(nearest, distance_to(p, stroke));
      blend(image, px, py, colour, std::clamp(half + 0.5 - nearest * height, 0.0, 1.0));
    }
  }
}

void draw_box(Image& image, double left, double top, double right, double bottom, Rgb8 colour, double cover) {
  for (int y = first_pixel(top); y < last_pixel(bottom, image.height); ++y)
    for (int x = first_pixel(left); x < last_pixel(right, image.width); ++x)
      blend(image, x, y, colour, cover);
}

}  // namespace toile::render
