#include <algorithm>
#include <cmath>

#include "core/preflight/check_pattern.h"
#include "core/preflight/check_sides.h"

namespace toile::preflight {

namespace {

/// How far two sides must run against each other, as a correlation from -1 to 1.
constexpr double kAgainst = -0.5, kAlong = 0.5;
/// A seam is reversed only where that shortens its threads to less than this share.
constexpr double kWorth = 0.97;

struct Threads {
  std::vector<std::size_t> rows;  ///< of GarmentMesh::sewn, in order along side a
  std::vector<Vec3> a, b;         ///< m
};

Threads threads_of(const sewing::Assembly& assembly, Index seam) {
  Threads t;
  for (std::size_t k = 0; k < assembly.garment.sewn.size(); ++k) {
    if (assembly.garment.seam_of_sewn[k] != seam) continue;
    t.rows.push_back(k);
    t.a.push_back(assembly.positions[assembly.garment.sewn[k][0]]);
    t.b.push_back(assembly.positions[assembly.garment.sewn[k][1]]);
  }
  return t;
}

double total_length(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += length(a[i] - b[i]);
  return sum;
}

Vec3 mean_of(const std::vector<Vec3>& x) {
  Vec3 sum;
  for (const Vec3& p : x) sum += p;
  return sum * (1.0 / static_cast<double>(x.size()));
}

/// 1 where the two rows of points have the same shape and run the same way, -1 where they run opposite.
double correlation(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  const Vec3 ca = mean_of(a), cb = mean_of(b);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += dot(a[i] - ca, b[i] - cb);
    aa += dot(a[i] - ca, a[i] - ca);
    bb += dot(b[i] - cb, b[i] - cb);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

void reverse_seam(const Threads& t, sewing::Assembly& assembly) {
  std::vector<Index> partners;
  for (const std::size_t row : t.rows) partners.push_back(assembly.garment.sewn[row][1]);
  std::reverse(partners.begin(), partners.end());
  for (std::size_t i = 0; i < t.rows.size(); ++i) assembly.garment.sewn[t.rows[i]][1] = partners[i];
}

}  // namespace

void untwist_seams(const PreflightInput& input, sewing::Assembly& assembly, Findings& findings) {
  bool changed = false;
  for (Index s = 0; s < static_cast<Index>(input.pattern.seams.size()); ++s) {
    const Threads t = threads_of(assembly, s);
    if (t.rows.size() < 3) continue;
    const std::vector<Vec3> back(t.b.rbegin(), t.b.rend());
    const double now = total_length(t.a, t.b), then = total_length(t.a, back);
    if (correlation(t.a, t.b) > kAgainst || correlation(t.a, back) < kAlong || then >= kWorth * now) continue;
    const pattern::Seam& seam = input.pattern.seams[s];
    Finding f = found(FindingKind::kTwisted,
                      "the threads of the seam cross over: " + length_text(now) + " of thread in all, and " +
                          length_text(then) + " with one side reversed; reverse the seam",
                      {seam_named(seam.id)}, place_of_seam(assembly, s));
    // Only the points of single edges lie alike both ways.
    if (seam.a.size() == 1 && seam.b.size() == 1 && seam.a[0].panel != seam.b[0].panel) {
      reverse_seam(t, assembly);
      f.repaired = changed = true;
      f.message += ", as was done for this drape";
    }
    findings.push_back(std::move(f));
  }
  if (changed)
    assembly.garment.weld = sewing::least_of_class(assembly.garment.vertex_count(), assembly.garment.sewn);
}

}  // namespace toile::preflight
