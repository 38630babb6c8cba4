#include "core/drape/body_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check.h"
#include "core/collision/surface.h"

namespace toile::drape {

namespace {

/// Of the distance that cloth keeps from the skin, what a body goes at once; contact has restored it by the
/// next time.
constexpr double kMoveOfSkin = 0.4;
constexpr double kThinnestSkin = 0.2e-3;  // m
/// Steps from one move to the next at most: what lies on a body should not feel its motion in jerks.
constexpr int kLongestPace = 32;
/// A way that is shorter than this share of what is wanted is not worth measuring again.
constexpr double kShortestShare = 0.02;
/// Strain that woven cloth without limits gives way by; with a limit it is that and kOverLimit more.
constexpr double kGivesWay = 0.15, kOverLimit = 0.02;
/// Share of the triangles that may be out of shape without anybody waiting, and how many at least.
constexpr double kMostOut = 1e-3;
constexpr int kFewOut = 3;
/// What has moved by less than this share of what was wanted, over so many s, is stuck.
constexpr double kStuckShare = 0.05, kStuckTime = 0.5;
constexpr double kLongestWait = 10;  // s

bool is_out_of_shape(const solver::constraints::MembraneTriangle& t, Vec3 strain) {
  const auto most = [&](double limit) { return limit > 0 ? limit + kOverLimit : kGivesWay; };
  return strain.x > most(t.limit[0]) || strain.y > most(t.limit[1]);
}

}  // namespace

BodyMotion::BodyMotion(std::span<const body::Body> bodies, double time_step)
    : bodies_(bodies), h_(time_step), most_move_(1), boxes_(bodies.size()) {
  for (const body::Body& body : bodies) {
    for (const body::Keyframe& k : body.motion) {
      TOILE_CHECK(k.at > 0 && k.vertices.size() == body.mesh.vertices.size());
      times_.push_back(k.at);
    }
    if (!body.motion.empty())
      most_move_ = std::min(most_move_, kMoveOfSkin * std::max(body.skin_offset, kThinnestSkin));
  }
  std::sort(times_.begin(), times_.end());
  times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
  double from = 0;
  for (const double to : times_) {
    double fastest = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (!moves(b)) continue;
      const std::vector<Vec3> start = vertices_at(b, from), end = vertices_at(b, to);
      for (std::size_t v = 0; v < start.size(); ++v) fastest = std::max(fastest, length(end[v] - start[v]));
    }
    speeds_.push_back(fastest / (to - from));
    from = to;
  }
}

std::vector<Vec3> BodyMotion::vertices_at(std::size_t body, double time) const {
  return body::vertices_at(bodies_[body].mesh.vertices, bodies_[body].motion, time);
}

void BodyMotion::take(const solver::ClothModel& model) {
  triangles_ = solver::constraints::make_membrane(model);
  ways_.emplace(collision::make_surface(model.triangles, model.vertex_count(), model.vertex_class));
}

void BodyMotion::begin(const solver::ClothModel& model, std::span<const Vec3> x) {
  TOILE_CHECK(is_to_come());
  take(model);
  state_.phase = MotionState::Phase::kGoing;
  Index worst = kNone;
  state_.over = count_out_of_shape(x, worst);
}

int BodyMotion::count_out_of_shape(std::span<const Vec3> x, Index& worst) const {
  int count = 0;
  double most = 0;
  for (const solver::constraints::MembraneTriangle& t : triangles_) {
    const Vec3 strain = membrane_strain(t, x);
    if (!is_out_of_shape(t, strain)) continue;
    ++count;
    if (std::max(strain.x, strain.y) <= most) continue;
    most = std::max(strain.x, strain.y);
    worst = t.v[0];
  }
  return count;
}

/// Of the way to where they are `to` seconds into the motion.
double BodyMotion::free_share(std::span<const Vec3> x, std::span<const collision::Obstacle> obstacles,
                              double to) {
  const int few = std::max(kFewOut, static_cast<int>(kMostOut * static_cast<double>(triangles_.size())));
  Index worst = kNone;
  if (count_out_of_shape(x, worst) > state_.over + few) {
    state_.tight = worst;
    return 0;
  }
  ways_->place(x);
  double share = 1;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!moves(b)) continue;
    const collision::ObstacleWay way = ways_->way(obstacles[b], vertices_at(b, to), boxes_[b]);
    if (way.share >= share) continue;
    share = way.share;
    state_.tight = way.vertex;
  }
  return share < kShortestShare ? 0 : share;
}

void BodyMotion::place(std::span<collision::Obstacle> obstacles) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!moves(b)) continue;
    const std::vector<Vec3> now = vertices_at(b, state_.played);
    obstacles[b].velocities.clear();
    if (is_going() && state_.played > state_.before) {
      const std::vector<Vec3> before = vertices_at(b, state_.before);
      const double per_s = 1 / (h_ * state_.pace);
      for (std::size_t v = 0; v < now.size(); ++v)
        obstacles[b].velocities.push_back((now[v] - before[v]) * per_s);
    }
    collision::move_obstacle(obstacles[b], now);
  }
}

bool BodyMotion::is_stuck() {
  if (state_.waited > kLongestWait) return true;
  if (state_.since < kStuckTime) return false;
  if (state_.played - state_.marked < kStuckShare * state_.hoped) return true;
  state_.marked = state_.played;
  state_.since = state_.hoped = 0;
  return false;
}

bool BodyMotion::move(std::span<const Vec3> x, std::span<collision::Obstacle> obstacles) {
  TOILE_CHECK(is_going());
  if (--state_.steps > 0) return false;
  const bool moved_before = state_.played > state_.before;
  const bool stops = is_whole() || is_stuck();
  state_.before = state_.played;
  if (stops) {
    state_.phase = MotionState::Phase::kOver;
    place(obstacles);
    return true;
  }
  const auto next = std::upper_bound(times_.begin(), times_.end(), state_.played);
  const double speed = speeds_[static_cast<std::size_t>(next - times_.begin())];
  state_.pace = static_cast<int>(
      std::clamp(most_move_ / std::max(speed * h_, 1e-12), 1.0, static_cast<double>(kLongestPace)));
  state_.steps = state_.pace;
  // A body that is faster than it may be at once is slower than it was told to be.
  const double wanted = h_ * state_.pace, most = speed > 0 ? most_move_ / speed : wanted;
  const double to = std::min(state_.played + std::min(wanted, most), *next);
  const double share = free_share(x, obstacles, to);
  state_.waited += (1 - share) * wanted;
  state_.since += wanted;
  state_.hoped += to - state_.played;
  state_.played = share < 1 ? state_.played + share * (to - state_.played) : to;
  if (state_.played == state_.before && !moved_before) return false;
  place(obstacles);
  return true;
}

double BodyMotion::way_left_near(Vec3 near) const {
  double nearest = 1e300, left = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!moves(b)) continue;
    const std::vector<Vec3> now = vertices(b), end = vertices_at(b, times_.back());
    for (std::size_t v = 0; v < now.size(); ++v) {
      const Vec3 off = near - now[v];
      if (dot(off, off) >= nearest) continue;
      nearest = dot(off, off);
      left = length(end[v] - now[v]);
    }
  }
  return left;
}

void BodyMotion::restore(MotionState state, const solver::ClothModel& model,
                         std::span<collision::Obstacle> obstacles) {
  state_ = state;
  if (is_going()) take(model);
  place(obstacles);
}

void BodyMotion::reset(std::span<collision::Obstacle> obstacles) {
  state_ = {};
  place(obstacles);
}

}  // namespace toile::drape
