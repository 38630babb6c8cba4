#pragma once
// How a fabric looks: its threads, and how light plays on them.

#include <cstdint>
#include <string_view>
#include <vector>

namespace toile::render {

/// What a tile of cloth shows. The numbers are written to files: they stay.
enum class Structure : std::uint8_t { kPlain = 0, kTwill, kSatin, kKnit, kNet, kFelt };
inline constexpr int kStructures = 6;

struct ClothLook {
  Structure structure = Structure::kPlain;
  float thickness = 0.5e-3f;  ///< m
  float pitch = 0.4e-3f;      ///< m from one thread, or one wale, to the next
  float roughness = 0.92f;    ///< 0, a mirror, to 1, chalk
  float sheen = 0.16f;        ///< how much fibres that stand off give back at a slant
  float uneven = 0.05f;       ///< how much threads differ in tone
  friend bool operator==(const ClothLook&, const ClothLook&) = default;
};

/// Of a fabric's words, in small letters: how it is made ("knit"), its weave ("2/1 twill") and all that is
/// said of it ("silk charmeuse satin"). Threads lie as close as cloth of this thickness (m) can have them:
/// two layers of yarn make a woven one, so a thread is half as wide as the cloth is thick; a knit's wale is
/// two yarns wide and three layers thick.
ClothLook look_from(std::string_view construction, std::string_view weave, std::string_view words,
                    double thickness);

inline constexpr int kWeaveSide = 128;   ///< pixels of a tile
inline constexpr int kWeaveThreads = 8;  ///< across a tile

/// A tile that repeats, RGBA: slope along and across the grain (128: none, 0 and 255: 45° down and up), tone
/// (its mean is 1 at 204), 255.
std::vector<std::uint8_t> weave_tile(Structure structure);

}  // namespace toile::render
