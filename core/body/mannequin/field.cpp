#include "core/body/mannequin/field.h"

#include <algorithm>
#include <cmath>

namespace toile::mannequin {
namespace {

constexpr double kMidline = 0.0024;  // rounds the crease where the two halves meet
constexpr double kLegsMeet = 0.022;  // radius of the union of the two legs
constexpr size_t kLegPart = 1, kTrunkParts = 2;
constexpr double kThumbBlend = 0.018, kThumbRoot = 0.0088, kThumbTip = 0.0064;
constexpr double kRidgeStep = 0.02;  // height of the shelves on which ridges are kept
constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

FieldSample ellipsoid_at(const SoftEllipsoid& e, Vec3 p) {
  const Vec3 d = p - e.centre;
  const Vec3 radius{d.x < 0 ? e.low.x : e.high.x, d.y < 0 ? e.low.y : e.high.y, d.z < 0 ? e.low.z : e.high.z};
  const Vec3 q{d.x / radius.x, d.y / radius.y, d.z / radius.z};
  // (1 − 1/g) is 0 on the surface and grows along the ray from the centre, as the distance does; the least
  // values keep the centre itself finite.
  const double g = std::max(length(q), 1e-6), r = std::max(length(d), 1e-6);
  const Vec3 by_g{q.x / radius.x, q.y / radius.y, q.z / radius.z};
  const Vec3 gradient = d * ((1 - 1 / g) / r) + by_g * (r / (g * g * g));
  // By its own slope, as a loft: remeshing steps along the field as if it were a distance.
  const double norm = std::clamp(length(gradient), 0.6, 6.0);
  return {r * (1 - 1 / g) / norm, gradient * (1 / norm)};
}

// A cone with round ends.
FieldSample capsule_at(Vec3 a, Vec3 b, double radius_a, double radius_b, Vec3 p) {
  const Vec3 axis = b - a;
  const double s = std::clamp(dot(p - a, axis) / dot(axis, axis), 0.0, 1.0);
  const Vec3 d = p - (a + axis * s);
  const double l = std::max(length(d), 1e-9);
  return {l - (radius_a + (radius_b - radius_a) * s), d * (1 / l)};
}

// Cubic smooth minimum: nothing changes where the two differ by more than k.
FieldSample smooth_union(const FieldSample& a, const FieldSample& b, double k) {
  const FieldSample &low = b.value < a.value ? b : a, &high = b.value < a.value ? a : b;
  const double h = std::max(k - (high.value - low.value), 0.0) / k;
  const double w = h * h / 2;
  return {low.value - h * h * h * k / 6, low.gradient * (1 - w) + high.gradient * w};
}

}  // namespace

BodyField::BodyField(const BodyShape& shape) : figure_(shape) {
  const PlacedFigure& f = figure_;
  // Each: loft, caps at its ends and smoothing, origin, its axes u, v, t, and how far it blends into the
  // rest.
  parts_.push_back({{f.torso, {0.0071, 0.03, 0.02}}, {}, kX, kZ, kY, 0});
  parts_.push_back({{f.leg, {0.006, 0.01, 0.030}}, {}, kX, kZ, kY, 0.030});
  const double cosine = std::sqrt(1 - kToeOut * kToeOut);
  const Vec3 toes{kToeOut, 0, cosine}, side{cosine, 0, -kToeOut};
  parts_.push_back({{f.foot, {0.0036, 0.0167, 0.0238}}, f.foot_origin, side, kY, toes, 0.0179});
  parts_.push_back({{f.yoke, {0.0048, 0.01, 0.0298}}, {}, kY, kZ, kX, 0.0298});
  parts_.push_back({{f.neck, {0.006, 0.01, 0.0119}}, {}, kX, kZ, kY, 0.0420});
  parts_.push_back({{f.head, {0.0036, 0.022, 0.048 * shape.head}}, {}, kX, kZ, kY, 0.0170});
  parts_.push_back({{f.arm, {0.0071, 0.0179, 0.01}}, f.shoulder, f.out_of_arm, kZ, f.along_arm, 0.0270});
  parts_.push_back({{f.hand, {0.0048, 0.0119, 0.0179}}, f.shoulder, f.out_of_arm, kZ, f.along_arm, 0.0119});
  half_breadth_ = std::max(f.shoulder.x + f.along_arm.x * f.hand_end + 0.03, 0.2);
  chin_ = f.height_of(shape.figure->chin);
  crotch_ = f.height_of(shape.figure->crotch);
  sort_ridges();
}

void BodyField::sort_ridges() {
  ridges_by_height_.resize(static_cast<size_t>(1.1 / kRidgeStep) + 1);
  const auto shelf = [&](double y) {
    return static_cast<size_t>(
        std::clamp(y / kRidgeStep, 0.0, static_cast<double>(ridges_by_height_.size() - 1)));
  };
  for (const Stroke& s : figure_.strokes) {
    const Vec3 axis = s.b - s.a;
    const auto index = static_cast<Index>(ridges_.size());
    ridges_.push_back({s.a, axis, 1 / std::max(dot(axis, axis), 1e-12), s.radius, s.height});
    const size_t last = shelf(std::max(s.a.y, s.b.y) + s.radius);
    for (size_t i = shelf(std::min(s.a.y, s.b.y) - s.radius); i <= last; ++i)
      ridges_by_height_[i].push_back(index);
  }
}

// Moves the surface by (1 − q²)² of a ridge's height, q the distance to its line over its radius.
void BodyField::sculpt(FieldSample& body, Vec3 p) const {
  const double level = std::clamp(p.y / kRidgeStep, 0.0, static_cast<double>(ridges_by_height_.size() - 1));
  for (Index i : ridges_by_height_[static_cast<size_t>(level)]) {
    const Ridge& r = ridges_[i];
    const Vec3 from = p - r.a;
    const Vec3 d = from - r.axis * std::clamp(dot(from, r.axis) * r.per_length2, 0.0, 1.0);
    const double q2 = dot(d, d) / (r.radius * r.radius);
    if (q2 >= 1) continue;
    body.value -= r.height * (1 - q2) * (1 - q2);
    body.gradient += d * (4 * r.height * (1 - q2) / (r.radius * r.radius));
  }
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

FieldSample BodyField::half_at(Vec3 p) const {
  FieldSample body = parts_[0].loft.at({p.x, p.z, p.y});
  body.gradient = {body.gradient.x, body.gradient.z, body.gradient.y};
  join(body, parts_[kLegPart], p);
  if (p.x < kLegsMeet) {
    // The other leg: their union rounds the arch between them.
    FieldSample other = parts_[kLegPart].loft.at({-p.x, p.z, p.y});
    other.gradient = {-other.gradient.x, other.gradient.z, other.gradient.y};
    body = smooth_union(body, other, kLegsMeet);
  }
  body = smooth_union(body, ellipsoid_at(figure_.buttock, p), figure_.buttock.blend);
  if (figure_.bust.blend > 0) body = smooth_union(body, ellipsoid_at(figure_.bust, p), figure_.bust.blend);
  for (size_t i = kTrunkParts; i < parts_.size(); ++i) join(body, parts_[i], p);
  body = smooth_union(body, capsule_at(figure_.thumb[0], figure_.thumb[1], kThumbRoot, kThumbTip, p),
                      kThumbBlend);
  sculpt(body, p);
  return body;
}

FieldSample BodyField::at(Vec3 p) const {
  // The body is its left half seen in a mirror; a mirror alone would leave a crease along the middle.
  const double x = std::sqrt(p.x * p.x + kMidline * kMidline);
  FieldSample s = half_at({x, p.y, p.z});
  s.gradient.x *= p.x / x;
  return s;
}

double BodyField::fineness(Vec3 p, double detail) const {
  const Vec3 d = Vec3{std::abs(p.x), p.y, p.z} - figure_.shoulder;
  // Hands, feet, faces and the crotch are finer than the rest: edges there are this share of the usual one.
  const double along = dot(d, figure_.along_arm);
  const double near_arm = length(d - figure_.along_arm * along) < 0.09 ? 1 : 0;
  const double hand = near_arm * smooth_step(figure_.wrist - 0.07, figure_.wrist, along);
  const double foot = 1 - smooth_step(0.04, 0.1, p.y);
  const double head = smooth_step(chin_ - 0.05, chin_ + 0.01, p.y);
  const double face = detail * smooth_step(0.02, 0.05, p.z) * head;
  const double crotch = 1 - smooth_step(0.03, 0.07, length(p - Vec3{0, crotch_, -0.012}));
  return 1 - std::max({0.68 * hand, 0.45 * foot, 0.25 * head + 0.35 * face, 0.6 * crotch});
}

}  // namespace toile::mannequin
