#include "server/render/camera.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/units.h"

namespace toile::render {
namespace {

constexpr double kHalfHeight = 0.19;  // tangent of half the field of view: a long lens, little distortion
constexpr double kElevation = 0.10;   // radians above the horizon: hems and shoulders both open up a little
constexpr double kLyingElevation = 0.60;  // the same for what lies flat
constexpr double kGarmentMargin = 0.25;   // free share of the picture, of the garment's extent
constexpr double kBodyMargin = 0.10;
constexpr double kNearest = 0.01, kFarthestEye = 100;  // m that an own camera stands off
constexpr double kUpright = 0.9995;       // cosine to the upright at which it looks straight down
constexpr double kWholeBodyWithin = 1.4;  // show all of the body when it costs no more than this in scale

struct NamedView {
  View view;
  std::string_view word;
  double azimuth;  // degrees from the front to the body's left
};
constexpr std::array kViews{NamedView{View::kFront, "front", 0},
                            NamedView{View::kBack, "back", 180},
                            NamedView{View::kSide, "side", 90},
                            NamedView{View::kRight, "right", 270},
                            NamedView{View::kThreeQuarter, "three-quarter", 35},
                            NamedView{View::kBackQuarter, "back-quarter", 215}};

double azimuth_of(View view) {
  const auto found = std::find_if(kViews.begin(), kViews.end(),
                                  [view](const NamedView& named) { return named.view == view; });
  return radians_from_degrees(found->azimuth);
}

/// The near and far ends of what is drawn.
void set_depths(Camera& camera, const std::vector<Vec3>& points) {
  Aabb3 box;
  for (const Vec3& p : points)
    box.add(Vec3{dot(p - camera.eye, camera.right), dot(p - camera.eye, camera.up),
                 dot(p - camera.eye, camera.back)});
  camera.near = std::max(0.02, -box.high.z * 0.5);
  camera.far = std::max(-box.low.z * 4, camera.near + 10);  // leaves room for the ground behind
}

std::vector<Vec3> used_points(std::span<const Vec3> positions, std::span<const Tri> triangles) {
  std::vector<Vec3> points;
  points.reserve(triangles.size() * 3);
  for (const Tri& t : triangles) {
    for (const Index corner : t) points.push_back(positions[corner]);
  }
  return points;
}

/// Camera axes' coordinates of a point.
Vec3 turned(const Camera& c, Vec3 p) { return {dot(p, c.right), dot(p, c.up), dot(p, c.back)}; }

/// Puts the eye where all points lie inside the picture shrunk by 1 + margin; returns the distance to their
/// middle.
double fit(Camera& camera, const std::vector<Vec3>& points, double margin) {
  Aabb3 box;
  for (const Vec3& p : points) box.add(turned(camera, p));
  const Vec3 middle = box.middle();
  const double tangent_y = camera.half_height / (1 + margin), tangent_x = tangent_y * camera.aspect;
  double distance = 0.2;
  for (const Vec3& p : points) {
    const Vec3 q = turned(camera, p) - middle;
    distance = std::max({distance, q.z + std::abs(q.x) / tangent_x, q.z + std::abs(q.y) / tangent_y});
  }
  const Vec3 eye = {middle.x, middle.y, middle.z + distance};
  camera.eye = camera.right * eye.x + camera.up * eye.y + camera.back * eye.z;
  return distance;
}

/// Radians above the horizon: what is broader than high is seen more from above.
double elevation_for(const Scene& scene) {
  Aabb3 box = cloth_box(scene);
  if (box.empty()) box = whole_box(scene);
  if (box.empty()) return kElevation;
  const Vec3 size = box.size();
  const double upright = size.y / std::max({size.x, size.z, 1e-9});
  return kElevation + (kLyingElevation - kElevation) * std::clamp(1 - 2 * upright, 0.0, 1.0);
}

}  // namespace

std::vector<std::string> view_words() {
  std::vector<std::string> words;
  words.reserve(kViews.size());
  for (const NamedView& named : kViews) words.emplace_back(named.word);
  return words;
}

std::string_view word_of(View view) {
  return std::find_if(kViews.begin(), kViews.end(),
                      [view](const NamedView& named) { return named.view == view; })
      ->word;
}

Result<View> view_from(std::string_view word) {
  for (const NamedView& named : kViews)
    if (named.word == word) return named.view;
  return Error{"render.view", "a view is one of front, back, side, right, three-quarter, back-quarter",
               "view"};
}

Vec3 Camera::project(Vec3 p, int width, int height) const {
  const Vec3 q = turned(*this, p - eye);
  const double depth = -q.z;
  const double x = q.x / (depth * half_height * aspect), y = q.y / (depth * half_height);
  return {(x + 1) * 0.5 * width, (1 - y) * 0.5 * height, depth};
}

Matrix4 Camera::matrix() const {
  const double sx = 1 / (half_height * aspect), sy = 1 / half_height;
  const double a = (far + near) / (near - far), b = 2 * far * near / (near - far);
  const auto f = [](double v) { return static_cast<float>(v); };
  const Vec3 t = -turned(*this, eye);
  return {f(right.x * sx), f(up.x * sy), f(back.x * a),   f(-back.x),   f(right.y * sx), f(up.y * sy),
          f(back.y * a),   f(-back.y),   f(right.z * sx), f(up.z * sy), f(back.z * a),   f(-back.z),
          f(t.x * sx),     f(t.y * sy),  f(t.z * a + b),  f(-t.z)};
}

Camera frame_scene(const Scene& scene, View view, double aspect) {
  Camera camera;
  camera.half_height = kHalfHeight;
  camera.aspect = aspect;
  const double azimuth = azimuth_of(view);
  const double elevation = elevation_for(scene);
  const double c = std::cos(elevation), s = std::sin(elevation);
  camera.right = {std::cos(azimuth), 0, -std::sin(azimuth)};
  camera.back = {std::sin(azimuth) * c, s, std::cos(azimuth) * c};
  camera.up = cross(camera.back, camera.right);

  std::vector<Vec3> garment = used_points(scene.cloth.positions, scene.cloth.triangles);
  std::vector<Vec3> all = garment;
  for (const BodyView& body : scene.bodies) {
    const std::vector<Vec3> points = used_points(body.mesh->vertices, body.mesh->triangles);
    all.insert(all.end(), points.begin(), points.end());
  }
  if (all.empty()) all = {{-0.5, 0, -0.5}, {0.5, 0, 0.5}, {0, 1, 0}};

  Camera wide = camera;
  const double distance = fit(wide, all, kBodyMargin);
  if (!garment.empty()) {
    const double close = fit(camera, garment, kGarmentMargin);
    if (distance < close) fit(wide, all, kGarmentMargin);  // nothing but garment, or nearly so
    if (distance > close * kWholeBodyWithin) wide = camera;
  }
  set_depths(wide, all);
  return wide;
}

Status check_viewpoint(const Viewpoint& from) {
  const double off = from.target ? length(from.eye - *from.target) : kNearest;
  if (!is_finite(from.eye) || (from.target && !is_finite(*from.target)) ||
      !(off >= kNearest && off <= kFarthestEye))
    return Error{"render.camera", "a camera stands 1 cm to 100 m off what it looks at", "eye"};
  if (!(from.angle >= 1 && from.angle <= 120))
    return Error{"render.camera", "a camera sees 1 to 120 degrees", "angle"};
  return {};
}

Result<Camera> camera_at(const Scene& scene, const Viewpoint& from, double aspect) {
  const Aabb3 cloth = cloth_box(scene), all = whole_box(scene);
  const Aabb3& box = cloth.empty() ? all : cloth;
  const Vec3 target = from.target.value_or(box.empty() ? Vec3{} : box.middle());
  TRY(check_viewpoint({from.eye, target, from.angle}));
  const Vec3 back = from.eye - target;
  Camera camera;
  camera.half_height = std::tan(radians_from_degrees(from.angle) / 2);
  camera.aspect = aspect;
  camera.eye = from.eye;
  camera.back = normalized(back);
  const Vec3 upright = std::abs(camera.back.y) < kUpright ? Vec3{0, 1, 0} : Vec3{0, 0, -1};
  camera.right = normalized(cross(upright, camera.back));
  camera.up = cross(camera.back, camera.right);
  std::vector<Vec3> corners{target};
  for (const Vec3& p : {all.low, all.high})
    if (!all.empty()) corners.push_back(p);
  set_depths(camera, corners);
  camera.near = std::min(camera.near, length(back) * 0.5);
  return camera;
}

Matrix4 parallel_matrix(const Aabb3& box, Vec3 direction) {
  const Vec3 back = normalized(-direction);
  const Vec3 helper = std::abs(back.y) < 0.95 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 right = normalized(cross(helper, back)), up = cross(back, right);
  const Vec3 middle = box.middle();
  const double r = 1 / std::max(length(box.size()) * 0.5, 1e-3);
  const auto f = [](double v) { return static_cast<float>(v); };
  return {f(right.x * r),
          f(up.x * r),
          f(-back.x * r),
          0,
          f(right.y * r),
          f(up.y * r),
          f(-back.y * r),
          0,
          f(right.z * r),
          f(up.z * r),
          f(-back.z * r),
          0,
          f(-dot(right, middle) * r),
          f(-dot(up, middle) * r),
          f(dot(back, middle) * r),
          1};
}

}  // namespace toile::render
