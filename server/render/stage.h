#pragma once
// A scene on the graphics side, with the soft light that reaches it: what its pictures have in common.

#include <vector>

#include "core/base/aabb.h"
#include "server/render/gl/objects.h"
#include "server/render/programs.h"
#include "server/render/scene.h"
#include "server/render/surface_vertices.h"
#include "server/render/surfaces.h"

namespace toile::render {

/// The context must be current while it is made and as it ends; the scene must outlive it.
class Stage {
 public:
  Stage(const GlFunctions& gl, const Programs& programs, const Scene& scene);

  /// What casts shadows, into a depth map. Bodies are closed: their lit side casts all of the shadow.
  void draw_casters() const;

  const Aabb3& box() const { return box_; }
  const DrawnSurface& cloth() const { return cloth_; }
  const std::vector<ClothRun>& runs() const { return runs_; }  ///< of the cloth
  const std::vector<DrawnSurface>& bodies() const { return bodies_; }
  const DrawnSurface& ground() const { return ground_; }
  GLuint picture(Index image) const { return pictures_[static_cast<std::size_t>(image)]; }
  Vec3 middle() const;
  /// m, from the middle, within which the ground catches shadows
  double reach() const;

 private:
  void upload_cloth_and_bodies(const Scene& scene);
  void upload_ground(const Scene& scene);
  void light();

  const GlFunctions& gl_;
  const Programs& programs_;
  Aabb3 box_;
  GlScope scope_;
  DrawnSurface cloth_, ground_;
  std::vector<DrawnSurface> bodies_;
  std::vector<ClothRun> runs_;
  std::vector<GLuint> pictures_;  // as Textures::images
};

}  // namespace toile::render
