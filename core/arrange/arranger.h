#pragma once
// One garment on one body: which piece goes where, and the places for a choice of heights and distances.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/arrange/arrange.h"
#include "core/arrange/body_stand.h"
#include "core/arrange/flat_layout.h"

namespace toile {

/// A choice that only the whole start can judge.
struct ArrangeTrial {
  double lower = 0;       ///< m, a top below where its shoulder seams would lie on the neck's sides
  double sleeve_out = 0;  ///< m, sleeves farther out along the arms
  double away = 0;        ///< m, sheets farther from the body
};

class Arranger {
 public:
  /// `stand` and what `input` names must outlive the arranger. Error: arrange.no_seams.
  static Result<Arranger> make(const ArrangeInput& input, const BodyStand& stand);

  std::vector<ArrangeTrial> trials() const;
  Arrangement place(const ArrangeTrial& trial) const;

 private:
  static constexpr double kGap = 0.012;  ///< m, between pieces of a sheet
  static constexpr double kAway = 0.03;  ///< m, between pieces and what of the body stands out under them

  Arranger(const ArrangeInput& input, const BodyStand& stand) : input_(input), stand_(stand) {}

  void sort_pieces();
  void set_legs_over_legs();
  std::optional<Vec2> top_of_inner_seam(Index piece) const;
  BodySide side_of(Index piece) const;
  bool is_top() const;
  double rise_of_trunk(const ArrangeTrial& trial) const;
  double rise_of_top() const;
  double rise_of_bottom() const;
  std::optional<double> crotch_on_sheet() const;
  /// Free edges at the top of the trunk's pieces: their length (m) and mean height on the sheet.
  std::array<double, 2> top_edge() const;
  bool is_top_segment(Index piece, std::size_t i) const;
  double sheet_depth(int face, double rise, const ArrangeTrial& trial) const;
  void place_trunk(const ArrangeTrial& trial, double rise, Arrangement& made) const;
  FlatLayout lay_limb(BodySide side, double out) const;
  bool covers_trunk(const FlatLayout& flat, double rise) const;
  void place_limb(BodySide side, const ArrangeTrial& trial, double rise, Arrangement& made) const;
  void place_tube_sleeve(Index piece, BodySide side, const ArrangeTrial& trial, Arrangement& made) const;
  void place_hoods(double rise, Arrangement& made) const;
  FlatMove hood_pose(Index piece, BodySide side, double rise) const;
  void place_bands(double rise, Arrangement& made) const;
  double angle_of_band(Index piece, const WrappedPlacement& w) const;
  WrappedPlacement band_around(Index piece, double rise) const;
  static void put(Arrangement& made, Index piece, const Placement& placement, std::string where);
  void hold_bottoms(Arrangement& made) const;
  Vec2 mean_tie_on_trunk(Index piece, bool& any) const;

  ArrangeInput input_;
  const BodyStand& stand_;
  GarmentGraph graph_;
  FlatLayout layout_;
  std::vector<Index> trunk_, on_arms_, hoods_, bands_;  ///< bands close in themselves around trunk or neck
  std::array<std::vector<Index>, 2> limb_;              ///< flat pieces along each arm
  std::array<std::vector<Index>, 2> tube_;              ///< pieces rolled around each arm
  double top_ = 0;                                      ///< highest y of the trunk's pieces on the sheet
};

}  // namespace toile
