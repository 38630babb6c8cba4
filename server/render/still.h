#pragma once
// Pictures of a draped garment, as a studio would take them. Equal input gives equal bytes on one machine.

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "server/render/camera.h"
#include "server/render/scene.h"

namespace toile::render {

/// 8-bit sRGB, three bytes per pixel, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
  std::vector<std::uint8_t> opacity{};  ///< a byte per pixel; empty: all opaque
};

struct StillSettings {
  int width = 1024, height = 1280;  ///< pixels, 16 to 4096 each
  int samples = 4;  ///< 1, 4 or 16 per pixel; what OpenGL cannot do itself is drawn larger and averaged
  bool transparent = false;  ///< no backdrop, and of the ground the shadow only
};

/// Error: "render.settings".
Status check_settings(const StillSettings& settings);

class Stage;

/// A scene made ready for pictures from anywhere, which share its soft light: the second takes half the time
/// of the first. The scene and the renderer must outlive it; of one thread's renderer one alone draws at a
/// time.
class StagedScene {
 public:
  ~StagedScene();
  /// Errors: "render.settings", "render.failed" (OpenGL is out of memory).
  Result<Image> picture(View view, const StillSettings& settings = {}) const;
  /// The same from any camera; its aspect must fit the settings' width and height.
  Result<Image> picture(const Camera& camera, const StillSettings& settings = {}) const;

 private:
  friend class StillRenderer;
  struct Parts;
  explicit StagedScene(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// Holds the OpenGL context and programs from one picture to the next: the first takes about half a second
/// more. Belongs to one thread.
class StillRenderer {
 public:
  /// Errors: "render.no_context", "render.shader".
  static Result<std::unique_ptr<StillRenderer>> create();
  ~StillRenderer();

  /// Errors: those of check_scene; "render.no_context".
  Result<std::unique_ptr<StagedScene>> stage(const Scene& scene);
  /// A single picture. Errors: those of stage() and StagedScene.
  Result<Image> render(const Scene& scene, View view, const StillSettings& settings = {});
  Result<Image> render(const Scene& scene, const Camera& camera, const StillSettings& settings = {});

 private:
  friend class StagedScene;
  struct Parts;
  explicit StillRenderer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// A renderer that is made when the first picture is asked for. Belongs to one thread, which also ends it.
class Stills {
 public:
  /// Errors: as above.
  Result<std::unique_ptr<StagedScene>> stage(const Scene& scene);
  Result<Image> render(const Scene& scene, View view, const StillSettings& settings = {});
  Result<Image> render(const Scene& scene, const Camera& camera, const StillSettings& settings = {});

 private:
  Status make_renderer();
  std::unique_ptr<StillRenderer> renderer_;
};

}  // namespace toile::render
