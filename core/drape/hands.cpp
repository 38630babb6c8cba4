#include "core/drape/hands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/base/check.h"

namespace toile::drape {

namespace {

/// A pull gives way before cloth does: it lifts the whole of it twice, within limits, at the end of a spring
/// that is so long by then. Its goal is drawn no faster than a hand that arranges cloth.
constexpr double kPullWeights = 2, kLeastPull = 0.2, kMostPull = 5;  // 1, N
constexpr double kPullLength = 0.02;                                 // m
constexpr double kPullSpeed = 1;                                     // m/s
/// A pin holds the heaviest garment, and gives way by no more than a millimetre.
constexpr double kPinStiffness = 2e4, kPinForce = 50;  // N/m, N

/// Of the patch that is held, in the flat.
constexpr double kFingers = 0.025;  // m

constexpr double kFarthestHand = 100;   // m
constexpr double kSumTolerance = 1e-6;  // of the shares of a point

Error refused(const char* code, std::string message) { return {code, std::move(message), ""}; }

bool is_place(Vec3 p) {
  return std::abs(p.x) <= kFarthestHand && std::abs(p.y) <= kFarthestHand &&
         std::abs(p.z) <= kFarthestHand;  // NaN: no
}

bool is_point(const TouchedPoint& at, const sewing::GarmentMesh& garment) {
  if (at.triangle < 0 || static_cast<std::size_t>(at.triangle) >= garment.triangles.size()) return false;
  const auto [a, b, c] = at.share;
  return a >= 0 && b >= 0 && c >= 0 && std::abs(a + b + c - 1) <= kSumTolerance;
}

/// Garment vertices around a point of the cloth and what they count: most where it is, nothing at kFingers.
std::vector<std::pair<Index, double>> patch_at(const TouchedPoint& at, const sewing::GarmentMesh& garment) {
  const auto triangle = static_cast<std::size_t>(at.triangle);
  const Tri& corners = garment.triangles[triangle];
  Vec2 flat;
  for (int i = 0; i < 3; ++i) flat = flat + garment.rest[corners[i]] * at.share[i];
  const auto panel = static_cast<std::size_t>(garment.panel_of_triangle[triangle]);
  std::vector<std::pair<Index, double>> patch;
  double sum = 0;
  for (Index v = garment.first_vertex[panel]; v < garment.first_vertex[panel + 1]; ++v) {
    const double weight = 1 - length(garment.rest[v] - flat) / kFingers;
    if (weight <= 0) continue;
    patch.emplace_back(v, weight);
    sum += weight;
  }
  if (patch.size() < 3) {  // coarse cloth
    patch.clear();
    for (int i = 0; i < 3; ++i) patch.emplace_back(corners[i], at.share[i]);
    sum = at.share[0] + at.share[1] + at.share[2];
  }
  for (auto& [v, weight] : patch) weight /= sum;
  return patch;
}

Vec3 place_of(const TouchedPoint& at, const sewing::GarmentMesh& garment, std::span<const Vec3> x) {
  Vec3 mean;
  for (const auto& [v, share] : patch_at(at, garment)) mean += x[v] * share;
  return mean;
}

/// Vertices that a weld has made one have their shares together.
solver::constraints::Leash leash_at(const Grip& grip, const sewing::GarmentMesh& garment,
                                    std::span<const Index> vertex_of) {
  std::map<Index, double> shares;
  for (const auto& [v, share] : patch_at(grip.at, garment)) shares[vertex_of[v]] += share;
  solver::constraints::Leash leash;
  for (const auto& [v, share] : shares) {
    leash.patch.push_back(v);
    leash.share.push_back(share);
  }
  leash.target = grip.goal;
  return leash;
}

auto find(std::vector<Grip>& grips, int id) {
  return std::find_if(grips.begin(), grips.end(), [id](const Grip& grip) { return grip.id == id; });
}

bool holds(const std::vector<Grip>& grips, int id) {
  return std::any_of(grips.begin(), grips.end(), [id](const Grip& grip) { return grip.id == id; });
}

}  // namespace

Status Hands::check(const Touch& touch, const sewing::GarmentMesh& garment) const {
  if (state_.log.size() >= kMostTouches && touch.kind != TouchKind::kLetGo)
    return refused("live.full", "this drape has been touched as often as it can be; drape it anew");
  const bool begins =
      touch.kind == TouchKind::kPin || (touch.kind == TouchKind::kPull && !holds(state_.pulls, touch.id));
  if (begins && !is_point(touch.at, garment))
    return refused("live.point",
                   "there is no such point of the cloth: a triangle of it, and three shares of "
                   "0 to 1 whose sum is 1");
  if (touch.kind == TouchKind::kPull && !is_place(touch.target))
    return refused("live.target", "a hand pulls to a place of three numbers, in metres, within 100 m");
  if (touch.kind == TouchKind::kPull && begins && state_.pulls.size() >= kMostPulls)
    return refused("live.too_many", "as many hands pull at this cloth as may; wait until one lets go");
  if (touch.kind == TouchKind::kPin && state_.pins.size() >= kMostPins)
    return refused("live.too_many", "this cloth has as many pins as it may; remove one first");
  if (touch.kind == TouchKind::kUnpin && !holds(state_.pins, touch.id))
    return refused("live.no_pin", "there is no pin " + std::to_string(touch.id) + " in this cloth");
  return {};
}

Status Hands::take(Touch touch, const sewing::GarmentMesh& garment, std::span<const Vec3> x) {
  if (touch.kind == TouchKind::kLetGo && !holds(state_.pulls, touch.id)) return {};
  TRY(check(touch, garment));
  touch.target += Vec3{};  // a zero without a sign, as a log that is read back has it
  for (double& share : touch.at.share) share += 0.0;
  const auto place = [&] { return place_of(touch.at, garment, x); };
  switch (touch.kind) {
    case TouchKind::kPull:
      if (const auto pull = find(state_.pulls, touch.id); pull != state_.pulls.end()) {
        pull->wanted = touch.target;
        touch.at = {};  // it holds what it holds
      } else {
        state_.pulls.push_back({touch.id, touch.at, touch.target, place()});
      }
      break;
    case TouchKind::kLetGo:
      state_.pulls.erase(find(state_.pulls, touch.id));
      break;
    case TouchKind::kPin: {
      const auto pins = std::count_if(state_.log.begin(), state_.log.end(),
                                      [](const Touch& t) { return t.kind == TouchKind::kPin; });
      touch.id = static_cast<int>(pins) + 1;
      state_.pins.push_back({touch.id, touch.at, place(), place()});
      break;
    }
    case TouchKind::kUnpin:
      state_.pins.erase(find(state_.pins, touch.id));
      break;
  }
  log(touch);
  return {};
}

/// Of two places that a hand goes to at one step, only the later is ever seen.
void Hands::log(const Touch& touch) {
  if (touch.kind == TouchKind::kPull && touch.at.triangle == kNone && !state_.log.empty()) {
    Touch& last = state_.log.back();
    if (last.kind == TouchKind::kPull && last.id == touch.id && last.step == touch.step) {
      last.target = touch.target;
      return;
    }
  }
  state_.log.push_back(touch);
}

bool Hands::follow(double h) {
  bool moved = false;
  for (Grip& pull : state_.pulls) {
    const Vec3 way = pull.wanted - pull.goal;
    const double l = length(way), most = kPullSpeed * h;
    if (l <= 0) continue;
    pull.goal = l <= most ? pull.wanted : pull.goal + way * (most / l);
    moved = true;
  }
  return moved;
}

std::vector<solver::constraints::Leash> Hands::leashes(const sewing::GarmentMesh& garment,
                                                       std::span<const Index> vertex_of,
                                                       double weight) const {
  std::vector<solver::constraints::Leash> leashes;
  for (const Grip& pull : state_.pulls) {
    solver::constraints::Leash& leash = leashes.emplace_back(leash_at(pull, garment, vertex_of));
    leash.most_force = std::clamp(kPullWeights * weight, kLeastPull, kMostPull);
    leash.stiffness = leash.most_force / kPullLength;
  }
  for (const Grip& pin : state_.pins) {
    solver::constraints::Leash& leash = leashes.emplace_back(leash_at(pin, garment, vertex_of));
    leash.most_force = kPinForce;
    leash.stiffness = kPinStiffness;
  }
  return leashes;
}

void Hands::aim(std::vector<solver::constraints::Leash>& leashes) const {
  TOILE_CHECK(leashes.size() == state_.pulls.size() + state_.pins.size());
  for (std::size_t k = 0; k < state_.pulls.size(); ++k) leashes[k].target = state_.pulls[k].goal;
}

bool is_sound(const HandsState& state, const sewing::GarmentMesh& garment) {
  const auto sound = [&](const Grip& grip) {
    return is_point(grip.at, garment) && is_place(grip.wanted) && is_place(grip.goal);
  };
  return state.pulls.size() <= Hands::kMostPulls && state.pins.size() <= Hands::kMostPins &&
         std::all_of(state.pulls.begin(), state.pulls.end(), sound) &&
         std::all_of(state.pins.begin(), state.pins.end(), sound) && check_touches(state.log, garment).ok();
}

Status check_touches(const std::vector<Touch>& touches, const sewing::GarmentMesh& garment) {
  Hands hands;
  const std::vector<Vec3> anywhere(garment.rest.size());
  int step = 0;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    Touch touch = touches[i];
    const std::string where = "touch " + std::to_string(i);
    if (touch.step < step) return Error{"live.order", "the steps of a log do not go back", where};
    step = touch.step;
    if (const Status taken = hands.take(touch, garment, anywhere); !taken)
      return Error{taken.error().code, taken.error().message, where};
  }
  return {};
}

}  // namespace toile::drape
