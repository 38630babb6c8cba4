#include "core/drape/paper_session.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/drape/ground.h"
#include "core/drape/make_features.h"
#include "core/drape/make_threads.h"
#include "core/drape/seam_gaps.h"

namespace toile::drape {

namespace {

/// Seams that do not close in their time are waited for so long before gravity comes.
constexpr double kPaperStallTime = 0.5;  // s
/// Cloth counts as at rest at the soonest this long after gravity came: it was watched under it.
constexpr double kPaperSoonestRest = 0.2;  // s

paper::Particles particles_of(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                              const sewing::Assembly& assembly) {
  std::vector<Vec2> warps;
  for (const mesh::PanelMesh& mesh : meshes.panels) warps.push_back(mesh.warp);
  return paper::make_particles(assembly.garment, warps, input.fabrics, input.fabric_of_panel,
                               input.settings.paper.load);
}

paper::Solids solids_of(const DrapeInput& input, std::optional<double> ground) {
  paper::Solids solids;
  const double least = input.settings.paper.clearance;
  for (const body::Body& body : input.bodies)
    paper::add_solid(body.mesh.vertices, body.mesh.triangles, std::max(body.skin_offset, least), solids);
  if (ground) {
    const Ground floor(*ground);
    paper::add_solid(floor.corners, floor.triangles, floor.skin, solids);
  }
  return solids;
}

bool leads(const sewing::Attachment& a) { return a.hold == sewing::Attachment::Hold::kGoal; }

}  // namespace

std::unique_ptr<PaperSession> PaperSession::start(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                                                  sewing::Assembly assembly,
                                                  const std::optional<std::vector<Vec3>>& dressed,
                                                  std::optional<double> ground) {
  return std::unique_ptr<PaperSession>(new PaperSession(input, meshes, std::move(assembly), dressed, ground));
}

PaperSession::PaperSession(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                           sewing::Assembly assembly, const std::optional<std::vector<Vec3>>& dressed,
                           std::optional<double> ground)
    : input_(input),
      assembly_(std::move(assembly)),
      crossings_(assembly_.garment),
      cloth_(particles_of(input, meshes, assembly_), solids_of(input, ground), input.settings.paper,
             dressed ? *dressed : assembly_.positions),
      released_(input.attachments.size(), false),
      off_at_release_(input.attachments.size(), 0),
      dressed_(dressed.has_value()),
      watch_(input.settings.paper.time_step, input.settings.settle_speed) {
  for (const body::Body& body : input.bodies) crossings_.add_body(body.mesh.vertices, body.mesh.triangles);
  if (ground) {
    const Ground floor(*ground);
    crossings_.add_body(floor.corners, floor.triangles);
  }
  const bool led = std::any_of(input.attachments.begin(), input.attachments.end(), leads);
  if (!led && (dressed_ || assembly_.garment.sewn.empty())) phase_ = Phase::kDrape;
  attach();
  cloth_.come_out();
  watch_.restart(cloth_.positions());
}

void PaperSession::begin_anew(const std::vector<Vec3>& /*dressed*/, std::optional<double> /*ground*/) {
  TOILE_CHECK(may_begin_anew());
}

/// Gives the cloth what is not yet released.
void PaperSession::attach() {
  const Index count = assembly_.garment.vertex_count();
  std::vector<Index> own(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) own[i] = i;
  std::vector<paper::Held> held;
  for (const solver::constraints::HeldVertex& h : make_holds(input_, assembly_, own, count, released_))
    held.push_back({h.v, h.height_only, h.target});
  cloth_.set_held(std::move(held));

  std::vector<paper::Led> led;
  for (std::size_t a = 0; a < released_.size(); ++a) {
    if (released_[a]) continue;
    for (const sewing::ClothPoint& point : assembly_.led[a])
      led.push_back({point, &input_.attachments[a].goal});
  }
  cloth_.set_led(std::move(led));
}

/// 1/s, at which the damping takes speed from what moves freely.
double PaperSession::rate() const { return input_.settings.paper.damping / input_.settings.paper.time_step; }

void PaperSession::step(Crew&) {
  TOILE_CHECK(phase_ != Phase::kDone);
  paper::StepForces forces;
  if (phase_ == Phase::kSew) {
    const double left = input_.settings.sew_time - since();
    forces.closing = left > 0 ? std::min(1.0, input_.settings.paper.time_step / left) : 1;
  } else {
    forces.gravity = input_.settings.gravity;
  }
  cloth_.step(forces);
  ++steps_;
  if (!cloth_.finite()) return end(Stop::kNotFinite);
  watch_.observe(cloth_.positions(), rate());
  phase_ == Phase::kSew ? sew_on() : settle_or_stop();
}

void PaperSession::sew_on() {
  if (since() < input_.settings.sew_time) return;
  if (seam_gap() > kSeamTolerance && since() < input_.settings.sew_time + kPaperStallTime) return;
  phase_ = Phase::kDrape;
  phase_start_ = time();
  watch_.restart(cloth_.positions());
}

/// Whether an attachment still holds that will let go.
bool PaperSession::release_in_time() {
  bool holding = false, changed = false;
  for (std::size_t a = 0; a < released_.size(); ++a) {
    const double after = input_.attachments[a].release_after;
    if (released_[a] || after < 0) continue;
    holding = true;
    if (since() < after) continue;
    released_[a] = changed = true;
    off_at_release_[a] = off_hold(input_, assembly_, a, cloth_.positions());
  }
  if (changed) {
    attach();
    watch_.restart(cloth_.positions());
  }
  return holding;
}

void PaperSession::settle_or_stop() {
  const bool holding = release_in_time();
  const bool rests =
      input_.settings.until_settled && !holding && since() >= kPaperSoonestRest && watch_.settled(rate());
  if (rests) {
    end(seam_gap() > kSeamTolerance ? Stop::kOpenSeam : Stop::kSettled);
  } else if (time() >= input_.settings.max_time) {
    end(Stop::kTime);
  }
}

void PaperSession::end(Stop kind) {
  phase_ = Phase::kDone;
  stop_reason_ = StopReason{kind, "", 0};
  if (!has_name(kind)) return;
  stop_reason_->name = widest_seam(input_, garment(), pair_gaps(garment(), cloth_.positions()));
  stop_reason_->gap = seam_gap();
}

Progress PaperSession::progress() const {
  if (phase_ == Phase::kSew)
    return {"sew", std::min(1.0, since() / std::max(1e-3, input_.settings.sew_time))};
  if (phase_ == Phase::kDone) return {"drape", 1};
  const double left = std::max(1e-3, input_.settings.max_time - phase_start_);
  return {"drape", std::min(1.0, since() / left)};
}

double PaperSession::seam_gap() const { return largest_gap(pair_gaps(garment(), cloth_.positions())); }

std::vector<OpenSeam> PaperSession::open_seams() const {
  return seams_open(input_, garment(), pair_gaps(garment(), cloth_.positions()));
}

std::vector<HoldFigures> PaperSession::holds() const {
  std::vector<HoldFigures> figures;
  for (std::size_t a = 0; a < released_.size(); ++a) {
    HoldFigures hold{released_[a], 0, off_at_release_[a]};
    if (hold.released) hold.released_at = phase_start_ + input_.attachments[a].release_after;
    if (!hold.released) hold.off = off_hold(input_, assembly_, a, cloth_.positions());
    figures.push_back(hold);
  }
  return figures;
}

SessionState PaperSession::state() const {
  SessionState state;
  state.phase = phase_;
  state.began = began();
  state.stop_reason = stop_reason_;
  state.steps = steps_;
  state.time = time();
  state.phase_start = phase_start_;
  state.released = released_;
  state.off_at_release = off_at_release_;
  state.watch = watch_.state();
  state.paper = cloth_.state();
  return state;
}

Status PaperSession::restore(SessionState state) {
  const paper::PaperState& now = cloth_.state();
  if (state.paper.positions.size() != now.positions.size() || state.paper.bent.size() != now.bent.size() ||
      state.released.size() != released_.size() || state.off_at_release.size() != released_.size()) {
    return damaged_checkpoint();
  }
  cloth_.restore(std::move(state.paper));
  dressed_ = state.began == Began::kDressed;
  released_ = state.released;
  off_at_release_ = state.off_at_release;
  attach();
  watch_.restore(std::move(state.watch));
  phase_ = state.phase;
  stop_reason_ = std::move(state.stop_reason);
  if (stop_reason_ && has_name(stop_reason_->kind)) stop_reason_->gap = seam_gap();
  steps_ = state.steps;
  phase_start_ = state.phase_start;
  return {};
}

std::string left_out_by_paper(const DrapeInput& input) {
  std::vector<std::string> kinds;
  if (!input.notions.buttons.empty()) kinds.push_back("buttons");
  if (!input.notions.elastics.empty()) kinds.push_back("elastic");
  if (!input.notions.creases.empty()) kinds.push_back("creases");
  if (!input.notions.cushions.empty()) kinds.push_back("cushions");
  if (input.settings.air.density > 0) kinds.push_back("air");
  if (std::any_of(input.bodies.begin(), input.bodies.end(), [](const auto& b) { return !b.motion.empty(); }))
    kinds.push_back("bodies that move");
  std::string words;
  for (const std::string& kind : kinds) words += (words.empty() ? "" : ", ") + kind;
  return words;
}

}  // namespace toile::drape
