#pragma once
// How a figure of reference is stretched to another body: its tables and strokes, placed anew.

#include <vector>

#include "core/body/mannequin/figure.h"

namespace toile::mannequin {

/// Factors on a figure, one for each measure: 1 is the figure itself. Girths scale sections about their
/// height, lengths move them along the body. The height's own factor is not used: all stays in statures.
struct BodyShape {
  const Figure* figure = &female_figure();
  std::array<double, measure::kMeasureCount> factor = filled(1);
  double head = 1;  ///< size of the head against an adult's of this height; children have more
  double face = 1;  ///< how much of eyes, nose and mouth there is: 0 to 1, as triangles allow
  double arm_sine = 0.7071, arm_cosine = 0.7071;  ///< of the angle between a hanging arm and this one

  double of(measure::Measure m) const { return factor[static_cast<size_t>(m)]; }
  double& of(measure::Measure m) { return factor[static_cast<size_t>(m)]; }

  static constexpr std::array<double, measure::kMeasureCount> filled(double value) {
    std::array<double, measure::kMeasureCount> out{};
    out.fill(value);
    return out;
  }
};

/// Where joints lie, as fractions of the stature; those on the side of +x.
struct BodyJoints {
  Vec3 head_top, chin, neck, shoulder, elbow, wrist, hand_tip, hip, knee, ankle, toe;
};

/// A stretched figure, ready to become a field.
class PlacedFigure {
 public:
  explicit PlacedFigure(const BodyShape& shape);

  std::vector<LoftSection> torso, yoke, neck, head, arm, hand, leg, foot;
  SoftEllipsoid bust, buttock;
  std::vector<Stroke> strokes;  ///< in the body's frame, all of them
  Vec3 shoulder, along_arm, out_of_arm;
  Vec3 foot_origin;
  double elbow = 0, wrist = 0, hand_end = 0;  ///< along the arm
  Vec3 thumb[2];

  double height_of(double y) const;  ///< where a height of the figure has gone to
  /// About where a point of `other`, this figure stretched otherwise, lies on this one: heights and arms go
  /// along, girths stay.
  Vec3 carried_from(const PlacedFigure& other, Vec3 p) const;
  BodyJoints joints() const;

 private:
  struct Scale {
    double width, front, back;
  };

  void set_heights();
  double tape_below_bust() const;           ///< height, placed
  double figure_height_of(double y) const;  ///< the inverse of height_of
  Scale trunk_scale(double y) const;
  double leg_scale(double y) const;
  double arm_scale(double t) const;
  LoftSection leg_section(double y) const;
  void place_trunk();
  void place_neck_and_head();
  void place_arm();
  void place_leg();
  void place_masses();
  double breast_reach(double usual) const;
  void place_strokes();
  Vec3 on_trunk(Vec3 p) const;
  Vec3 on_head(Vec3 p) const;
  Vec3 on_leg(Vec3 p) const;
  Vec3 on_arm(Vec3 p) const;

  const Figure& figure_;
  BodyShape shape_;
  struct Anchor {
    double from, to;
  };
  std::vector<Anchor> heights_;
  double ribs_ = 0;  ///< the figure's height at which the underbust's factor holds
};

}  // namespace toile::mannequin
