#pragma once
// The body to be dressed, made ready once for all tries.

#include <span>

#include "core/collision/crossings.h"
#include "core/collision/obstacle.h"
#include "core/dressing/figure.h"
#include "core/dressing/linking.h"
#include "core/dressing/person.h"

namespace toile::dressing {

class Wearer {
 public:
  explicit Wearer(const Person& person);

  /// Drawn in by this share of its half thickness.
  SlimFigure slim(double share) const { return {&field_, &mittens_, share, margin_, figure_.floor}; }
  const collision::CrossingBody& crossing() const { return crossing_; }
  /// The body as contact will see it.
  std::span<const collision::Obstacle> obstacles() const { return {&obstacle_, 1}; }
  const Skeleton& skeleton() const { return skeleton_; }
  const measure::BodyFigure& figure() const { return figure_; }

 private:
  measure::BodyFigure figure_;
  DistanceField field_;
  Mittens mittens_;
  collision::CrossingBody crossing_;
  collision::Obstacle obstacle_;
  Skeleton skeleton_;
  double margin_;
};

}  // namespace toile::dressing
