#pragma once
// What the search for seams knows of a pattern: its outlines as runs with lengths, corner angles and shapes,
// which pieces mirror each other, and what their names say.

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile::seams {

/// A run of an outline that is sewn as a whole, or left.
struct SeamRun {
  static constexpr std::size_t kSamples = 9;

  Index panel = kNone, edge = kNone;
  double from = 0, to = 1;                          ///< fractions of the edge's length
  double length = 0;                                ///< mm
  double angle = 180;                               ///< degrees, of the cloth's corner at its start
  Index next = kNone;                               ///< run after it around the outline
  Index mirror_panel = kNone, mirror_edge = kNone;  ///< the edge that mirrors its edge, itself perhaps
  std::array<Vec2, kSamples> at;                    ///< mm, evenly along it, ends included
  std::array<double, kSamples - 1> turn;  ///< degrees from its first chord, of each chord between samples
  bool straight = true;                   ///< drawn as a line: within 0.2 % of its length
  std::vector<double> notches;            ///< mm from its start
};

/// What a piece's name says of its place, as far as it says anything.
struct PieceWords {
  int side = 0;        ///< -1 left, +1 right
  int face = 0;        ///< +1 front, -1 back
  bool limb = false;   ///< a sleeve or a cuff: left and right never meet
  bool layer = false;  ///< a lining, a facing, a pocket: cloth that lies on other cloth
};

struct SeamModel {
  std::vector<SeamRun> runs;  ///< of all outlines, panel after panel
  std::vector<Index> mirror;  ///< the run that mirrors each, itself perhaps; kNone
  /// Runs of two pieces that are drawn alike but for a few edges, as a sleeve's front and back: their lengths
  /// agree by design. Empty for each run without any.
  std::vector<std::vector<Index>> counterparts;
  /// The same run of other pieces of the same form, not turned over. Empty for each run without any.
  std::vector<std::vector<Index>> same;
  std::vector<PieceWords> words;  ///< one per panel
  std::vector<Vec2> up;           ///< unit vector of each panel's grain
  std::vector<char> upright;      ///< of each panel: whether `up` is likely to be up when it is worn
  std::vector<Index> twin;        ///< the panel that mirrors each, itself perhaps; kNone
  std::vector<double> girth;      ///< mm, length of each outline
};

/// Outlines only; holes have no runs. REQUIRES a pattern that validate() accepts.
SeamModel make_seam_model(const pattern::Pattern& pattern);

/// The model with run `r` cut at distances `cuts` (mm from its start, rising, inside it). The first part
/// keeps the index, the others stand at the end. Parts mirror each other where both edges are cut alike.
SeamModel with_cuts(const pattern::Pattern& pattern, SeamModel model, Index r,
                    const std::vector<double>& cuts);

/// The words of one name, such as "left_sleeve_f", "FrontL" or "BK-2".
PieceWords words_of(const std::string& name);

}  // namespace toile::seams
