#include "tests/bench/peer_run.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include "core/base/crew.h"
#include "core/collision/crossings.h"
#include "core/drape/rest_probe.h"
#include "core/drape/settle.h"
#include "core/drape/weld.h"
#include "core/solver/cloth_solver.h"
#include "core/solver/constraints/viscosity.h"

namespace toile::peers {

namespace {

constexpr double kGravity = 9.81, kSkinOffset = 1e-3;
constexpr double kLeadTime = 0.5;     // s, in which led vertices go and threads shrink
constexpr double kSewDamping = 6;     // 1/s
constexpr double kSeamShut = 0.1e-3;  // m
constexpr double kDynamicTime = 3, kMostTime = 12, kRestTime = 1;  // s
constexpr double kSpeedWindow = 0.04;                              // s
constexpr double kFrameInterval = 5e-3;                            // s between frames that are looked at
constexpr double kTraceInterval = 50e-3;                           // s
constexpr double kWaveSpeed = 45;                                  // m/s, edges per substep

/// CPU (user and system, all threads and children) and wall time; stands still while paused.
class PauseClock {
 public:
  void pause() {
    cpu_ += cpu_now() - cpu_start_;
    wall_ += wall_now() - wall_start_;
  }
  void resume() {
    cpu_start_ = cpu_now();
    wall_start_ = wall_now();
  }
  double cpu_s() const { return cpu_; }    ///< up to the last pause
  double wall_s() const { return wall_; }  ///< up to the last pause

 private:
  static double seconds(const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }
  static double cpu_now() {
    double sum = 0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
      rusage usage{};
      getrusage(who, &usage);
      sum += seconds(usage.ru_utime) + seconds(usage.ru_stime);
    }
    return sum;
  }
  static double wall_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  double cpu_ = 0, wall_ = 0, cpu_start_ = cpu_now(), wall_start_ = wall_now();
};

/// Counts crossings on the task's own vertices; what is sewn may touch.
class FrameCheck {
 public:
  explicit FrameCheck(const PeerTask& task)
      : cloth_(collision::make_surface(task.cloth.triangles, static_cast<Index>(task.cloth.vertices.size()),
                                       sewn_classes(task))),
        body_(collision::make_crossing_body(task.body.vertices, task.body.triangles)) {}

  void look(std::span<const Vec3> x) {
    ++worst_.frames;
    Crew alone;
    cloth_.place(x);
    worst_.body_crossings =
        std::max(worst_.body_crossings, static_cast<int>(cloth_.with(body_, alone).size()));
    worst_.self_crossings =
        std::max(worst_.self_crossings, static_cast<int>(cloth_.with_itself(alone).size()));
  }
  const WorstFrame& worst() const { return worst_; }

 private:
  collision::CrossingCounter cloth_;
  collision::CrossingBody body_;
  WorstFrame worst_;
};

double eased(double time) {
  const double f = std::min(1.0, time / kLeadTime);
  return f * f * (3 - 2 * f);
}

/// One run of a task: a solver of its vertices, welded once the seams are shut.
class PeerRun {
 public:
  PeerRun(const PeerTask& task, const RunSettings& settings)
      : task_(task),
        settings_(settings),
        h_(settings.time_step > 0 ? settings.time_step : time_step_for(task.cloth)),
        sewing_(!task.sewn.empty()),
        watch_(h_, settings.settle_speed),
        probe_(h_, settings.settle_speed) {
    obstacles_.push_back(
        collision::make_obstacle(task.body.vertices, task.body.triangles, settings.friction, kSkinOffset));
    const drape::Weld open = drape::no_weld(task.cloth.vertices);
    build(open, {});
    std::vector<solver::constraints::Stitch> stitches;
    for (const auto& [i, j] : task.sewn) {
      stitches.push_back({i, j, length(task.cloth.vertices[i] - task.cloth.vertices[j])});
    }
    solver_->set_stitches(std::move(stitches));
  }

  bool done() const { return !reason_.empty(); }
  const std::string& reason() const { return reason_; }
  double time_step() const { return h_; }
  int steps() const { return steps_; }
  double time() const { return steps_ * h_; }
  double rest_at() const { return rest_at_; }
  double rms_speed() const { return watch_.rms_speed(); }
  double max_speed() const { return watch_.max_speed(); }
  double damping() const { return watch_.damping(); }
  double weld_gap() const { return weld_gap_; }

  solver::StepReport step() {
    lead();
    const solver::StepForces now = forces();
    const solver::StepReport report = solver_->step(now);
    ++steps_;
    watch_.observe(solver_->positions(), now.damping);
    if (report.not_finite) {
      reason_ = "not finite";
    } else if (sewing_) {
      weld_if_shut();
    }
    if (!done()) end_if_due();
    return report;
  }

  /// From here on: true motion from a standstill.
  void let_go() {
    resting_ = true;
    reason_.clear();
    stand_still();
  }

  std::vector<Vec3> positions() const {
    std::vector<Vec3> out;
    out.reserve(vertex_of_.size());
    for (const Index v : vertex_of_) out.push_back(solver_->positions()[v]);
    return out;
  }

  double gap() const {
    double most = 0;
    for (const auto& [i, j] : task_.sewn) {
      most =
          std::max(most, length(solver_->positions()[vertex_of_[i]] - solver_->positions()[vertex_of_[j]]));
    }
    return most;
  }

 private:
  void build(const drape::Weld& weld, std::vector<Vec3> velocities) {
    vertex_of_ = weld.vertex_of;
    const solver::ClothModel model = task_model(task_, fabric_of(settings_), vertex_of_, weld.vertex_count);
    solver_ = std::make_unique<solver::ClothSolver>(model, weld.positions, obstacles_, h_);
    if (!velocities.empty()) solver_->set_velocities(std::move(velocities));
  }

  void lead() {
    if (task_.led.empty() || led_) return;
    const double s = eased(time());
    std::vector<solver::constraints::HeldVertex> held;
    std::vector<bool> seen(solver_->positions().size(), false);
    for (const LedVertex& l : task_.led) {
      const Index v = vertex_of_[l.v];
      if (seen[v]) continue;  // two ends of a seam, led to one place
      seen[v] = true;
      const Vec3 start = task_.cloth.vertices[l.v];
      held.push_back({v, false, start + (l.target - start) * s});
    }
    solver_->set_holds(std::move(held));
    led_ = s == 1;
  }

  solver::StepForces forces() const {
    solver::StepForces f;
    f.gravity = kGravity;
    f.stitch_length = std::max(0.0, 1 - time() / kLeadTime);
    f.damping = 0;
    if (resting_ || settings_.dynamic || probe_.on()) return f;
    f.damping = sewing_ ? kSewDamping : watch_.damping();
    f.viscosity = solver::constraints::viscous_share(settings_.viscosity, h_, steps_);
    return f;
  }

  void weld_if_shut() {
    if (time() < kLeadTime) return;
    weld_gap_ = gap();
    if (weld_gap_ > kSeamShut) return;
    sewing::GarmentMesh mesh;
    mesh.rest.resize(vertex_of_.size());
    mesh.triangles = task_.cloth.triangles;
    mesh.weld = sewn_classes(task_);
    const std::vector<Index> before = vertex_of_;
    const std::vector<Vec3> velocities = solver_->velocities();
    const std::vector<double> masses = solver_->model().mass;
    const drape::Weld weld = drape::weld_seams(mesh, positions(), kSeamShut, obstacles_);
    if (!weld.refused.empty()) return;
    std::vector<Vec3> momentum(weld.positions.size());
    std::vector<double> mass(weld.positions.size(), 0);
    for (std::size_t i = 0; i < before.size(); ++i) {
      momentum[weld.vertex_of[i]] += velocities[before[i]] * masses[before[i]];
      mass[weld.vertex_of[i]] += masses[before[i]];
    }
    for (std::size_t v = 0; v < mass.size(); ++v) momentum[v] = momentum[v] * (1 / mass[v]);
    build(weld, std::move(momentum));
    led_ = false;
    sewing_ = false;
    watch_.restart(solver_->positions());
  }

  void stand_still() { solver_->set_velocities(std::vector<Vec3>(solver_->positions().size())); }

  /// As a drape does: core/drape/rest_probe.h.
  void begin_probe() {
    probe_.begin(solver_->positions());
    stand_still();
    watch_.look_anew(solver_->positions());
  }

  bool stays_when_let_go() {
    const auto answer = probe_.observe(solver_->positions(), solver_->model().triangles);
    if (answer == drape::RestProbe::Answer::kAgain) begin_probe();
    return answer == drape::RestProbe::Answer::kStays;
  }

  bool seems_still() {
    if (sewing_) return false;
    const bool let_go_first = !settings_.dynamic && probe_.asks();
    const bool still = watch_.settled(forces().damping, let_go_first ? drape::kSeemingCalm : 1);
    if (still && let_go_first) begin_probe();
    return still && !let_go_first;
  }

  void end_if_due() {
    if (resting_) return;
    const bool still = probe_.on() ? stays_when_let_go() : seems_still();
    if (!still) rest_at_ = -1;
    if (still && rest_at_ < 0) rest_at_ = time();
    if (still && !settings_.dynamic) reason_ = "settled";
    if (!done() && time() >= (settings_.dynamic ? kDynamicTime : kMostTime))
      reason_ = sewing_ ? "open seam" : "time";
  }

  const PeerTask& task_;
  const RunSettings settings_;
  const double h_;
  bool sewing_, led_ = false, resting_ = false;
  drape::SettleWatch watch_;
  drape::RestProbe probe_;
  std::vector<collision::Obstacle> obstacles_;
  std::unique_ptr<solver::ClothSolver> solver_;
  std::vector<Index> vertex_of_;
  std::string reason_;
  int steps_ = 0;
  double rest_at_ = -1, weld_gap_ = 0;
};

int steps_in(double seconds, double time_step) {
  return std::max(1, static_cast<int>(std::lround(seconds / time_step)));
}

RestTest test_rest(PeerRun& run, FrameCheck& check, const std::vector<Vec3>& from) {
  RestTest rest;
  run.let_go();
  const int steps = steps_in(kRestTime, run.time_step()), window = steps_in(kSpeedWindow, run.time_step());
  const int interval = steps_in(kFrameInterval, run.time_step());
  for (int i = 1; i <= steps; ++i) {
    run.step();
    if (i == steps - window) rest.before = run.positions();
    if (i % interval == 0) check.look(run.positions());
  }
  rest.end = run.positions();
  int moved = 0;
  double sum = 0, most = 0;
  for (std::size_t v = 0; v < from.size(); ++v) {
    const double way = length(rest.end[v] - from[v]), last = length(rest.end[v] - rest.before[v]);
    moved += way > 5e-3;
    rest.largest_move = std::max(rest.largest_move, way);
    sum += last * last;
    most = std::max(most, last);
  }
  const double count = static_cast<double>(from.size()), seconds = window * run.time_step();
  rest.moved_share = moved / count;
  rest.rms_speed = std::sqrt(sum / count) / seconds;
  rest.max_speed = most / seconds;
  return rest;
}

}  // namespace

material::Fabric fabric_of(const RunSettings& settings) {
  material::Fabric fabric = bench_fabric();
  for (double* bend : {&fabric.bend_warp, &fabric.bend_weft, &fabric.bend_bias})
    *bend *= settings.bend_factor;
  for (double* stretch :
       {&fabric.stretch_warp, &fabric.stretch_weft, &fabric.stretch_coupling, &fabric.stretch_shear}) {
    *stretch *= settings.stretch_factor;
  }
  fabric.friction = settings.friction;
  return fabric;
}

double time_step_for(const geometry::TriangleMesh& cloth) { return mean_edge_of(cloth) / kWaveSpeed; }

namespace {

void print_line(const PeerRun& run, const PeerEnd& end) {
  std::fprintf(
      stderr,
      "%7.3f s  rms %8.5f  max %8.5f m/s  damping %5.2f/s  measured %6ld  bounded %8ld  gap %.4f mm\n",
      run.time(), run.rms_speed(), run.max_speed(), run.damping(), end.detections, end.bounded,
      1e3 * run.gap());
}

}  // namespace

PeerEnd run_task(const PeerTask& task, const RunSettings& settings) {
  PeerEnd end;
  FrameCheck check(task);
  PauseClock clock;
  clock.resume();
  PeerRun run(task, settings);
  const int interval = steps_in(kFrameInterval, run.time_step());
  const int traced = steps_in(kTraceInterval, run.time_step());
  while (!run.done()) {
    const solver::StepReport report = run.step();
    end.detections += report.detections;
    end.measured += report.measured;
    end.bounded += report.bounded;
    if (settings.trace && run.steps() % traced == 0) print_line(run, end);
    const bool most = report.bounded > end.most_bounded;
    if (run.steps() % interval != 0 && !most) continue;
    clock.pause();
    if (most) {
      end.most_bounded = report.bounded;
      end.most_contact = run.positions();
    }
    if (run.steps() % interval == 0) check.look(run.positions());
    clock.resume();
  }
  clock.pause();
  end.cpu_s = clock.cpu_s();
  end.wall_s = clock.wall_s();
  end.final_positions = run.positions();
  end.stop_reason = run.reason();
  end.time_step = run.time_step();
  end.steps = run.steps();
  end.rest_at = run.rest_at();
  end.weld_gap = run.weld_gap();
  end.final_gap = run.gap();
  check.look(end.final_positions);
  end.rest = test_rest(run, check, end.final_positions);
  end.worst = check.worst();
  return end;
}

}  // namespace toile::peers
