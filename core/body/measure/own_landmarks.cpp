#include "core/body/measure/own_landmarks.h"

#include <algorithm>
#include <cmath>

namespace toile::measure {

namespace {

bool is_on(const SkinPoint& at, const geometry::TriangleMesh& mesh) {
  // Of shares that a document writes with a few digits.
  constexpr double kRounding = 1e-6;
  if (at.triangle < 0 || at.triangle >= static_cast<Index>(mesh.triangles.size())) return false;
  const auto [a, b, c] = at.share;
  return a >= -kRounding && b >= -kRounding && c >= -kRounding && std::abs(a + b + c - 1) < kRounding;
}

Result<SkinPoint> skin_point_of(const OwnLandmark& own, const geometry::TriangleMesh& mesh,
                                std::span<const Landmark> landmarks) {
  if (own.near.empty()) {
    if (is_on(own.at, mesh)) return own.at;
    return Error{"landmark.no_triangle",
                 "it must lie on a triangle of its body (there are " + std::to_string(mesh.triangles.size()) +
                     ", the first is 0), with three shares from 0 to 1 that sum to 1",
                 own.name};
  }
  const Landmark* from = landmark_named(landmarks, own.near);
  if (from == nullptr) {
    return Error{"landmark.unknown", "the body has no landmark \"" + own.near + "\" from which this is told",
                 own.name};
  }
  return nearest_on_skin(mesh, from->place + own.offset);
}

}  // namespace

Status add_own_landmarks(const geometry::TriangleMesh& mesh, std::span<const OwnLandmark> own,
                         std::vector<Landmark>& landmarks) {
  for (std::size_t i = 0; i < own.size(); ++i) {
    const OwnLandmark& mark = own[i];
    const auto same = [&](const auto& other) { return other.name == mark.name; };
    const auto before = own.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(own.begin(), before, same))
      return Error{"landmark.duplicate", "another landmark here has that name", mark.name};
    // In the document's order: one may be told from one before it, and replaces a found one of its name.
    const SkinPoint at = TRY(skin_point_of(mark, mesh, landmarks));
    const Landmark placed{mark.name, at, position_of(at, mesh)};
    const auto found = std::find_if(landmarks.begin(), landmarks.end(), same);
    if (found != landmarks.end()) {
      *found = placed;
    } else {
      landmarks.push_back(placed);
    }
  }
  return {};
}

OwnLandmark told_from_nearest(const std::string& name, const SkinPoint& at,
                              const geometry::TriangleMesh& mesh, std::span<const Landmark> landmarks) {
  // From the nearest, since the offset keeps its length on a body of other proportions.
  const Vec3 p = position_of(at, mesh);
  const auto nearest = std::min_element(
      landmarks.begin(), landmarks.end(),
      [&](const Landmark& a, const Landmark& b) { return length(a.place - p) < length(b.place - p); });
  return {name, {}, nearest->name, p - nearest->place};
}

Vec3 skin_normal(const SkinPoint& at, const geometry::TriangleMesh& mesh) {
  const Tri& t = mesh.triangles[static_cast<std::size_t>(at.triangle)];
  const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
  return normalized(cross(mesh.vertices[static_cast<std::size_t>(t[1])] - a,
                          mesh.vertices[static_cast<std::size_t>(t[2])] - a));
}

}  // namespace toile::measure
