#include "server/movie/make_movie.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "server/render/png.h"
#include "server/render/still.h"

namespace toile::movie {
namespace {

constexpr double kMostOfDrape = 20;  // s that a drape's movie lasts unless it is told otherwise
constexpr double kTurn = 8;          // s that a turn takes
constexpr double kHold = 1;          // s that the end of a drape is shown
constexpr int kFramed = 12;          // moments, or directions, that the camera is set up for

int pictures(double seconds, int fps) { return std::max(1, static_cast<int>(std::lround(seconds * fps))); }

double last_time(const Film& film) { return film.motion.frames.back().time; }

/// Without the hold at the end.
double moving_seconds(const Film& film, const MovieSettings& settings) {
  if (settings.seconds) return std::max(0.0, *settings.seconds - kHold);
  return std::min(last_time(film), kMostOfDrape - kHold);
}

/// m, of each picture of a drape before it is held.
double time_of(const Film& film, const MovieSettings& settings, int picture) {
  const double share = picture / (moving_seconds(film, settings) * settings.fps);
  return share < 1 ? share * last_time(film) : last_time(film);
}

Vec3 turned_about(Vec3 p, Vec3 middle, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = p.x - middle.x, z = p.z - middle.z;
  return {middle.x + c * x + s * z, p.y, middle.z + c * z - s * x};
}

/// The cloth, and the bodies, at several moments or turned in several ways as one: what the camera must see.
struct Swept {
  std::vector<Vec3> cloth;
  std::vector<Tri> triangles;
  std::vector<geometry::TriangleMesh> bodies;

  void add_cloth(const std::vector<Vec3>& positions, const std::vector<Tri>& faces) {
    const auto first = static_cast<Index>(cloth.size());
    cloth.insert(cloth.end(), positions.begin(), positions.end());
    for (const Tri& t : faces) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  render::Scene scene() const {
    render::Scene scene;
    scene.cloth.positions = cloth;
    scene.cloth.triangles = triangles;
    for (const geometry::TriangleMesh& body : bodies) scene.bodies.push_back({.mesh = &body});
    return scene;
  }
};

Swept swept_by_drape(const Film& film) {
  Swept swept;
  swept.bodies = film.bodies;
  for (int i = 0; i <= kFramed; ++i) {
    const double time = last_time(film) * i / kFramed;
    swept.add_cloth(positions_at(film.motion, time), film.garment.triangles);
    if (film.ways.empty()) continue;
    for (geometry::TriangleMesh& body : bodies_at(film, played_at(film.motion, time)))
      swept.bodies.push_back(std::move(body));
  }
  return swept;
}

Swept swept_by_turn(const Film& film, Vec3 middle) {
  Swept swept;
  for (int i = 0; i < kFramed; ++i) {
    const double angle = 2 * kPi * i / kFramed;
    const auto turned = [&](std::vector<Vec3> points) {
      for (Vec3& p : points) p = turned_about(p, middle, angle);
      return points;
    };
    swept.add_cloth(turned(film.end), film.garment.triangles);
    for (const geometry::TriangleMesh& body : film.bodies)
      swept.bodies.push_back({turned(body.vertices), body.triangles});
  }
  return swept;
}

/// Where each picture is taken from, and of what.
class Shots {
 public:
  Shots(const Film& film, const MovieSettings& settings)
      : film_(film), settings_(settings), end_(scene_of(film, film.end)) {
    const Aabb3 box = render::cloth_box(end_);
    middle_ = box.empty() ? Vec3{} : box.middle();
    const bool turns = settings.kind == MovieKind::kTurntable;
    const Swept swept = turns ? swept_by_turn(film, middle_) : swept_by_drape(film);
    const render::Scene seen = swept.scene();
    floor_ = render::floor_height(seen);
    end_.floor = floor_;
    camera_ = render::frame_scene(seen, turns ? render::View::kFront : render::View::kThreeQuarter,
                                  static_cast<double>(settings.width) / settings.height);
  }

  Result<render::Image> take(render::StillRenderer& renderer, int picture) {
    const render::StillSettings settings{.width = settings_.width, .height = settings_.height};
    if (settings_.kind == MovieKind::kTurntable) {
      if (!staged_) staged_ = TRY(renderer.stage(end_));
      return staged_->picture(turned_camera(picture), settings);
    }
    const double time = time_of(film_, settings_, picture);
    const std::vector<Vec3> positions = positions_at(film_.motion, time);
    render::Scene scene = scene_of(film_, positions);
    std::vector<geometry::TriangleMesh> moving;  // as long as the scene
    if (!film_.ways.empty()) {
      moving = bodies_at(film_, played_at(film_.motion, time));
      scene.bodies.clear();
      for (const geometry::TriangleMesh& body : moving) scene.bodies.push_back({.mesh = &body});
    }
    scene.floor = floor_;
    return renderer.render(scene, camera_, settings);
  }

 private:
  /// Its lamps go with it: what stands before it turns.
  render::Camera turned_camera(int picture) const {
    const double angle = 2 * kPi * picture / frames_of(film_, settings_);
    render::Camera camera = camera_;
    camera.eye = turned_about(camera.eye, middle_, angle);
    for (Vec3* axis : {&camera.right, &camera.up, &camera.back}) *axis = turned_about(*axis, {}, angle);
    return camera;
  }

  const Film& film_;
  const MovieSettings& settings_;
  render::Scene end_;
  std::unique_ptr<render::StagedScene> staged_;  // the end, once it is asked for; its bodies do not move
  Vec3 middle_;
  double floor_ = 0;  // m; the lowest of all moments, so that the ground stays
  render::Camera camera_;
};

Status bad(const char* which, const std::string& what) {
  return Error{"movie.settings", std::string(which) + " " + what, which, ErrorKind::kInput};
}

Status write_still(const MovieSettings& settings, int picture, const render::Image& image) {
  if (settings.stills.empty() || picture % settings.stills_every != 0) return {};
  char name[32];
  std::snprintf(name, sizeof(name), "%05d.png", picture);
  return render::write_png(settings.stills / name, image);
}

}  // namespace

std::string_view word_of(MovieKind kind) { return kind == MovieKind::kDrape ? "drape" : "turntable"; }

Result<MovieKind> movie_kind_from(std::string_view word) {
  for (const MovieKind kind : {MovieKind::kDrape, MovieKind::kTurntable})
    if (word == word_of(kind)) return kind;
  return Error{"movie.kind", "a movie is one of a drape or a turntable: \"drape\", \"turntable\"", "kind"};
}

Result<VideoFormat> video_format_from(std::string_view word) {
  for (const VideoFormat format : {VideoFormat::kMp4, VideoFormat::kAvi})
    if (word == word_of(format)) return format;
  return Error{"movie.format", "a movie's format is \"mp4\" or \"avi\"", "format"};
}

Status check_settings(const MovieSettings& settings) {
  for (const auto& [name, side] :
       {std::pair{"width", settings.width}, std::pair{"height", settings.height}}) {
    if (side < kLeastSide || side > kMostSide || side % 2 != 0)
      return bad(name, "of a movie is an even number of pixels from 64 to 4096");
  }
  if (settings.fps < 1 || settings.fps > kMostFps) return bad("fps", "is a whole number from 1 to 60");
  if (settings.seconds && !(*settings.seconds > 0 && *settings.seconds <= kMostSeconds))
    return bad("seconds", "is above 0 and at most 120");
  if (settings.stills_every < 1) return bad("stills_every", "is at least 1");
  return {};
}

int frames_of(const Film& film, const MovieSettings& settings) {
  if (settings.kind == MovieKind::kTurntable) return pictures(settings.seconds.value_or(kTurn), settings.fps);
  return pictures(settings.seconds.value_or(moving_seconds(film, settings) + kHold), settings.fps);
}

Status make_movie(const Film& film, const MovieSettings& settings, const std::filesystem::path& path,
                  const RunContext& context) {
  TRY(check_settings(settings));
  if (settings.kind == MovieKind::kDrape && film.motion.frames.empty()) {
    return Error{"movie.no_motion", "no frames of this drape were kept; only a turntable can be made of it",
                 "", ErrorKind::kInput};
  }
  const int count = frames_of(film, settings);
  const std::unique_ptr<VideoFile> file =
      TRY(VideoFile::open(path, {settings.format, settings.width, settings.height, settings.fps, count}));
  const std::unique_ptr<render::StillRenderer> renderer = TRY(render::StillRenderer::create());
  Shots shots(film, settings);
  render::Image image;
  double shown = -1;
  for (int picture = 0; picture < count; ++picture) {
    context.progress("movie", static_cast<double>(picture) / count);
    if (context.cancelled())
      return Error{"cancelled", "the movie is not wanted any more", "", ErrorKind::kCancelled};
    const double moment = settings.kind == MovieKind::kTurntable ? picture : time_of(film, settings, picture);
    if (moment != shown) image = TRY(shots.take(*renderer, picture));
    shown = moment;
    TRY(write_still(settings, picture, image));
    TRY(file->add(image));
  }
  context.progress("movie", 1);
  return file->finish();
}

}  // namespace toile::movie
