#include "core/paper/candidates.h"

namespace toile::paper {

namespace {

/// How far a particle may go before all are looked up again: wider, and there is more to try each step.
constexpr double kReach = 8e-3;  // m

HeightSorted sorted_by_height(const Solids& solids) {
  std::vector<geometry::Box3> boxes;
  for (const Corners& t : solids.triangles) boxes.push_back(geometry::box_around({t[0], t[1], t[2]}, 0));
  return HeightSorted(boxes);
}

bool holds(const geometry::Box3& box, Vec3 p) {
  const double c[3] = {p.x, p.y, p.z};
  for (int k = 0; k < 3; ++k)
    if (!(c[k] >= static_cast<double>(box.lo[k]) && c[k] <= static_cast<double>(box.hi[k]))) return false;
  return true;
}

}  // namespace

void Candidates::Lists::clear() {
  first.assign(1, 0);
  all.clear();
}

Candidates::Candidates(const Particles& particles, const Solids& solids)
    : particles_(particles), sorted_solids_(sorted_by_height(solids)) {}

bool Candidates::covered(std::span<const Vec3> before, std::span<const Vec3> now) const {
  if (kept_.size() != now.size()) return false;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (!holds(kept_[i], before[i]) || !holds(kept_[i], now[i])) return false;
  return true;
}

bool Candidates::belongs_to(Index particle, const Tri& triangle) const {
  const Index sewn = particles_.weld[particle];
  return particles_.weld[triangle[0]] == sewn || particles_.weld[triangle[1]] == sewn ||
         particles_.weld[triangle[2]] == sewn;
}

void Candidates::cover(std::span<const Vec3> before, std::span<const Vec3> now) {
  if (covered(before, now)) return;
  kept_.clear();
  for (std::size_t i = 0; i < now.size(); ++i)
    kept_.push_back(geometry::box_around({before[i], now[i]}, kReach));
  std::vector<geometry::Box3> boxes;
  for (const Tri& t : particles_.triangles)
    boxes.push_back(geometry::join(geometry::join(kept_[t[0]], kept_[t[1]]), kept_[t[2]]));
  const HeightSorted sorted_cloth(boxes);

  near_solids_.clear();
  near_cloth_.clear();
  for (Index i = 0; i < static_cast<Index>(now.size()); ++i) {
    sorted_solids_.query(kept_[i], [&](Index t) { near_solids_.all.push_back(t); });
    near_solids_.end_one();
    sorted_cloth.query(kept_[i], [&](Index t) {
      if (!belongs_to(i, particles_.triangles[t])) near_cloth_.all.push_back(t);
    });
    near_cloth_.end_one();
  }
}

}  // namespace toile::paper
