#include "core/dressing/clearance.h"

#include <algorithm>

#include "core/collision/contact_finder.h"

namespace toile::dressing {

namespace {

constexpr int kPasses = 30;
constexpr double kSeen = 1e-3;  // m, how far contact looks

double reach_of(const collision::Contact& contact, std::span<const Vec3> x) {
  Vec3 p;
  for (int k = 0; k < contact.count; ++k) p += x[contact.v[k]] * contact.w[k];
  return dot(contact.n, p) - contact.c;
}

void part(const collision::Contact& contact, std::vector<Vec3>& x) {
  const double missing = 2 * kLeastGap - reach_of(contact, x);
  double squares = 0;
  for (int k = 0; k < contact.count; ++k) squares += contact.w[k] * contact.w[k];
  if (missing <= 0 || squares <= 0) return;
  for (int k = 0; k < contact.count; ++k) x[contact.v[k]] += contact.n * (missing * contact.w[k] / squares);
}

class Detector {
 public:
  Detector(const collision::Surface& cloth, std::span<const collision::Obstacle> obstacles)
      : finder_(cloth, obstacles, settings()), speeds_(static_cast<std::size_t>(cloth.vertex_count()), 0) {}

  const collision::Contacts& at(std::span<const Vec3> x) {
    finder_.detect(x, speeds_, contacts_);
    return contacts_;
  }

 private:
  static collision::ContactSettings settings() {
    collision::ContactSettings s;
    s.thickness = s.trust_radius_least = s.trust_radius_most = kSeen;
    return s;
  }

  collision::ContactFinder finder_;
  std::vector<double> speeds_;
  collision::Contacts contacts_;
};

}  // namespace

double least_gap(const collision::Surface& cloth, std::span<const collision::Obstacle> obstacles,
                 std::span<const Vec3> x) {
  return Detector(cloth, obstacles).at(x).least_gap;
}

double open_gaps(const collision::Surface& cloth, std::span<const collision::Obstacle> obstacles,
                 std::vector<Vec3>& x) {
  Detector detector(cloth, obstacles);
  double gap = detector.at(x).least_gap;
  for (int i = 0; i < kPasses && gap < kLeastGap; ++i) {
    const std::vector<collision::Contact> near = detector.at(x).contacts;
    for (const collision::Contact& contact : near) part(contact, x);
    gap = detector.at(x).least_gap;
  }
  return gap;
}

}  // namespace toile::dressing
