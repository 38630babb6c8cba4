#pragma once
// A garment under way by the method of Kim and Park 2003. One step: a first guess from equations 3 and 4;
// passes of links, seams and held particles; bending; then the paths of all particles against cloth and
// bodies.

#include <span>
#include <vector>

#include "core/paper/candidates.h"
#include "core/paper/particles.h"
#include "core/paper/settings.h"
#include "core/paper/solids.h"
#include "core/sewing/notion_places.h"

namespace toile::paper {

/// A particle that is moved to its place ("attachment").
struct Held {
  Index particle = kNone;
  bool height_only = false;
  Vec3 place;  ///< m
};

/// A point of the cloth that is moved to the nearest point of a goal (core/sewing/attachment.h).
struct Led {
  sewing::ClothPoint point;
  const std::vector<Vec3>* goal = nullptr;  ///< m
};

/// What acts on the cloth in a step.
struct StepForces {
  double gravity = 0;  ///< m/s², downwards
  double closing =
      1;  ///< share of the way to their midpoint that sewn particles go, and led ones to their goal
};

/// What a step needs of those before it.
struct PaperState {
  std::vector<Vec3> positions, previous;  ///< m
  std::vector<double> bent;               ///< δ of each fan in the step before
};

class PaperCloth {
 public:
  PaperCloth(Particles particles, Solids solids, const PaperSettings& settings, std::vector<Vec3> positions);

  void set_held(std::vector<Held> held);
  void set_led(std::vector<Led> led) { led_ = std::move(led); }

  void step(const StepForces& forces);
  /// Brings what begins nearer to a body than cloth lies to where it lies: paths are tried from outside only.
  void come_out();

  const std::vector<Vec3>& positions() const { return state_.positions; }
  const PaperState& state() const { return state_; }
  /// REQUIRES as many particles and fans.
  void restore(PaperState state) { state_ = std::move(state); }
  const Particles& particles() const { return particles_; }
  bool finite() const;

 private:
  struct Stopped {
    Vec3 place, way;  ///< m; the way is that of the step, as it is mirrored and kept
    bool struck = false;
  };

  void guess(double gravity);
  void pull_links(bool backwards);
  void sew(double closing);
  void hold(double closing);
  void keep(const std::vector<Held>& held);
  void bend();
  void strike_cloth();
  bool strike_triangle(Index particle);
  void note_path(Index particle);
  void strike_solids();
  Stopped stopped_by_solids(Index particle, Vec3 from, Vec3 aim) const;

  Particles particles_;
  Solids solids_;
  PaperSettings settings_;
  Candidates candidates_;
  std::vector<Held> held_;
  std::vector<Held> held_by_seams_;  ///< what is sewn to them, and goes along once the seams are shut
  std::vector<Led> led_;
  PaperState state_;
  std::vector<geometry::Box3> paths_;  ///< of each particle, in the step under way
};

/// δ of a fan, its particles being at `x`.
double deformation(const Fans& fans, Index fan, std::span<const Vec3> x);

}  // namespace toile::paper
