#include "core/body/body_field.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double kMidline = 0.0024;  // rounds the crease where the two halves meet
constexpr double kLegsMeet = 0.042;  // radius of the union of the two legs
constexpr size_t kLeg = 1;           // index of the part
constexpr double kThumbBlend = 0.015, kThumbRoot = 0.0092, kThumbTip = 0.0068;
constexpr double kGrooveDepth = 0.0030, kGrooveWidth = 0.017;  // along the spine
constexpr Vec3 kCrotch{0, 0.447, -0.012};                      // a narrow arch that needs finer triangles
constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};
// How much of a change of girth each direction takes: bellies and breasts grow forwards.
constexpr double kWidthShare = 0.85, kFrontShare = 1.3, kBackShare = 1.0;

double smooth_step(double low, double high, double x) {
  const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

double mix(double a, double b, double s) { return a + (b - a) * s; }
double grown(double scale, double share) { return 1 + share * (scale - 1); }

// The trunk's factor at a height: hip, waist and bust planes, fading towards the shoulders.
double trunk_scale(const BodyShape& s, double y) {
  if (y < kWaistHeight) return mix(s.hip, s.waist, smooth_step(kHipHeight, kWaistHeight, y));
  if (y < kBustHeight) return mix(s.waist, s.bust, smooth_step(kWaistHeight, kBustHeight, y));
  return mix(s.bust, grown(s.bust, 0.5), smooth_step(kBustHeight, 0.8, y));
}

std::vector<LoftSection> scaled_torso(const BodyShape& shape) {
  std::vector<LoftSection> rows(female_tables().torso.begin(), female_tables().torso.end());
  for (LoftSection& r : rows) {
    const double s = trunk_scale(shape, r.t);
    r.half *= grown(s, kWidthShare), r.front *= grown(s, kFrontShare), r.back *= grown(s, kBackShare);
  }
  return rows;
}

// Thighs follow the hip, ankles hardly; a thicker leg moves outwards so that the gap between them stays.
std::vector<LoftSection> scaled_leg(const BodyShape& shape) {
  std::vector<LoftSection> rows(female_tables().leg.begin(), female_tables().leg.end());
  for (LoftSection& r : rows) {
    const double s = grown(shape.hip, mix(0.3, 0.9, smooth_step(0.1, 0.42, r.t)));
    r.u += (s - 1) * r.half;
    r.half *= s, r.front *= s, r.back *= s;
  }
  return rows;
}

std::vector<LoftSection> scaled_round(std::span<const LoftSection> from, double s, bool along) {
  std::vector<LoftSection> rows(from.begin(), from.end());
  for (LoftSection& r : rows) {
    r.half *= s, r.front *= s, r.back *= s;
    if (along) r.t *= s;
  }
  return rows;
}

FieldSample ellipsoid_at(const SoftEllipsoid& e, Vec3 p) {
  const Vec3 d = p - e.centre;
  const Vec3 radius{d.x < 0 ? e.low.x : e.high.x, d.y < 0 ? e.low.y : e.high.y, d.z < 0 ? e.low.z : e.high.z};
  const Vec3 q{d.x / radius.x, d.y / radius.y, d.z / radius.z};
  const double g = std::max(length(q), 1e-6), r = std::max(length(d), 1e-6);
  const Vec3 by_g{q.x / radius.x, q.y / radius.y, q.z / radius.z};
  const Vec3 gradient = d * ((1 - 1 / g) / r) + by_g * (r / (g * g * g));
  const double norm = std::clamp(length(gradient), 0.6, 6.0);
  return {r * (1 - 1 / g) / norm, gradient * (1 / norm)};
}

// A cone with round ends.
FieldSample capsule_at(Vec3 a, Vec3 b, double radius_a, double radius_b, Vec3 p) {
  const Vec3 axis = b - a;
  const double s = std::clamp(dot(p - a, axis) / dot(axis, axis), 0.0, 1.0);
  const Vec3 d = p - (a + axis * s);
  const double l = std::max(length(d), 1e-9);
  return {l - mix(radius_a, radius_b, s), d * (1 / l)};
}

// Cubic smooth minimum: nothing changes where the two differ by more than k.
FieldSample smooth_union(const FieldSample& a, const FieldSample& b, double k) {
  const FieldSample &low = b.value < a.value ? b : a, &high = b.value < a.value ? a : b;
  const double h = std::max(k - (high.value - low.value), 0.0) / k;
  const double w = h * h / 2;
  return {low.value - h * h * h * k / 6, low.gradient * (1 - w) + high.gradient * w};
}

// Lowers the surface along the spine.
void groove(FieldSample& s, Vec3 p) {
  const double q = p.x / kGrooveWidth;
  if (p.z > -0.02 || q >= 1) return;
  const double along = smooth_step(0.56, 0.62, p.y) * (1 - smooth_step(0.74, 0.8, p.y));
  const double bump = (1 - q * q) * (1 - q * q);
  s.value += kGrooveDepth * along * bump;
  s.gradient.x -= kGrooveDepth * along * 4 * (1 - q * q) * q / kGrooveWidth;
}

SoftEllipsoid scaled(SoftEllipsoid e, double s, double plane_scale, double toward) {
  e.centre.x *= grown(plane_scale, kWidthShare);
  e.centre.z += toward * (plane_scale - 1);
  e.low = e.low * s, e.high = e.high * s;
  return e;
}

}  // namespace

BodyField::BodyField(const BodyShape& shape) {
  const FemaleTables& f = female_tables();
  const double upper = grown(shape.bust, 0.5), limb = grown(shape.bust, 0.4);
  const std::vector<LoftSection> leg = scaled_leg(shape);
  parts_.push_back({{scaled_torso(shape), {0.0071, 0.03, 0.02}}, {}, kX, kZ, kY, 0});
  parts_.push_back({{leg, {0.006, 0.01, 0.0357}}, {}, kX, kZ, kY, 0.0238});
  trunk_parts_ = parts_.size();

  const double cosine = std::sqrt(1 - kToeOut * kToeOut);
  const Vec3 toes{kToeOut, 0, cosine}, side{cosine, 0, -kToeOut};
  parts_.push_back({{f.foot, {0.0036, 0.0167, 0.0238}}, {leg[0].u, 0, leg[0].v}, side, kY, toes, 0.0179});
  parts_.push_back({{scaled_round(f.yoke, upper, true), {0.0048, 0.01, 0.0298}}, {}, kY, kZ, kX, 0.0298});
  parts_.push_back({{f.neck, {0.006, 0.01, 0.0119}}, {}, kX, kZ, kY, 0.0446});
  parts_.push_back({{f.head, {0.0036, 0.022, 0.048}}, {}, kX, kZ, kY, 0.0179});

  shoulder_ = {kShoulderJoint.x * upper, kShoulderJoint.y, kShoulderJoint.z};
  const double arm_cosine = std::sqrt(1 - shape.arm_sine * shape.arm_sine);
  arm_ = {shape.arm_sine, -arm_cosine, 0};
  const Vec3 out{arm_cosine, shape.arm_sine, 0};
  parts_.push_back(
      {{scaled_round(f.arm, limb, false), {0.0071, 0.0179, 0.01}}, shoulder_, out, kZ, arm_, 0.0357});
  parts_.push_back({{f.hand, {0.0048, 0.0119, 0.0179}}, shoulder_, out, kZ, arm_, 0.0119});
  thumb_[0] = shoulder_ + arm_ * 0.328 + kZ * 0.030 - out * 0.002;
  thumb_[1] = shoulder_ + arm_ * 0.372 + kZ * 0.0495 - out * 0.006;

  bust_ = scaled(f.bust, shape.bust, shape.bust, 0.0625 * kFrontShare * 0.6);
  buttock_ = scaled(f.buttock, shape.hip, shape.hip, -0.03);
  half_breadth_ = std::max(shoulder_.x + arm_.x * kHandEnd + 0.03, 0.2);
}

void BodyField::join(FieldSample& body, const Part& part, Vec3 p) {
  const Vec3 d = p - part.origin;
  const Vec3 uvt{dot(d, part.u), dot(d, part.v), dot(d, part.t)};
  // A part whose hull is farther than the body by more than the blend changes nothing.
  const double beyond = std::max({0.0, part.loft.start() - uvt.z, uvt.z - part.loft.end()});
  const double off = std::max(0.0, std::sqrt(uvt.x * uvt.x + uvt.y * uvt.y) - part.loft.reach());
  if (beyond * beyond + off * off > (body.value + part.blend) * (body.value + part.blend) &&
      body.value + part.blend > 0) {
    return;
  }
  FieldSample s = part.loft.at(uvt);
  s.gradient = part.u * s.gradient.x + part.v * s.gradient.y + part.t * s.gradient.z;
  body = smooth_union(body, s, part.blend);
}

FieldSample BodyField::half_at(Vec3 p, bool trunk_only) const {
  FieldSample body = parts_[0].loft.at({p.x, p.z, p.y});
  body.gradient = {body.gradient.x, body.gradient.z, body.gradient.y};
  for (size_t i = 1; i < trunk_parts_; ++i) join(body, parts_[i], p);
  if (p.x < kLegsMeet) {
    // The other leg: their union rounds the arch between them.
    FieldSample other = parts_[kLeg].loft.at({-p.x, p.z, p.y});
    other.gradient = {-other.gradient.x, other.gradient.z, other.gradient.y};
    body = smooth_union(body, other, kLegsMeet);
  }
  body = smooth_union(body, ellipsoid_at(buttock_, p), buttock_.blend);
  body = smooth_union(body, ellipsoid_at(bust_, p), bust_.blend);
  groove(body, p);
  if (trunk_only) return body;
  for (size_t i = trunk_parts_; i < parts_.size(); ++i) join(body, parts_[i], p);
  return smooth_union(body, capsule_at(thumb_[0], thumb_[1], kThumbRoot, kThumbTip, p), kThumbBlend);
}

FieldSample BodyField::at(Vec3 p) const {
  const double x = std::sqrt(p.x * p.x + kMidline * kMidline);
  FieldSample s = half_at({x, p.y, p.z}, false);
  s.gradient.x *= p.x / x;
  return s;
}

FieldSample BodyField::trunk_at(Vec3 p) const {
  const double x = std::sqrt(p.x * p.x + kMidline * kMidline);
  FieldSample s = half_at({x, p.y, p.z}, true);
  s.gradient.x *= p.x / x;
  return s;
}

double BodyField::fineness(Vec3 p) const {
  const Vec3 d = Vec3{std::abs(p.x), p.y, p.z} - shoulder_;
  const double along = dot(d, arm_);
  const double near_arm = length(d - arm_ * along) < 0.09 ? 1 : 0;
  const double hand = near_arm * smooth_step(kHandStart - 0.07, kHandStart, along);
  const double foot = 1 - smooth_step(0.04, 0.1, p.y);
  const double head = smooth_step(0.82, 0.88, p.y);
  const double crotch = 1 - smooth_step(0.03, 0.07, length(p - kCrotch));
  return 1 - std::max({0.6 * hand, 0.45 * foot, 0.25 * head, 0.4 * crotch});
}

}  // namespace toile
