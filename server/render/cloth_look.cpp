#include "server/render/cloth_look.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace toile::render {
namespace {

constexpr double kThreadShare = 0.6;  // of a woven cloth's thickness: threads flatten where they cross
constexpr double kWaleShare = 1.3;    // of a knit's thickness
constexpr double kMeshShare = 6;      // of a net's
constexpr double kFinest = 0.08e-3, kCoarsest = 2.5e-3;  // m
constexpr double kRelief = 0.30;                         // of a thread's width: how far it stands up
constexpr double kMeanTone = 204;

Structure structure_of(std::string_view construction, std::string_view weave) {
  const auto has = [weave](std::string_view word) { return weave.find(word) != std::string_view::npos; };
  if (construction == "knit") return Structure::kKnit;
  if (construction == "net") return Structure::kNet;
  if (construction != "woven" && !construction.empty()) return Structure::kFelt;
  if (has("pile")) return Structure::kFelt;
  if (has("twill")) return Structure::kTwill;
  return has("satin") ? Structure::kSatin : Structure::kPlain;
}

struct Finish {
  std::string_view words;  // separated by |
  float roughness, sheen;
};
constexpr std::array kFinishes{
    Finish{"leather", 0.50f, 0.0f},
    Finish{"satin|charmeuse", 0.44f, 0.10f},
    Finish{"habotai|taffeta|organza|nylon|swim|tricot", 0.58f, 0.08f},
    Finish{"velvet|pile|fleece|felt|flannel|raised|wool", 1.0f, 0.45f},
    Finish{"knit|jersey|rib|interlock|ponte", 0.96f, 0.24f},
};

bool has_one_of(std::string_view text, std::string_view words) {
  while (true) {
    const std::size_t end = words.find('|');
    if (text.find(words.substr(0, end)) != std::string_view::npos) return true;
    if (end == std::string_view::npos) return false;
    words.remove_prefix(end + 1);
  }
}

double pitch_of(Structure structure, double thickness) {
  const double share = structure == Structure::kKnit  ? kWaleShare
                       : structure == Structure::kNet ? kMeshShare
                                                      : kThreadShare;
  return std::clamp(share * thickness, kFinest, kCoarsest);
}

float unevenness(Structure structure) {
  switch (structure) {
    case Structure::kPlain:
      return 0.024f;
    case Structure::kTwill:
      return 0.018f;
    case Structure::kFelt:
      return 0.016f;
    case Structure::kSatin:
    case Structure::kKnit:
    case Structure::kNet:
      return 0.010f;
  }
  return 0;
}

double fraction(double x) { return x - std::floor(x); }

/// A round thread along x or across, whichever lies over the other; it dips where it goes under.
double over(double x, double y, bool across) {
  const double side = across ? y : x, along = across ? x : y;
  return std::sin(kPi * fraction(side)) * (0.6 + 0.4 * std::sin(kPi * fraction(along)));
}

/// Height of the cloth at a place of the tile, both 0 to 8 threads; 0 to 1.
double height(Structure structure, double x, double y) {
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  switch (structure) {
    case Structure::kPlain:
      return over(x, y, (i + j) % 2 == 0);
    case Structure::kTwill:
      return over(x, y, (i + j) % 4 < 1);
    case Structure::kSatin:
      return over(x, y, (i + 3 * j) % 8 == 0);
    case Structure::kKnit: {  // loops in wales, each leg slanting to the middle of its wale
      const double leg = std::abs(fraction(x) - 0.5) * 2;  // 1 between wales
      const double course = fraction(y * 1.25 + 0.45 * leg);
      return std::sqrt(std::max(0.0, std::sin(kPi * leg * 0.92 + 0.12))) *
             (0.55 + 0.45 * std::sin(kPi * course));
    }
    case Structure::kNet:
      return std::max(std::pow(std::abs(std::cos(kPi * x)), 8), std::pow(std::abs(std::cos(kPi * y)), 8));
    case Structure::kFelt:
      return 0.5 + 0.25 * (std::sin(kPi * (1.5 * x + 0.6 * std::sin(kPi * 0.5 * y))) +
                           std::sin(kPi * (1.25 * y + 0.6 * std::sin(kPi * 0.75 * x))));
  }
  return 0;
}

}  // namespace

ClothLook look_from(std::string_view construction, std::string_view weave, std::string_view words,
                    double thickness) {
  ClothLook look;
  look.structure = structure_of(construction, weave);
  look.thickness = static_cast<float>(thickness);
  look.pitch = static_cast<float>(pitch_of(look.structure, thickness));
  look.uneven = unevenness(look.structure);
  const auto found = std::find_if(kFinishes.begin(), kFinishes.end(),
                                  [words](const Finish& finish) { return has_one_of(words, finish.words); });
  if (found == kFinishes.end()) return look;
  look.roughness = found->roughness;
  look.sheen = found->sheen;
  return look;
}

std::vector<std::uint8_t> weave_tile(Structure structure) {
  constexpr double kPixel = static_cast<double>(kWeaveThreads) / kWeaveSide;  // threads
  const auto at = [&](int i, int j) {
    const auto place = [](int k) { return ((k + kWeaveSide) % kWeaveSide) * kPixel; };
    return height(structure, place(i), place(j));
  };
  double mean = 0;
  for (int j = 0; j < kWeaveSide; ++j)
    for (int i = 0; i < kWeaveSide; ++i) mean += at(i, j) / (kWeaveSide * kWeaveSide);
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
  };
  std::vector<std::uint8_t> pixels;
  pixels.reserve(4UL * kWeaveSide * kWeaveSide);
  for (int j = 0; j < kWeaveSide; ++j) {
    for (int i = 0; i < kWeaveSide; ++i) {
      const double along = kRelief * (at(i + 1, j) - at(i - 1, j)) / (2 * kPixel);
      const double across = kRelief * (at(i, j + 1) - at(i, j - 1)) / (2 * kPixel);
      const double tone = 1 + 0.35 * (at(i, j) - mean);
      pixels.insert(pixels.end(),
                    {byte(128 + 127 * along), byte(128 + 127 * across), byte(kMeanTone * tone), 255});
    }
  }
  return pixels;
}

}  // namespace toile::render
