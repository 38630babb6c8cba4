#pragma once
// What the search for seams knows of a pattern: its outlines as runs with lengths, corner angles and shapes,
// which pieces mirror each other, and what their names say.

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/types.h"
#include "core/pattern/pattern.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::seams {

/// A run of an outline that is sewn as a whole, or left.
struct SeamRun {
  static constexpr std::size_t kSamples = 9;

  Index panel = kNone, edge = kNone;
  double from = 0, to = 1;                    ///< fractions of the edge's length
  bool from_notch = false, to_notch = false;  ///< it begins, ends inside the edge at a notch
  double length = 0;                          ///< mm
  double angle = 180;                         ///< degrees, of the cloth's corner at its start
  Index next = kNone;                         ///< run after it around the outline
  double up = 0;      ///< how much the cloth's outside at its whole edge faces up along the grain, -1 to 1
  bool side = false;  ///< faces up, and so does another edge of its length: neither is the upper end
  bool cap = false;   ///< of a sleeve's edges the one that bulges most
  bool raglan_top = false;                          ///< of a sleeve that goes up to the neck, its end there
  Index mirror_panel = kNone, mirror_edge = kNone;  ///< the edge that mirrors its edge, itself perhaps
  std::array<Vec2, kSamples> at;                    ///< mm, evenly along it, ends included
  std::array<double, kSamples - 1> turn;  ///< degrees from its first chord, of each chord between samples
  double line_turn = 0;                   ///< degrees, of its whole edge and of those that go on from it
  bool fold = false;            ///< of doubled cloth: nothing is sewn to it but the mirrored piece's
  bool open_front = false;      ///< of a pair of fronts, from the middle round into the hem
  bool straight = true;         ///< drawn as a line: within 0.2 % of its length
  std::vector<double> notches;  ///< mm from its start
};

/// Pieces of one kind and one name that numbers tell apart, as the gores of a skirt.
struct PieceRow {
  Index row = kNone, place = 0, size = 0;
};

struct SeamModel {
  std::vector<SeamRun> runs;  ///< of all outlines, panel after panel
  std::vector<Index> mirror;  ///< the run that mirrors each, itself perhaps; kNone
  /// Runs of two pieces that are drawn alike but for a few edges, as a sleeve's front and back: their lengths
  /// agree by design. Empty for each run without any.
  std::vector<std::vector<Index>> counterparts;
  /// The same run of other pieces of the same form, not turned over, and of its own piece where that is the
  /// same when it is turned around. Empty for each run without any.
  std::vector<std::vector<Index>> same;
  std::vector<PieceWords> words;  ///< one per panel
  std::vector<PieceRow> rows;     ///< one per panel
  std::vector<int> level;         ///< one per panel: of the levels of a skirt, from above
  /// Which way the file means left and right, told by pieces that have sides and faces: +1 where left pieces
  /// are the wearer's left ones seen from outside, -1 where it is the other way round, 0 where nothing tells.
  int handed = 0;
  bool tailored = false;   ///< a sleeve has an under part, by its name or by its hollow upper end
  bool raglan = false;     ///< a sleeve goes up to the neck between front and back
  bool cut_on = false;     ///< cuffs end sleeves that are cut in one with the bodice
  bool nameless = false;   ///< no name says what covers trunk, arms or legs: kinds are told by shapes
  bool open_neck = false;  ///< fronts in two halves, or a placket: what goes around the neck has ends
  bool has_band = false;   ///< a waistband: what hangs from the waist hangs from it
  /// Of each panel: it is a frill whose limb has a cuff, so that it hangs from that.
  std::vector<char> below_cuff;
  /// Of each panel: it is one of two fronts between which the garment opens, one of its runs an open front.
  std::vector<char> opens;
  /// Of each panel: which way the crotch of a leg's half faces, +1 right of the grain, -1 left; 0: it is
  /// none.
  std::vector<int> crotch_side;
  std::vector<Vec2> up;       ///< unit vector of each panel's grain
  std::vector<char> upright;  ///< of each panel: whether `up` is likely to be up when it is worn
  std::vector<Index> twin;    ///< the panel that mirrors each, itself perhaps; kNone
  /// Of each panel: another has its name's words and several of its edges, as in a wardrobe, or where a file
  /// holds a piece's lining or another version of it. Which of the two is meant nobody can tell.
  std::vector<char> rival;
  std::vector<int> lines;     ///< of each panel: edges of its outline
  std::vector<double> girth;  ///< mm, length of each outline
};

/// mm, of the whole edge that the run is of.
double edge_length(const SeamRun& run);

/// The first run of each panel, and after the last one's: runs of uncut outlines are counted panel after
/// panel.
std::vector<Index> first_runs(const pattern::Pattern& pattern);

/// The run that ends where `run` begins; `run` is one of the model's.
const SeamRun& run_before(const SeamModel& m, const SeamRun& run);

/// Outlines only; holes have no runs. REQUIRES a pattern that validate() accepts.
SeamModel make_seam_model(const pattern::Pattern& pattern);

/// The model with run `r` cut at distances `cuts` (mm from its start, rising, inside it). The first part
/// keeps the index, the others stand at the end. Parts mirror each other where both edges are cut alike.
SeamModel with_cuts(const pattern::Pattern& pattern, SeamModel model, Index r,
                    const std::vector<double>& cuts);

/// Whether a garment of these pieces opens below the neck: SeamModel::open_neck.
bool has_open_neck(const pattern::Pattern& pattern);

/// Degrees that the cloth has between the end of one edge and the start of the next.
double corner_angle(const pattern::PanelEdge& before, const pattern::PanelEdge& after);

/// Whether the run has a hollow edge on either side of it, as a shoulder has, or a brief's crotch.
bool lies_between_hollows(const SeamModel& model, const SeamRun& run);

/// How much the cloth's outside at the run faces right of the grain, -1 to 1.
double faces_right(const SeamModel& model, const SeamRun& run);

/// Whether the piece has a shoulder by its shape: a straight edge between two hollow ones, armhole and neck;
/// or two straight ones that face up, with a hollow or pointed neck between them, as where sleeves are cut
/// on. A hollow edge that begins at the hem is a side, and what is beside it a waist.
bool has_shoulder(const SeamModel& model, Index panel);

/// Whether the piece is a lapel: a collar's front that runs out in a point.
bool is_lapel(const SeamModel& model, Index panel);

/// hangs_from() of two panels: nothing hangs past a band or a cuff that is between.
int hangs_from(const SeamModel& model, Index lower, Index upper);

}  // namespace toile::seams
