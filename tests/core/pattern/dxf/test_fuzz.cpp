// Random damage to files of every dialect: reading them ends with a drawing whose report sums up, or with an
// error; never with a crash, a hang or a piece that is none. Deterministic: a case is its number.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "core/pattern/validate.h"
#include "tests/core/pattern/dxf/dialects.h"
#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

/// S. Vigna's splitmix64.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(next() % n); }

 private:
  std::uint64_t state_;
};

/// The dialects, and the outside drawings where there are any.
std::vector<std::string> seeds() {
  std::vector<std::string> texts{graded_blocks(), free_lines(), nested_blocks()};
  const char* shared = std::getenv("TOILE_SHARED");
  if (shared == nullptr) return texts;
  const auto folder = std::filesystem::path(shared) / "data" / "freesewing";
  for (const char* name : {"penelope-cisFemaleAdult34.aama.dxf", "teagan-cisFemaleAdult34.aama.dxf",
                           "variants/titan-cisFemaleAdult34.r2000-line-spline-shuffled.dxf"}) {
    std::ifstream in(folder / name, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    if (!text.str().empty()) texts.push_back(text.str());
  }
  return texts;
}

/// Damages a text in one of the ways that transfers, editors and careless writers do.
void damage(std::string& text, Chance& chance) {
  static const std::vector<std::string> kValues{
      "0",     "-1",     "1e300",  "nan", "1e-300", "999999", "1",    "POINT", "EOF",    "",  "ENDSEC",
      "BLOCK", "INSERT", "VERTEX", "14",  "8",      "6",      "-0.0", "0,5",   "SEQEND", "42"};
  const std::size_t at = chance.below(text.size());
  const auto line_at = [&](std::size_t from) {
    const std::size_t begin = text.rfind('\n', from);
    const std::size_t end = text.find('\n', from);
    return std::pair{begin == std::string::npos ? 0 : begin + 1,
                     end == std::string::npos ? text.size() : end};
  };
  switch (chance.below(7)) {
    case 0:
      text[at] = static_cast<char>(chance.next());
      break;
    case 1:
      text.erase(at, 1 + chance.below(40));
      break;
    case 2: {
      const auto [begin, end] = line_at(at);
      if (begin <= end) text.replace(begin, end - begin, kValues[chance.below(kValues.size())]);
      break;
    }
    case 3:  // a part twice
      text.insert(at, text.substr(chance.below(text.size()), 1 + chance.below(400)));
      break;
    case 4: {  // an odd number of lines less: codes and values change places
      const auto [begin, end] = line_at(at);
      if (begin < end) text.erase(begin, std::min(text.size(), end + 1) - begin);
      break;
    }
    case 5:  // a coordinate moves
      if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
        text[digit] = static_cast<char>('0' + chance.below(10));
      break;
    default:
      if (chance.below(20) == 0) text.resize(at);
  }
}

bool alike(const pattern::Notch& a, const pattern::Notch& b) {
  return a.at == b.at && a.depth == b.depth && a.inwards == b.inwards;
}

/// Whether two pieces agree in what a panel's shape comes from.
bool drawn_alike(const dxf::DxfPiece& a, const dxf::DxfPiece& b) {
  return a.outline == b.outline && a.holes == b.holes && a.breaks == b.breaks &&
         a.breaks_are_edges == b.breaks_are_edges && a.turn_points == b.turn_points &&
         a.internals == b.internals && std::ranges::equal(a.notches, b.notches, alike);
}

/// The files to damage, and their pieces, each known to make a panel: curves for the thousand points of a
/// sampled one take a quarter of a second, and most damage leaves a file's pieces as they are.
struct Originals {
  std::vector<std::string> texts = seeds();
  std::vector<dxf::DxfPiece> pieces;

  bool has(const dxf::DxfPiece& piece) const {
    return std::any_of(pieces.begin(), pieces.end(),
                       [&](const auto& own) { return drawn_alike(own, piece); });
  }
};

Originals originals() {
  Originals made;
  for (const std::string& text : made.texts) {
    for (const dxf::DxfPiece& piece : read_trial(text).pieces) {
      EXPECT_TRUE(dxf::panel_from_piece(piece)) << piece.name;
      made.pieces.push_back(piece);
    }
  }
  return made;
}

void try_case(const Originals& from, std::uint64_t number) {
  Chance chance(number);
  std::string text = from.texts[chance.below(from.texts.size())];
  for (std::size_t i = 0, n = 1 + chance.below(12); i < n && !text.empty(); ++i) damage(text, chance);
  dxf::DxfSettings settings;
  settings.max_drawn_points = 20'000;
  if (chance.below(4) == 0) settings.size = "44";
  const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(text, settings);
  if (!drawing) {
    ASSERT_TRUE(drawing.error().code.starts_with("dxf.")) << number << " " << to_string(drawing.error());
    return;
  }
  const dxf::DxfReport& r = drawing->report;
  ASSERT_EQ(r.entities, r.kept + r.converted + r.dropped) << number;
  ASSERT_FALSE(drawing->pieces.empty()) << number;
  for (const dxf::DxfPiece& piece : drawing->pieces) {
    for (const Vec2 p : piece.outline) ASSERT_TRUE(is_finite(p)) << number << " " << piece.name;
    if (from.has(piece)) continue;
    const Result<pattern::Panel> panel = dxf::panel_from_piece(piece);
    ASSERT_TRUE(panel) << number << " " << piece.name << " " << to_string(panel.error());
  }
}

TEST(DxfFuzz, DamagedFilesAreReadOrRefused) {
  const Originals from = originals();
  for (std::uint64_t number = 0; number < 800 && !testing::Test::HasFatalFailure(); ++number)
    try_case(from, number);
}

TEST(LongDxfFuzz, TwentyThousandDamagedFilesAreReadOrRefused) {
  const Originals from = originals();
  for (std::uint64_t number = 1'000'000; number < 1'020'000 && !testing::Test::HasFatalFailure(); ++number)
    try_case(from, number);
}

/// A star-shaped outline of random radii, counter-clockwise.
std::vector<Vec2> random_outline(Chance& chance) {
  const std::size_t n = 4 + chance.below(60);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * double(i) / double(n), r = 250 + double(chance.below(200));
    points.push_back({500 + r * std::cos(angle), 500 + r * std::sin(angle)});
  }
  return points;
}

TEST(DxfProperty, AnOutlineInPiecesOfAnyOrderAndDirectionReadsAsItself) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Chance chance(seed);
    const std::vector<Vec2> points = random_outline(chance);
    std::vector<std::string> strokes;
    for (std::size_t i = 0, n = points.size(); i < n; ++i) {
      const Vec2 a = points[i], b = points[(i + 1) % n];
      strokes.push_back(chance.below(2) == 0 ? line(a, b, "1") : line(b, a, "1"));
    }
    for (std::size_t i = strokes.size() - 1; i > 0; --i) std::swap(strokes[i], strokes[chance.below(i + 1)]);
    std::string body;
    for (const std::string& stroke : strokes) body += stroke;
    const dxf::DxfDrawing d = read_trial(header(4) + entities(body));
    ASSERT_EQ(d.pieces.size(), 1u) << seed;
    EXPECT_NEAR(area_of(d.pieces[0]), geometry::signed_area(points), 1) << seed;
    EXPECT_EQ(d.pieces[0].outline.size(), points.size()) << seed;
  }
}

TEST(DxfProperty, AHalfUnfoldsToTwiceItsArea) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Chance chance(seed);
    std::vector<Vec2> half{{0, 0}};
    for (int i = 1; i < 20; ++i) {  // from the fold's lower end round to its upper end, away from the fold
      const double angle = -1.5707963 + 3.1415926 * i / 20, r = 250 + double(chance.below(100));
      half.push_back({std::max(20.0, r * std::cos(angle)), 400 + r * std::sin(angle)});
    }
    half.push_back({0, 800});
    std::string body = groups({{0, "LWPOLYLINE"}, {8, "1"}, {70, "1"}});
    for (const Vec2 p : half) body += groups({{10, number(p.x)}, {20, number(p.y)}});
    const dxf::DxfDrawing d =
        read_trial(header(4) + section("BLOCKS", block("A", body + line({0, 0}, {0, 800}, "6"))) +
                   entities(insert("A", {0, 0})));
    ASSERT_EQ(d.pieces.size(), 1u) << seed;
    EXPECT_TRUE(d.pieces[0].unfolded) << seed;
    EXPECT_NEAR(area_of(d.pieces[0]), 2 * std::abs(geometry::signed_area(half)), 1) << seed;
  }
}

}  // namespace
}  // namespace toile
