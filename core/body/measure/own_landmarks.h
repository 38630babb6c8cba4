#pragma once
// Landmarks that a user sets, besides those that every standing body has.
//
// On a mesh that stays as it is, a landmark is a point of a triangle. A mannequin's triangles are made anew
// from its measures, and those of two mannequins have nothing to do with each other: there a landmark is told
// from the nearest named one, goes along with that one when the body grows, and is put back on the skin.

#include <span>
#include <string>
#include <vector>

#include "core/body/measure/landmarks.h"

namespace toile::measure {

struct OwnLandmark {
  std::string name;
  SkinPoint at;      ///< a point of the mesh, where `near` is empty
  std::string near;  ///< name of a landmark before it
  Vec3 offset;       ///< m from that one; the skin nearest to there is meant
};

/// Puts `own` behind `landmarks`, each on the skin; one that has the name of a landmark already there moves
/// that one, and may be told from it. Errors, `where` being the landmark's name: landmark.duplicate (two of
/// `own`), landmark.unknown (near), landmark.no_triangle (triangle or shares not of this mesh).
Status add_own_landmarks(const geometry::TriangleMesh& mesh, std::span<const OwnLandmark> own,
                         std::vector<Landmark>& landmarks);

/// `at` told from the nearest landmark, so that it can be kept through changes of measures. REQUIRES a
/// landmark, and a triangle of the mesh.
OwnLandmark told_from_nearest(const std::string& name, const SkinPoint& at,
                              const geometry::TriangleMesh& mesh, std::span<const Landmark> landmarks);

/// m; square to the skin at a point of it, outwards where the mesh's triangles face outwards.
Vec3 skin_normal(const SkinPoint& at, const geometry::TriangleMesh& mesh);

}  // namespace toile::measure
