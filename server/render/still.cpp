#include "server/render/still.h"

#include <algorithm>
#include <utility>

#include "server/render/picture_texture.h"
#include "server/render/shot.h"
#include "server/render/stage.h"

namespace toile::render {
namespace {

/// Rows turned to start at the top, blocks of factor² pixels averaged.
class Reduction {
 public:
  Reduction(const std::vector<std::uint8_t>& rgba, int width, int height, int factor)
      : rgba_(rgba), width_(width), height_(height), factor_(factor) {}

  Image opaque() const {
    Image image = empty();
    for (std::size_t i = 0; i < 3 * pixels(); ++i) image.rgb[i] = rounded(sum(i / 3, i % 3), samples());
    return image;
  }

  /// The colours were multiplied by their opacity, which this takes back.
  Image with_opacity() const {
    Image image = empty();
    for (std::size_t i = 0; i < pixels(); ++i) {
      const int covered = sum(i, 3);
      image.opacity.push_back(rounded(covered, samples()));
      for (std::size_t channel = 0; channel < 3 && covered > 0; ++channel)
        image.rgb[3 * i + channel] = rounded(std::min(255 * sum(i, channel), 255 * covered), covered);
    }
    return image;
  }

 private:
  Image empty() const { return {width_, height_, std::vector<std::uint8_t>(3 * pixels()), {}}; }
  std::size_t pixels() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }
  int samples() const { return factor_ * factor_; }
  static std::uint8_t rounded(int sum, int count) {
    return static_cast<std::uint8_t>((sum + count / 2) / count);
  }

  int sum(std::size_t pixel, std::size_t channel) const {
    const int x = static_cast<int>(pixel % static_cast<std::size_t>(width_)) * factor_;
    const int y = (height_ - 1 - static_cast<int>(pixel / static_cast<std::size_t>(width_))) * factor_;
    int sum = 0;
    for (int i = 0; i < samples(); ++i) {
      const auto row = static_cast<std::size_t>(y + i / factor_) * static_cast<std::size_t>(width_ * factor_);
      sum += rgba_[4 * (row + static_cast<std::size_t>(x + i % factor_)) + channel];
    }
    return sum;
  }

  const std::vector<std::uint8_t>& rgba_;
  int width_, height_, factor_;
};

}  // namespace

Status check_settings(const StillSettings& s) {
  if (s.width < 16 || s.height < 16 || s.width > 4096 || s.height > 4096) {
    return Error{"render.settings", "width and height of a still must be 16 to 4096 pixels", "size"};
  }
  if (s.samples != 1 && s.samples != 4 && s.samples != 16) {
    return Error{"render.settings", "a still takes 1, 4 or 16 samples per pixel", "samples"};
  }
  return {};
}

struct StillRenderer::Parts {
  std::unique_ptr<GlContext> context;  // declared first: outlives the programs made in it
  Programs programs;
  int most_samples = 1;           // per pixel, that OpenGL draws itself
  std::unique_ptr<GlScope> kept;  // the programs' textures
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
  auto kept = std::make_unique<GlScope>(gl);
  for (int i = 0; i < kStructures; ++i)
    programs.weaves.push_back(upload_weave(*kept, static_cast<Structure>(i)));
  auto parts = std::make_unique<Parts>(Parts{std::move(context), std::move(programs), most, std::move(kept)});
  return std::unique_ptr<StillRenderer>(new StillRenderer(std::move(parts)));
}

struct StagedScene::Parts {
  StillRenderer::Parts& renderer;
  const Scene& scene;
  Stage stage;
};

StagedScene::StagedScene(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

StagedScene::~StagedScene() {
  // What is on the stage is deleted in the current context, which another renderer may have replaced.
  static_cast<void>(parts_->renderer.context->make_current().ok());
}

Result<Image> StagedScene::picture(View view, const StillSettings& settings) const {
  TRY(check_settings(settings));
  const double aspect = static_cast<double>(settings.width) / settings.height;
  return picture(frame_scene(parts_->scene, view, aspect), settings);
}

Result<Image> StagedScene::picture(const Camera& camera, const StillSettings& settings) const {
  TRY(check_settings(settings));
  StillRenderer::Parts& renderer = parts_->renderer;
  TRY(renderer.context->make_current());
  // Four samples more than OpenGL has are two by two pixels each.
  const int factor = settings.samples > renderer.most_samples ? 2 : 1;
  const int samples = std::clamp(settings.samples / (factor * factor), 1, renderer.most_samples);
  Shot shot(renderer.context->gl(), renderer.programs, parts_->stage, camera);
  const auto rgba =
      TRY(shot.take(settings.width * factor, settings.height * factor, samples, settings.transparent));
  const Reduction reduction(rgba, settings.width, settings.height, factor);
  return settings.transparent ? reduction.with_opacity() : reduction.opaque();
}

Result<std::unique_ptr<StagedScene>> StillRenderer::stage(const Scene& scene) {
  TRY(check_scene(scene));
  TRY(parts_->context->make_current());
  return std::unique_ptr<StagedScene>(new StagedScene(std::unique_ptr<StagedScene::Parts>(
      new StagedScene::Parts{*parts_, scene, Stage(parts_->context->gl(), parts_->programs, scene)})));
}

Result<Image> StillRenderer::render(const Scene& scene, View view, const StillSettings& settings) {
  TRY(check_settings(settings));
  const std::unique_ptr<StagedScene> staged = TRY(stage(scene));
  return staged->picture(view, settings);
}

Result<Image> StillRenderer::render(const Scene& scene, const Camera& camera, const StillSettings& settings) {
  TRY(check_settings(settings));
  const std::unique_ptr<StagedScene> staged = TRY(stage(scene));
  return staged->picture(camera, settings);
}

Status Stills::make_renderer() {
  if (renderer_ != nullptr) return {};
  std::unique_ptr<StillRenderer> made = TRY(StillRenderer::create());
  renderer_ = std::move(made);
  return {};
}

Result<std::unique_ptr<StagedScene>> Stills::stage(const Scene& scene) {
  TRY(make_renderer());
  return renderer_->stage(scene);
}

Result<Image> Stills::render(const Scene& scene, View view, const StillSettings& settings) {
  TRY(make_renderer());
  return renderer_->render(scene, view, settings);
}

Result<Image> Stills::render(const Scene& scene, const Camera& camera, const StillSettings& settings) {
  TRY(make_renderer());
  return renderer_->render(scene, camera, settings);
}

}  // namespace toile::render
