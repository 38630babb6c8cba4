#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/aabb.h"
#include "core/base/result.h"
#include "core/base/types.h"
#include "server/render/scene.h"

namespace toile::render {

/// Where the viewer stands. The body faces +z; "side" shows its left.
enum class View { kFront, kBack, kSide, kRight, kThreeQuarter, kBackQuarter };

/// "front", "back", "side", "right", "three-quarter", "back-quarter".
std::vector<std::string> view_words();
std::string_view word_of(View view);
/// Error: "render.view".
Result<View> view_from(std::string_view word);

/// Column-major, as OpenGL takes it.
using Matrix4 = std::array<float, 16>;

/// A pinhole camera. right, up and back are an orthonormal frame; the camera looks along -back.
struct Camera {
  Vec3 eye;  ///< m
  Vec3 right, up, back;
  double half_height = 0.2;      ///< tangent of half the upright field of view
  double aspect = 0.8;           ///< width / height
  double near = 0.1, far = 100;  ///< m

  /// (x, y) in pixels from the upper left corner of an image of this size, z the distance along -back, m.
  Vec3 project(Vec3 p, int width, int height) const;
  Matrix4 matrix() const;  ///< world to clip space
};

/// Looks at the scene so that no point of the garment is cropped and about a fifth of the picture's limiting
/// side is left free around it; a garment that takes much of the body is shown with the whole body. Without
/// cloth the bodies are framed; without anything, a metre of ground.
Camera frame_scene(const Scene& scene, View view, double aspect);

/// Where somebody wants to look from.
struct Viewpoint {
  Vec3 eye;                      ///< m
  std::optional<Vec3> target{};  ///< m; the middle of the cloth, or of all where there is no cloth
  double angle = 21.5;           ///< degrees that are seen from top to bottom
};

/// Error: "render.camera", in `where` what is at fault.
Status check_viewpoint(const Viewpoint& from);

/// Upright, or with the front to the picture's lower side where it looks straight up or down. Error:
/// "render.camera".
Result<Camera> camera_at(const Scene& scene, const Viewpoint& from, double aspect);

/// Scene points seen along `direction` in parallel, the box's ball filling [-1, 1]³. For shadow maps.
Matrix4 parallel_matrix(const Aabb3& box, Vec3 direction);

}  // namespace toile::render
