#include "core/drape/drape_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check.h"
#include "core/drape/ground.h"
#include "core/drape/make_features.h"
#include "core/drape/make_threads.h"
#include "core/drape/seam_gaps.h"
#include "core/dressing/limbs.h"
#include "core/dressing/shoulders.h"
#include "core/solver/constraints/viscosity.h"
#include "core/warm/warm_start.h"

namespace toile::drape {

namespace {

/// Gravity comes in over this time, so that sewn cloth does not drop with a jerk.
constexpr double kGravityRamp = 0.5;  // s
/// A thick medium while threads pull: the pieces are led, not thrown.
constexpr double kSewDamping = 6;  // 1/s
/// Inner friction, so that what shivers comes to rest; wide folds hardly feel it.
constexpr double kViscosity = 20;  // 1/s
/// Elastic, creases and air come in over this time, once the garment is sewn.
constexpr double kFormTime = 0.5;  // s
/// Cloth is at rest at the soonest this long after sewing: all forces are in, and it was watched under them.
constexpr double kSoonestRest = std::max(kGravityRamp, kFormTime) + 0.2;  // s
/// What only its elastic holds would be on the floor before that has gathered it: gravity waits so long.
double gathering_time(const DrapeInput& input) {
  return input.notions.elastics.empty() || input.hangs_by_hooks() ? 0 : kFormTime;
}
/// Seams this close are shut.
constexpr double kSeamShut = 0.3e-3;  // m
/// Threads have this much longer than sew_time before a seam counts as stalled, or until nothing moves.
constexpr double kStallTime = 1.5;  // s
/// Threads that do not close the seams in this time are let out to this share of their first lengths, so that
/// a fold that was caught between two sides can slip out, and pulled again, so many times.
constexpr double kJamTime = 0.4, kSlack = 0.15;  // s, 1
constexpr int kMostSlackened = 2;
/// A button is open when its thread is longer than it is by more than this: layers between may be thick.
constexpr double kButtonTolerance = 3e-3;  // m
/// A seam that is still this far open when the threads have had their time will not close. A narrower one
/// may, once gravity and friction have moved the cloth: its threads stay.
constexpr double kSeamLost = 10e-3;  // m
/// How much calmer cloth must be than at rest before a seam or button is given up as open.
constexpr double kOpenCalm = 0.2;
/// Cloth that begins on the body has so long for itself before gravity comes in. What goes over the shoulders
/// comes back to its shape in this share of it: all at once it would snap, and throw its straps off.
constexpr double kEaseTime = 0.4, kBackInShape = 0.8;  // s, 1
constexpr int kShapeSteps = 8;                         // from one bit of the way back to the next
constexpr int kGiveSteps = 64;                         // from one look at what gives way to the next
constexpr double kWeldInterval = 0.25;                 // s between tries to weld what was left open

}  // namespace

std::unique_ptr<DrapeSession> DrapeSession::start(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                                                  sewing::Assembly assembly,
                                                  const std::optional<std::vector<Vec3>>& dressed,
                                                  std::optional<double> ground) {
  std::unique_ptr<DrapeSession> session(new DrapeSession(input, meshes, std::move(assembly), ground));
  if (dressed) session->begin_dressed(*dressed);
  return session;
}

void DrapeSession::put_ground(double height) {
  const Ground ground(height);
  collision::Obstacle obstacle =
      collision::make_obstacle(ground.corners, ground.triangles, ground.friction, ground.skin);
  if (grounded_) {
    obstacles_.back() = std::move(obstacle);
    crossings_.move_body(crossings_.bodies().size() - 1, ground.corners);
    return;
  }
  grounded_ = true;
  obstacles_.push_back(std::move(obstacle));
  crossings_.add_body(ground.corners, ground.triangles);
}

void DrapeSession::begin_dressed(const std::vector<Vec3>& positions) {
  began_ = Began::kDressed;
  Weld weld = joined_as(assembly_.garment, std::vector<bool>(positions.size(), true));
  vertex_of_ = weld.vertex_of;
  weld.positions.resize(static_cast<std::size_t>(weld.vertex_count));
  for (std::size_t i = 0; i < positions.size(); ++i) weld.positions[vertex_of_[i]] = positions[i];
  build_solver(model_of(vertex_of_, weld.vertex_count), std::move(weld.positions), {});
  solver_->set_stitches(stitches_now());
  // Skirts unfold best all at once: nothing of theirs can be thrown off.
  const auto person = dressing::find_person(input_.bodies);
  if (person && dressing::goes_over_shoulders(person->figure, positions)) solver_->rest_here();
}

/// What lets go after a time has let go before.
void DrapeSession::let_go_of_timed_holds() {
  for (std::size_t a = 0; a < released_.size(); ++a) released_[a] = input_.attachments[a].release_after >= 0;
}

Status DrapeSession::go_on_from(const warm::HungGarment& before, const mesh::PanelMeshes& meshes,
                                const std::optional<dressing::Person>& wearer) {
  warm::WarmStart start = TRY(warm::go_on_from(before, input_.pattern, meshes, assembly_.garment,
                                               {obstacles_, crossings_.bodies(), wearer}));
  began_ = Began::kWarm;
  let_go_of_timed_holds();
  Weld weld = joined_as(assembly_.garment, start.joined);
  vertex_of_ = weld.vertex_of;
  weld.positions.resize(static_cast<std::size_t>(weld.vertex_count));
  for (std::size_t i = 0; i < vertex_of_.size(); ++i) weld.positions[vertex_of_[i]] = start.positions[i];
  build_solver(model_of(vertex_of_, weld.vertex_count), std::move(weld.positions), {});
  solver_->set_preloads(std::move(start.preloads));
  solver_->set_stitches(stitches_now());
  if (start.widest > kSeamLost) return {};  // seams close first, as at every start
  phase_ = Phase::kDrape;
  phase_start_ = -gathering_time(input_) - std::max(kGravityRamp, kFormTime);  // all forces are in
  return {};
}

void DrapeSession::begin_anew(const std::vector<Vec3>& dressed, std::optional<double> ground) {
  if (ground) put_ground(*ground);
  phase_ = Phase::kSew;
  stop_reason_.reset();
  lost_.assign(lost_.size(), false);
  released_.assign(released_.size(), false);
  off_at_release_.assign(off_at_release_.size(), 0);
  slackened_ = 0;
  motion_.reset(obstacles_);
  bodies_moved_ = true;
  begun_ = phase_start_ = last_weld_ = time_;
  begin_dressed(dressed);
}

/// A garment that is on already only lets go of what it was stretched, unless threads or goals lead it.
double DrapeSession::sew_time() const {
  const bool led = std::any_of(input_.attachments.begin(), input_.attachments.end(),
                               [](const auto& a) { return a.hold == sewing::Attachment::Hold::kGoal; });
  if (began_ != Began::kDressed || led || !input_.notions.buttons.empty()) return input_.settings.sew_time;
  return std::min(input_.settings.sew_time, kEaseTime);
}

DrapeSession::DrapeSession(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                           sewing::Assembly assembly, std::optional<double> ground)
    : input_(input),
      assembly_(std::move(assembly)),
      crossings_(assembly_.garment),
      lost_(input.pattern.seams.size(), false),
      released_(input.attachments.size(), false),
      off_at_release_(input.attachments.size(), 0),
      watch_(input.settings.time_step, input.settings.settle_speed),
      probe_(input.settings.time_step, input.settings.settle_speed),
      motion_(input.bodies, input.settings.time_step) {
  for (const mesh::PanelMesh& mesh : meshes.panels) warps_.push_back(mesh.warp);
  for (const body::Body& body : input.bodies) {
    obstacles_.push_back(collision::make_obstacle(body.mesh.vertices, body.mesh.triangles, body.friction,
                                                  body.skin_offset, body.restitution));
    crossings_.add_body(body.mesh.vertices, body.mesh.triangles);
  }
  if (ground) put_ground(*ground);
  if (input.settings.dress && !dynamic()) wearer_ = dressing::find_person(input.bodies);
  const Weld open = no_weld(assembly_.positions);
  vertex_of_ = open.vertex_of;
  build_solver(model_of(vertex_of_, open.vertex_count), open.positions, {});
  solver_->set_stitches(stitches_now());
  if (assembly_.garment.sewn.empty() && input.notions.buttons.empty()) phase_ = Phase::kDrape;
}

solver::ClothModel DrapeSession::model_of(std::span<const Index> vertex_of, Index vertex_count) const {
  return solver::make_cloth_model(assembly_.garment, vertex_of, vertex_count, warps_, input_.fabrics,
                                  input_.fabric_of_panel);
}

void DrapeSession::build_solver(solver::ClothModel model, std::vector<Vec3> positions,
                                std::vector<Vec3> velocities) {
  std::vector<Vec3> layout(positions.size());  // of the start, so that a checkpoint need not keep it
  for (std::size_t i = vertex_of_.size(); i-- > 0;) layout[vertex_of_[i]] = assembly_.positions[i];
  solver_ = std::make_unique<solver::ClothSolver>(std::move(model), std::move(positions), obstacles_,
                                                  input_.settings.time_step, layout);
  if (!velocities.empty()) solver_->set_velocities(std::move(velocities));
  solver_->set_holds(held_now());
  solver_->set_features(features_now());
  watch_.restart(solver_->positions());
  probe_.restart();
}

std::vector<solver::constraints::Stitch> DrapeSession::stitches_now() const {
  return make_stitches(assembly_, vertex_of_, lost_, input_.settings.particle_distance);
}

std::vector<solver::constraints::HeldVertex> DrapeSession::held_now() const {
  return make_holds(input_, assembly_, vertex_of_, solver_->model().vertex_count(), released_);
}

solver::ClothFeatures DrapeSession::features_now() const {
  solver::ClothFeatures features =
      make_features(input_, assembly_, vertex_of_, solver_->model().vertex_count(), released_,
                    motion_.has_begun() ? std::nullopt : wearer_);
  features.leashes = leashes_now();
  return features;
}

bool DrapeSession::dynamic() const { return input_.settings.mode == DrapeMode::kDynamic; }

double DrapeSession::time_of_full_gravity() const {
  return phase_start_ + (dynamic() ? 0 : gathering_time(input_) + kGravityRamp);
}

solver::StepForces DrapeSession::forces_now() const {
  solver::StepForces forces;
  const double since = time_ - phase_start_;
  forces.learns = !hands_.pulling();  // what they stretch is to come back
  if (phase_ == Phase::kSew) {
    forces.gravity = 0;
    // What is on already keeps its hold on the body: tight cloth would ride up to where the body is slimmer,
    // and straps down the shoulders' slopes.
    forces.friction = began_ == Began::kDressed ? 1 : 0;
    forces.restitution = 0;
    forces.learns &= began_ != Began::kDressed;
    forces.damping = kSewDamping;
    forces.stitch_length = std::max(0.0, 1 - since / sew_time());
    forces.features = {forces.stitch_length, 0, false};
    return forces;
  }
  forces.features = {0, std::min(1.0, since / kFormTime), input_.settings.air.density > 0};
  if (dynamic() || probe_.on()) {
    forces.gravity = input_.settings.gravity;
    forces.damping = 0;
    return forces;
  }
  forces.gravity =
      input_.settings.gravity * std::clamp((since - gathering_time(input_)) / kGravityRamp, 0.0, 1.0);
  forces.damping = watch_.damping();
  forces.viscosity = solver::constraints::viscous_share(kViscosity, input_.settings.time_step, steps_);
  return forces;
}

/// 1 where cloth that was put on begins, 0 once its shape is its own again.
double DrapeSession::share_out_of_shape() const {
  return std::max(0.0, 1 - (time_ - phase_start_) / (kBackInShape * sew_time()));
}

/// What of the preloads is left since the last bit of the way, so that nothing else need be remembered.
void DrapeSession::come_back_to_shape() {
  if (began_ != Began::kDressed || phase_ != Phase::kSew || steps_ % kShapeSteps != 0) return;
  const double now = share_out_of_shape();
  const double bit = kShapeSteps * input_.settings.time_step / (kBackInShape * sew_time());
  if (now + bit > 0) solver_->keep_preloads(now / std::min(1.0, now + bit));
}

/// What is sewn too small for the arm or leg that it was put around, or gathered there, would be pulled back
/// by all its strain in each pass, and shiver for ever. Around the trunk cloth gives no way: what is
/// stretched there may be all that carries a heavy skirt.
void DrapeSession::give_way(const solver::StepForces& forces) {
  const bool hangs = phase_ == Phase::kDrape && wearer_ && !motion_.has_begun();
  if (!hangs || !forces.learns || forces.damping <= 0 || steps_ % kGiveSteps != 0) return;
  solver_->give_way([&](Vec3 p) { return dressing::is_around_limb(wearer_->figure, p); });
}

void DrapeSession::step(Crew& crew) {
  TOILE_CHECK(phase_ != Phase::kDone);
  come_back_to_shape();
  lead_by_hands();
  if (motion_.is_going()) move_bodies();
  const solver::StepForces forces = forces_now();
  const solver::StepReport report = solver_->step(forces, crew);
  give_way(forces);
  ++steps_;
  time_ += input_.settings.time_step;
  watch_.observe(solver_->positions(), forces.damping);
  if (report.not_finite) {
    end(Stop::kNotFinite);
  } else if (phase_ == Phase::kSew) {
    sew_or_weld();
  } else {
    settle_or_stop();
  }
}

void DrapeSession::sew_or_weld() {
  const double since = time_ - phase_start_;
  if (since < sew_time()) return;
  const double gap = solver::constraints::largest_gap(solver_->stitches(), solver_->positions());
  const bool shut = gap <= kSeamShut && open_button().excess <= kSeamShut;
  if (!shut && hands_.pulling()) return;  // it may be the hand that keeps it open
  if (!shut && slackened_ < kMostSlackened && since >= sew_time() + kJamTime) {
    ++slackened_;
    phase_start_ = time_ - (1 - kSlack) * sew_time();
    return;
  }
  const bool still = slackened_ == kMostSlackened && watch_.rms_speed() < input_.settings.settle_speed;
  if (!shut && !still && since < sew_time() + kStallTime) return;
  if (gap > kSeamLost) let_go_of_lost_seams();
  join(weld_now());
  phase_ = Phase::kDrape;
  phase_start_ = last_weld_ = time_;
}

/// What does not close is left open, and the rest is draped: threads that went on pulling would draw the
/// garment to where it should not be.
void DrapeSession::let_go_of_lost_seams() {
  const std::vector<double> gaps = pair_gaps();
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    if (gaps[k] > kSeamLost) lost_[assembly_.garment.seam_of_sewn[k]] = true;
  }
}

Weld DrapeSession::weld_now() const {
  return weld_seams(assembly_.garment, positions(), kSeamTolerance, obstacles_);
}

void DrapeSession::join(Weld weld) {
  welded_at_ = steps_;
  const std::vector<Index> before = std::exchange(vertex_of_, weld.vertex_of);

  solver::ClothModel model = model_of(vertex_of_, weld.vertex_count);
  std::vector<Vec3> velocities =
      velocities_of_joined(before, weld, solver_->model().mass, solver_->velocities());
  std::vector<Vec3> preloads = solver_->preloads();
  build_solver(std::move(model), std::move(weld.positions), std::move(velocities));
  solver_->set_stitches(stitches_now());
  if (!dynamic())
    solver_->set_preloads(std::move(preloads));  // true motion would keep those of sewing for ever
}

void DrapeSession::weld_what_closed() {
  if (solver_->stitches().empty() || time_ < last_weld_ + kWeldInterval) return;
  last_weld_ = time_;
  const std::vector<Vec3>& x = solver_->positions();
  const auto& open = solver_->stitches();
  const bool closed = std::any_of(open.begin(), open.end(), [&](const solver::constraints::Stitch& s) {
    return length(x[s.v1] - x[s.v0]) <= kSeamShut;
  });
  if (!closed) return;
  Weld weld = weld_now();
  if (weld.vertex_of != vertex_of_) join(std::move(weld));  // or nothing would ever be seen at rest
}

void DrapeSession::settle_or_stop() {
  if (motion_.is_going()) return;
  weld_what_closed();
  bool holding = hands_.pulling();
  for (std::size_t a = 0; a < released_.size(); ++a) {
    const double after = input_.attachments[a].release_after;
    if (released_[a] || after < 0) continue;
    holding = true;
    if (time_ < time_of_full_gravity() + after) continue;
    released_[a] = true;
    off_at_release_[a] = off_hold(input_, assembly_, a, positions());
    solver_->set_holds(held_now());
    solver_->set_features(features_now());
    watch_.restart(solver_->positions());
  }
  if (dynamic() && time_ >= time_of_full_gravity() && begins_to_move()) return;
  const bool out_of_time = time_ >= begun_ + input_.settings.max_time && !waits_for_hands();
  const double calm = is_let_go_first() && !out_of_time ? kSeemingCalm : 1;  // no time is left to let it go
  const bool may_rest = input_.settings.until_settled && !holding &&
                        time_ >= phase_start_ + gathering_time(input_) + kSoonestRest && lies_still(calm);
  if (probe_.on()) {
    if (stays_when_let_go()) return begins_to_move() ? void() : end(stop_at_rest());
  } else if (may_rest && (out_of_time || nothing_closes())) {
    if (out_of_time || !is_let_go_first()) return begins_to_move() ? void() : end(stop_at_rest());
    let_go();
  }
  if (out_of_time && !begins_to_move()) end(Stop::kTime);
}

/// Bodies move once the cloth hangs, or has had its time; then it comes to rest anew.
bool DrapeSession::begins_to_move() {
  if (!motion_.is_to_come()) return false;
  probe_.restart();
  motion_.begin(solver_->model(), solver_->positions());
  solver_->set_features(features_now());
  return true;
}

void DrapeSession::move_bodies() {
  if (!motion_.move(solver_->positions(), obstacles_)) return;
  solver_->note_moved_obstacles();
  bodies_moved_ = true;
  if (motion_.is_going()) return;
  if (!dynamic()) begun_ = time_;
  watch_.restart(solver_->positions());
}

/// From a standstill, in true motion: what stays then is at rest.
void DrapeSession::let_go() {
  probe_.begin(solver_->positions());
  solver_->set_velocities(std::vector<Vec3>(solver_->positions().size()));
  watch_.look_anew(solver_->positions());
}

bool DrapeSession::stays_when_let_go() {
  const RestProbe::Answer answer = probe_.observe(solver_->positions(), solver_->model().triangles);
  if (answer == RestProbe::Answer::kAgain) let_go();
  return answer == RestProbe::Answer::kStays;
}

bool DrapeSession::is_let_go_first() const { return !dynamic() && probe_.asks(); }

bool DrapeSession::lies_still(double calm) const { return watch_.settled(forces_now().damping, calm); }

/// What threads still hold open may close while the cloth creeps: that is waited for.
bool DrapeSession::nothing_closes() const {
  const double pulled = solver::constraints::largest_gap(solver_->stitches(), solver_->positions());
  const bool shut = pulled <= kSeamTolerance && open_button().excess <= kButtonTolerance;
  return shut || watch_.settled(forces_now().damping, kOpenCalm);
}

/// A seam goes before a button: what lies on open cloth is hardly the button's fault.
Stop DrapeSession::stop_at_rest() const {
  if (seam_gap() > kSeamTolerance) return Stop::kOpenSeam;
  return open_button().excess > kButtonTolerance ? Stop::kOpenButton : Stop::kSettled;
}

void DrapeSession::end(Stop kind) {
  phase_ = Phase::kDone;
  std::string name;
  if (kind == Stop::kOpenButton) {
    name = input_.notions.buttons[open_button().tie].id;
  } else if (has_name(kind)) {
    name = widest_seam(input_, assembly_.garment, pair_gaps());
  }
  stop_reason_ = StopReason{kind, std::move(name), gap_at(kind)};
}

double shortest_drape(const DrapeInput& input) {
  return (input.pattern.seams.empty() ? 0 : input.settings.sew_time) + gathering_time(input) + kSoonestRest;
}

double longest_sewing(const DrapeSettings& settings) {
  return settings.sew_time + kMostSlackened * (kJamTime + kSlack * settings.sew_time) + kStallTime;
}

}  // namespace toile::drape
