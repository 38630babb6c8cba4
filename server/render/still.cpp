#include "server/render/still.h"

#include <algorithm>
#include <utility>

#include "server/render/shot.h"

namespace toile::render {
namespace {

Status check_settings(const StillSettings& s) {
  if (s.width < 16 || s.height < 16 || s.width > 4096 || s.height > 4096) {
    return Error{"render.settings", "width and height of a still must be 16 to 4096 pixels", "",
                 ErrorKind::kInternal};
  }
  if (s.samples != 1 && s.samples != 4 && s.samples != 16) {
    return Error{"render.settings", "a still takes 1, 4 or 16 samples per pixel", "", ErrorKind::kInternal};
  }
  return {};
}

/// Rows turned to start at the top, blocks of factor² pixels averaged.
Image reduced(const std::vector<std::uint8_t>& rgba, int width, int height, int factor) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  const std::size_t row = static_cast<std::size_t>(width) * factor * 4;
  const int count = factor * factor;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        int sum = count / 2;
        for (int i = 0; i < count; ++i) {
          const std::size_t from_y = static_cast<std::size_t>(height - 1 - y) * factor + i / factor;
          const std::size_t from_x = static_cast<std::size_t>(x) * factor + i % factor;
          sum += rgba[from_y * row + from_x * 4 + channel];
        }
        image.rgb[(static_cast<std::size_t>(y) * width + x) * 3 + channel] =
            static_cast<std::uint8_t>(sum / count);
      }
    }
  }
  return image;
}

}  // namespace

struct StillRenderer::Parts {
  std::unique_ptr<GlContext> context;  // declared first: outlives the programs made in it
  Programs programs;
  int most_samples = 1;  // per pixel, that OpenGL draws itself
};

StillRenderer::StillRenderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

StillRenderer::~StillRenderer() {
  // Programs are deleted in the current context, which another renderer may have replaced.
  static_cast<void>(parts_->context->make_current().ok());
}

Result<std::unique_ptr<StillRenderer>> StillRenderer::create() {
  std::unique_ptr<GlContext> context = TRY(GlContext::create());
  const GlFunctions& gl = context->gl();
  Programs programs = TRY(Programs::link(gl));
  GLint most = 1;
  gl.GetIntegerv(GL_MAX_SAMPLES, &most);
  auto parts = std::make_unique<Parts>(Parts{std::move(context), std::move(programs), most});
  return std::unique_ptr<StillRenderer>(new StillRenderer(std::move(parts)));
}

Result<Image> StillRenderer::render(const Scene& scene, View view, const StillSettings& settings) {
  TRY(check_settings(settings));
  TRY(check_scene(scene));
  return render(scene, frame_scene(scene, view, static_cast<double>(settings.width) / settings.height),
                settings);
}

Result<Image> StillRenderer::render(const Scene& scene, const Camera& camera, const StillSettings& settings) {
  TRY(check_settings(settings));
  TRY(check_scene(scene));
  TRY(parts_->context->make_current());
  // Four samples more than OpenGL has are two by two pixels each.
  const int factor = settings.samples > parts_->most_samples ? 2 : 1;
  const int samples = std::clamp(settings.samples / (factor * factor), 1, parts_->most_samples);
  Shot shot(parts_->context->gl(), parts_->programs, scene, camera);
  const auto rgba = TRY(shot.take(settings.width * factor, settings.height * factor, samples));
  return reduced(rgba, settings.width, settings.height, factor);
}

Result<Image> render_still(const Scene& scene, View view, const StillSettings& settings) {
  thread_local std::unique_ptr<StillRenderer> kept;
  if (kept == nullptr) {
    std::unique_ptr<StillRenderer> made = TRY(StillRenderer::create());
    kept = std::move(made);
  }
  return kept->render(scene, view, settings);
}

}  // namespace toile::render
