#include "core/solver/cloth_solver.h"

#include <algorithm>
#include <numeric>

#include "core/base/check.h"
#include "core/base/crew.h"
#include "core/solver/constraints/contact_pass.h"
#include "core/solver/constraints/restitution.h"
#include "core/solver/constraints/viscosity.h"

namespace toile::solver {

namespace {

/// Runs of vertices into planes, per vertex of the cloth and summed over steps, before they are measured
/// again and have their way back. What few planes hold for long would hang in the air as on pins.
constexpr double kPlaneHitShare = 0.03;

/// What is near a bound costs a look in each step, and may be near it by now for nothing: measured along with
/// others after so many.
constexpr Index kNearSteps = 16;

/// Of its trust region, how far a vertex is from its centre that is measured along with others: it would soon
/// ask for it.
constexpr double kFarShare = 0.35;

/// Of the cloth, a part above which all of it is measured: less work than looking for each.
constexpr double kMostMeasuredAlone = 0.25;

/// Of the mean edge, the largest trust region. A sheet that moves as a whole moves towards where its own
/// triangles stood: with larger regions it ran into their division planes first, which ask for nothing, and
/// slid at a third of its speed.
constexpr double kTrustShare = 0.25;

/// Vertices that are not worth a helper.
constexpr std::size_t kFewVertices = 4096;

double mean_edge(const ClothModel& model) {
  double sum = 0;
  for (const RestTriangle& r : model.rest) {
    sum += length(r[1] - r[0]) + length(r[2] - r[1]) + length(r[0] - r[2]);
  }
  return model.rest.empty() ? 0.01 : sum / (3.0 * static_cast<double>(model.rest.size()));
}

}  // namespace

collision::ContactSettings contact_settings(const ClothModel& model) {
  collision::ContactSettings settings;
  const double edge = mean_edge(model);
  settings.thickness = 0;
  settings.cloth_friction = 0;
  for (const material::Fabric& f : model.fabrics) {
    settings.thickness = std::max(settings.thickness, f.thickness);
    settings.cloth_friction = std::max(settings.cloth_friction, f.friction);
  }
  settings.thickness = std::min(settings.thickness, 0.3 * edge);
  settings.vertex_thickness.assign(model.mass.size(), settings.thickness);
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const RestTriangle& r = model.rest[t];
    const double longest = std::max({length(r[1] - r[0]), length(r[2] - r[1]), length(r[0] - r[2])});
    const double most = rest_area(r) / longest;  // half the least height
    for (const Index v : model.triangles[t])
      settings.vertex_thickness[v] = std::min(settings.vertex_thickness[v], most);
  }
  settings.trust_radius_most = kTrustShare * edge;
  settings.trust_radius_least = std::min(settings.trust_radius_least, settings.trust_radius_most);
  return settings;
}

ClothSolver::ClothSolver(ClothModel model, std::vector<Vec3> positions,
                         std::span<const collision::Obstacle> obstacles, double time_step,
                         std::span<const Vec3> layout)
    : model_(std::move(model)),
      obstacles_(obstacles),
      h_(time_step),
      membrane_(model_),
      bending_(model_),
      x_(std::move(positions)),
      finder_(collision::make_surface(model_.triangles, model_.vertex_count(), model_.vertex_class),
              obstacles_, contact_settings(model_)) {
  TOILE_CHECK(x_.size() == model_.mass.size());
  TOILE_CHECK(h_ > 0);
  set_holds({});
  velocity_.resize(x_.size());
  depenetration_.resize(x_.size());
  speed_.resize(x_.size());
  stopped_.resize(x_.size());
  steps_near_.resize(x_.size());
  stuck_.resize(x_.size());
  for (const collision::Obstacle& obstacle : obstacles_) bouncy_ |= obstacle.restitution > 0;
  if (layout.empty()) layout = x_;
  finder_.detect(layout, speed_, contacts_);  // lays out its tree
}

void ClothSolver::set_stitches(std::vector<constraints::Stitch> stitches) {
  stitches_ = std::move(stitches);
  stitch_groups_ = constraints::stitch_groups(stitches_, model_.vertex_count());
}

void ClothSolver::set_holds(std::vector<constraints::HeldVertex> held) {
  held_ = std::move(held);
  std::vector<double> w;
  w.reserve(model_.mass.size());
  for (const double m : model_.mass) w.push_back(m > 0 ? 1 / m : 0);
  for (const constraints::HeldVertex& h : held_) {
    if (!h.height_only) w[h.v] = 0;
  }
  if (w == inverse_mass_) return;
  inverse_mass_ = std::move(w);
  pace_ = {};
  membrane_.prepare(inverse_mass_, h_);
  bending_.prepare(inverse_mass_, h_);
}

void ClothSolver::keep_preloads(double share) {
  std::vector<Vec3> kept = membrane_.preloads();
  for (Vec3& p : kept) p = p * share;
  membrane_.set_preloads(std::move(kept));
}

void ClothSolver::give_way(const constraints::MayGive& may) {
  if (pace_.ended()) membrane_.give_way(x_, may);
}

SolverState ClothSolver::state() const {
  SolverState now{x_, velocity_, {}, stopped_, stuck_, steps_near_, hits_, membrane_.preloads(), pace_};
  if (detected_) now.contacts = contacts_;
  return now;
}

void ClothSolver::restore(SolverState state) {
  TOILE_CHECK(state.positions.size() == x_.size() && state.velocities.size() == x_.size());
  x_ = std::move(state.positions);
  velocity_ = std::move(state.velocities);
  stopped_ = std::move(state.stopped);
  stuck_ = std::move(state.stuck);
  steps_near_ = std::move(state.steps_near);
  hits_ = state.hits;
  membrane_.set_preloads(std::move(state.preloads));
  pace_ = state.pace;
  detected_ = !state.contacts.centre.empty();
  if (!detected_) return;
  contacts_ = std::move(state.contacts);
  finder_.resume(contacts_);
}

StepReport ClothSolver::step(const StepForces& forces) {
  Crew alone;
  return step(forces, alone);
}

StepReport ClothSolver::step(const StepForces& forces, Crew& crew) {
  push_features(features_, forces.features, model_.triangles, inverse_mass_, h_, x_, feature_force_,
                velocity_);
  predict(forces, crew);
  lanes::spread(x_, points_, crew);
  const bool learns = forces.learns && pace_.due(forces.damping);
  membrane_.solve(points_, learns, crew);
  bending_.solve(points_, crew);
  lanes::collect(points_, x_, crew);
  solve_features(features_, forces.features, inverse_mass_, h_, before_, x_, brought_);
  constraints::solve_height_holds(held_, x_);
  if (forces.stitch_length > 0) {  // after the holds: a thread wins over a hand
    constraints::shorten_stitches(stitches_, forces.stitch_length, inverse_mass_, h_, x_);
  } else {
    constraints::close_groups(stitch_groups_, inverse_mass_, h_, x_);
  }
  const StepReport report = truncate(forces, crew);
  finish(forces, crew);
  if (forces.viscosity > 0)
    constraints::even_velocities(model_.triangles, model_.mass, forces.viscosity, velocity_);
  if (learns) membrane_.learn(x_, pace_.next_share(forces.damping, h_), pace_.ended());
  return report;
}

void ClothSolver::predict(const StepForces& forces, Crew& crew) {
  before_ = x_;
  const double keep = 1 / (1 + forces.damping * h_);
  const double fall = forces.gravity * h_;
  crew.ranges(x_.size(), kFewVertices, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (inverse_mass_[i] == 0) continue;
      Vec3& v = velocity_[i];
      v.y -= fall;
      v = v * keep;
      x_[i] += v * h_;
    }
  });
  for (const constraints::HeldVertex& h : held_) {
    if (!h.height_only) x_[h.v] = h.target;
  }
}

void ClothSolver::measure_all(Crew& crew) {
  for (std::size_t i = 0; i < velocity_.size(); ++i) speed_[i] = length(velocity_[i]);
  finder_.detect(before_, speed_, contacts_, crew);
  detected_ = true;
  moved_.resize(x_.size());
  std::iota(moved_.begin(), moved_.end(), 0);
}

/// Those that went far, and those that planes stop.
void ClothSolver::measure_again(Crew& crew) {
  moved_.clear();
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const auto v = static_cast<Index>(i);
    if (wants_measuring(v)) moved_.push_back(v);
  }
  if (static_cast<double>(moved_.size()) > kMostMeasuredAlone * static_cast<double>(x_.size()))
    return measure_all(crew);
  for (const Index v : moved_) speed_[v] = length(velocity_[v]);
  finder_.detect_again(moved_, before_, speed_, contacts_, crew);
}

bool ClothSolver::wants_measuring(Index v) const {
  if ((stopped_[v] && !stuck_[v]) || steps_near_[v] >= kNearSteps) return true;
  const Vec3 way = x_[v] - contacts_.centre[v];
  const double far = kFarShare * contacts_.trust_radius[v];
  return dot(way, way) > far * far;
}

/// Few vertices come near a bound in a step: those are looked at closely.
void ClothSolver::note_who_went_far(Crew& crew) {
  went_far_.resize(x_.size());
  crew.ranges(x_.size(), kFewVertices, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      went_far_[i] = contacts_.surely_inside(static_cast<Index>(i), x_[i]) ? 0 : 1;
  });
  far_.clear();
  for (std::size_t i = 0; i < x_.size(); ++i) {
    if (went_far_[i]) far_.push_back(static_cast<Index>(i));
  }
}

/// A vertex that a plane stops within its trust region asks for nothing.
bool ClothSolver::leaves_trust_region() const {
  return std::any_of(far_.begin(), far_.end(), [&](Index v) {
    if (contacts_.inside_trust_region(v, x_[v])) return false;
    const double t = contacts_.plane_reach(v, before_[v], x_[v]);
    return !contacts_.inside_trust_region(v, before_[v] + (x_[v] - before_[v]) * t);
  });
}

void ClothSolver::count_stops() {
  for (const Index v : far_) {
    ++steps_near_[v];
    if (contacts_.inside_planes(v, x_[v])) continue;
    stopped_[v] = true;
    if (!stuck_[v]) ++hits_;
  }
}

void ClothSolver::note_who_is_stuck() {
  for (const Index v : moved_) {
    stopped_[v] = stuck_[v] = false;
    steps_near_[v] = 0;
  }
  for (const Index v : far_) {
    if (std::binary_search(moved_.begin(), moved_.end(), v) && !contacts_.inside_planes(v, x_[v]))
      stuck_[v] = true;
  }
  hits_ = 0;
}

void ClothSolver::push_apart(const StepForces& forces, Crew& crew) {
  constraints::solve_contacts(contacts_.contacts, before_, inverse_mass_, forces.friction, h_, x_,
                              depenetration_);
  note_who_went_far(crew);
}

/// Look before clamping: where a vertex would leave its trust region, or many run into planes, measure at
/// this step's start what went far, and cut the proposal with fresh bounds. Clamping on and on would pin the
/// cloth in the air.
StepReport ClothSolver::truncate(const StepForces& forces, Crew& crew) {
  StepReport report;
  for (const Vec3& p : x_) report.not_finite |= !is_finite(p);
  if (report.not_finite) {
    x_ = before_;
    std::fill(velocity_.begin(), velocity_.end(), Vec3{});
  }
  std::fill(depenetration_.begin(), depenetration_.end(), Vec3{});
  proposal_ = x_;
  const bool first = !detected_;
  if (first) measure_all(crew);
  push_apart(forces, crew);
  if (!first) count_stops();
  if (!first && (leaves_trust_region() || hits_ > kPlaneHitShare * static_cast<double>(x_.size()))) {
    measure_again(crew);
    x_ = proposal_;
    std::fill(depenetration_.begin(), depenetration_.end(), Vec3{});
    push_apart(forces, crew);
    report.detections = 1;
  }
  if (first || report.detections > 0) {
    report.detections = 1;
    report.measured = static_cast<int>(moved_.size());
    note_who_is_stuck();
  }
  for (const Index v : far_) {
    const Vec3 reached = contacts_.reached(v, before_[v], x_[v]);
    if (!(reached == x_[v])) ++report.bounded;
    x_[v] = reached;
  }
  return report;
}

void ClothSolver::finish(const StepForces& forces, Crew& crew) {
  const double per_h = 1 / h_;
  std::vector<constraints::Impact> impacts;
  if (bouncy_)
    impacts = constraints::find_impacts(contacts_.contacts, forces.restitution, proposal_, velocity_);
  crew.ranges(x_.size(), kFewVertices, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) velocity_[i] = (x_[i] - before_[i] - depenetration_[i]) * per_h;
  });
  constraints::let_lie(brought_, h_, velocity_);
  constraints::give_back(impacts, inverse_mass_, velocity_);
}

}  // namespace toile::solver
