#pragma once
// One garment on one body: which piece goes where, and the places for a choice of heights and distances.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/arrange/arrange.h"
#include "core/arrange/arrange_plan.h"
#include "core/arrange/body_stand.h"
#include "core/arrange/sleeve_places.h"

namespace toile::arrange {

/// A choice that only the whole start can judge.
struct ArrangeTrial {
  double lower = 0;       ///< m, a top below where its shoulder seams would lie on the neck's sides
  double sleeve_out = 0;  ///< m, sleeves farther out along the arms
  double away = 0;        ///< m, sheets farther from the body
};

/// Of a circle, that a piece which closes around a neck or an arm covers at least where it begins: the way
/// that closes it would be shorter beside the limb.
inline constexpr double kLeastAround = 0.75;

inline constexpr double kBelowArmpit = 0.02;  ///< m, where sides without shoulders end

class Arranger {
 public:
  /// `stand` must outlive the arranger. Error: arrange.no_seams.
  static Result<Arranger> make(const ArrangeInput& input, const BodyStand& stand);

  std::vector<ArrangeTrial> trials() const;
  Arrangement place(const ArrangeTrial& trial) const;

 private:
  static constexpr double kAway = 0.03;  ///< m, between pieces and what of the body stands out under them

  /// Where one piece goes, and that in words.
  struct Placed {
    Index piece = kNone;
    sewing::Placement placement;
    std::string where;
  };

  struct Hanging;
  struct Stitches;

  Arranger(ArrangePlan plan, const BodyStand& stand) : plan_(std::move(plan)), stand_(stand) {}

  bool is_top() const;
  double rise_of_trunk(const ArrangeTrial& trial) const;
  double rise_of_top() const;
  double rise_of_bottom() const;
  std::optional<double> crotch_on_sheet() const;
  /// Free edges at the top of the trunk's pieces: their length (m) and mean height on the sheet.
  std::array<double, 2> top_edge() const;
  bool is_top_segment(Index piece, std::size_t i) const;
  bool is_top_of_leg(Index piece, std::size_t i) const;
  double sheet_depth(int face, double rise, const ArrangeTrial& trial) const;
  FlatLayout lay_limb(measure::BodySide side, double out) const;
  bool covers_trunk(const FlatLayout& flat, double rise) const;
  FlatMove hood_pose(Index piece, measure::BodySide side, double rise) const;
  bool tells_of_band(Index piece, Index other) const;
  double angle_of_band(Index piece, const sewing::WrappedPlacement& w) const;
  sewing::WrappedPlacement band_at(Index piece, double lowest) const;
  sewing::WrappedPlacement band_around(Index piece, double rise) const;
  std::array<double, 2> depth_over_legs() const;
  sewing::WrappedPlacement around_leg(Index piece, const LegPiece& leg, double away) const;
  Stitches stitches_to_legs(Index piece, const std::vector<Placed>& placed) const;
  static double angle_to(const Stitches& stitches, const sewing::WrappedPlacement& w);
  std::optional<sewing::WrappedPlacement> band_on_legs(Index piece, const std::vector<Placed>& legs) const;
  std::optional<sewing::WrappedPlacement> cuff_on_leg(Index piece, const std::vector<Placed>& placed) const;
  sewing::WrappedPlacement tube_around(Index piece) const;
  std::optional<sewing::WrappedPlacement> band_upon(Index piece, const std::vector<Placed>& places) const;
  void hang_by(const std::vector<Vec2>& sewn, bool downwards, Index piece, sewing::WrappedPlacement& w) const;
  std::optional<Vec2> mean_tie_on_trunk(Index piece) const;

  // The places of each kind of piece; `rise`: m, added to heights on the sheet.
  std::vector<Placed> trunk_places(const ArrangeTrial& trial, double rise) const;
  std::vector<Placed> limb_places(measure::BodySide side, const ArrangeTrial& trial, double rise) const;
  std::optional<Hanging> hanging_on_arm(Index piece) const;
  std::vector<int> steps_from_trunk() const;
  double out_of_tube(Index piece, const SleeveLine& line, measure::BodySide side, double out) const;
  Placed tube_place(Index piece, measure::BodySide side, const ArrangeTrial& trial) const;
  std::vector<Placed> hood_places(double rise) const;
  std::vector<Placed> leg_places(const ArrangeTrial& trial) const;
  std::vector<Placed> band_places(double rise, const std::vector<Placed>& legs,
                                  const std::vector<Placed>& trunk) const;
  std::vector<Placed> gore_places(double rise) const;
  std::vector<sewing::Attachment> holds() const;

  ArrangePlan plan_;  ///< never changes
  const BodyStand& stand_;
};

}  // namespace toile::arrange
