#include "core/dressing/distance_field.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/distance.h"

namespace toile::dressing {

namespace {

constexpr int kMarginCells = 6;      // cells around the mesh
constexpr double kNear = 1.5;        // cells, within which distances are those to the triangles
constexpr int kThicknessPasses = 4;  // passes over the thickness
constexpr double kFar = 1e3;         // m
constexpr std::size_t kOwnAxis[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};  // along it, and the two across

double component(Vec3 p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Where the line along an axis through (u, v), in the two other axes, passes through a triangle: +1 into the
/// solid, -1 out of it, by the triangle's winding; 0 beside it.
int passage(const std::array<Vec3, 3>& t, std::size_t axis, double u, double v, double& height) {
  const auto [a, b, c] = std::array{axis, kOwnAxis[axis][1], kOwnAxis[axis][2]};
  std::array<Vec2, 3> q;
  for (std::size_t i = 0; i < 3; ++i) q[i] = {component(t[i], b) - u, component(t[i], c) - v};
  const double w0 = cross(q[1], q[2]), w1 = cross(q[2], q[0]), w2 = cross(q[0], q[1]);
  const double area = w0 + w1 + w2;
  if (area == 0 || (area > 0 ? std::min({w0, w1, w2}) < 0 : std::max({w0, w1, w2}) > 0)) return 0;
  height = (w0 * component(t[0], a) + w1 * component(t[1], a) + w2 * component(t[2], a)) / area;
  return area > 0 ? -1 : 1;
}

}  // namespace

DistanceField::DistanceField(const geometry::TriangleMesh& mesh, double cell) : cell_(cell) {
  for (const Vec3& p : mesh.vertices) box_.add(p);
  if (box_.empty()) box_.add(Vec3{});
  box_ = box_.grown(kMarginCells * cell_);
  const Vec3 size = box_.size();
  for (std::size_t k = 0; k < 3; ++k) size_[k] = static_cast<int>(std::ceil(component(size, k) / cell_)) + 1;
  const std::size_t count = at(size_[0] - 1, size_[1] - 1, size_[2] - 1) + 1;
  distance_.assign(count, static_cast<float>(kFar));
  measure_near(mesh);
  sweep();
  find_inside(mesh);
  find_thickness();
  smooth_thickness(kThicknessPasses);
}

/// Beside the surface: to the nearest triangle.
void DistanceField::measure_near(const geometry::TriangleMesh& mesh) {
  for (const Tri& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    Aabb3 box;
    for (const Vec3& p : {a, b, c}) box.add((p - box_.low) * (1 / cell_));
    const int low[3] = {static_cast<int>(box.low.x - kNear), static_cast<int>(box.low.y - kNear),
                        static_cast<int>(box.low.z - kNear)};
    const int high[3] = {static_cast<int>(box.high.x + kNear) + 1, static_cast<int>(box.high.y + kNear) + 1,
                         static_cast<int>(box.high.z + kNear) + 1};
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          const Vec3 p = place(i, j, k);
          const geometry::TrianglePoint w = geometry::closest_on_triangle(p, a, b, c);
          const double d = length(p - (a * w.a + b * w.b + c * w.c));
          if (d > kNear * cell_) continue;
          float& kept = distance_[at(i, j, k)];
          kept = std::min(kept, static_cast<float>(d));
        }
      }
    }
  }
}

/// Farther away: |∇d| = 1, solved by sweeping in eight directions (Zhao, "A fast sweeping method for Eikonal
/// equations", 2005).
void DistanceField::sweep() {
  const auto h = static_cast<float>(cell_);
  const auto solve = [&](int i, int j, int k) {
    float& d = distance_[at(i, j, k)];
    if (d <= static_cast<float>(kNear) * h) return;
    const auto along = [&](int di, int dj, int dk) {
      const int lo[3] = {i - di, j - dj, k - dk}, hi[3] = {i + di, j + dj, k + dk};
      float least = static_cast<float>(kFar);
      if (lo[0] >= 0 && lo[1] >= 0 && lo[2] >= 0) least = distance_[at(lo[0], lo[1], lo[2])];
      if (hi[0] < size_[0] && hi[1] < size_[1] && hi[2] < size_[2])
        least = std::min(least, distance_[at(hi[0], hi[1], hi[2])]);
      return least;
    };
    float a[3] = {along(1, 0, 0), along(0, 1, 0), along(0, 0, 1)};
    std::sort(a, a + 3);
    float x = a[0] + h;
    if (x > a[1]) {
      x = 0.5F * (a[0] + a[1] + std::sqrt(std::max(0.0F, 2 * h * h - (a[0] - a[1]) * (a[0] - a[1]))));
      if (x > a[2]) {
        const float sum = a[0] + a[1] + a[2];
        const float squares = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
        x = (sum + std::sqrt(std::max(0.0F, sum * sum - 3 * (squares - h * h)))) / 3;
      }
    }
    d = std::min(d, x);
  };
  for (int direction = 0; direction < 8; ++direction) {
    const auto nth = [&](int n, int axis) {
      return (direction >> axis & 1) != 0 ? size_[static_cast<std::size_t>(axis)] - 1 - n : n;
    };
    for (int k = 0; k < size_[2]; ++k)
      for (int j = 0; j < size_[1]; ++j)
        for (int i = 0; i < size_[0]; ++i) solve(nth(i, 0), nth(j, 1), nth(k, 2));
  }
}

void DistanceField::find_inside(const geometry::TriangleMesh& mesh) {
  std::vector<std::uint8_t> votes(distance_.size(), 0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t b = kOwnAxis[axis][1], c = kOwnAxis[axis][2];
    struct Passage {
      double height;
      int way;
    };
    std::vector<std::vector<Passage>> lines(static_cast<std::size_t>(size_[b]) *
                                            static_cast<std::size_t>(size_[c]));
    // A hair aside, so that no line runs along edges of a mesh that was made on round figures.
    const double aside_b = component(box_.low, b) + 1.234567e-5,
                 aside_c = component(box_.low, c) + 2.345678e-5;
    for (const Tri& t : mesh.triangles) {
      const std::array<Vec3, 3> corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
      double low[2] = {kFar, kFar}, high[2] = {-kFar, -kFar};
      for (const Vec3& p : corners) {
        const double q[2] = {(component(p, b) - aside_b) / cell_, (component(p, c) - aside_c) / cell_};
        for (int s = 0; s < 2; ++s) {
          low[s] = std::min(low[s], q[s]);
          high[s] = std::max(high[s], q[s]);
        }
      }
      for (int n = static_cast<int>(std::ceil(low[1])); n <= static_cast<int>(high[1]); ++n) {
        for (int m = static_cast<int>(std::ceil(low[0])); m <= static_cast<int>(high[0]); ++m) {
          double height = 0;
          const int way = passage(corners, axis, aside_b + m * cell_, aside_c + n * cell_, height);
          if (way == 0) continue;
          lines[static_cast<std::size_t>(n) * static_cast<std::size_t>(size_[b]) +
                static_cast<std::size_t>(m)]
              .push_back({height, way});
        }
      }
    }
    for (int n = 0; n < size_[c]; ++n) {
      for (int m = 0; m < size_[b]; ++m) {
        auto& line = lines[static_cast<std::size_t>(n) * static_cast<std::size_t>(size_[b]) +
                           static_cast<std::size_t>(m)];
        if (line.empty()) continue;
        std::sort(line.begin(), line.end(), [](const Passage& x, const Passage& y) {
          return x.height != y.height ? x.height < y.height : x.way < y.way;
        });
        std::size_t next = 0;
        int depth = 0;
        for (int a = 0; a < size_[axis]; ++a) {
          const double height = component(box_.low, axis) + a * cell_;
          while (next < line.size() && line[next].height < height) depth += line[next++].way;
          if (depth <= 0) continue;
          int ijk[3];
          ijk[axis] = a;
          ijk[b] = m;
          ijk[c] = n;
          ++votes[at(ijk[0], ijk[1], ijk[2])];
        }
      }
    }
  }
  for (std::size_t v = 0; v < votes.size(); ++v) {
    if (votes[v] >= 2) distance_[v] = -distance_[v];
  }
}

/// Every cell takes over the largest ball that holds it from its neighbours, deepest cells first.
void DistanceField::find_thickness() {
  half_thickness_.assign(distance_.size(), 0);
  std::vector<std::size_t> inside;
  for (std::size_t v = 0; v < distance_.size(); ++v) {
    if (distance_[v] < static_cast<float>(cell_)) inside.push_back(v);  // one layer outside as well
  }
  std::stable_sort(inside.begin(), inside.end(),
                   [&](std::size_t x, std::size_t y) { return distance_[x] < distance_[y]; });
  std::vector<std::size_t> ball(distance_.size(), 0);
  const auto nx = static_cast<std::size_t>(size_[0]), ny = static_cast<std::size_t>(size_[1]);
  const auto where = [&](std::size_t v) {
    return place(static_cast<int>(v % nx), static_cast<int>(v / nx % ny), static_cast<int>(v / (nx * ny)));
  };
  for (const std::size_t v : inside) {
    ball[v] = v;
    half_thickness_[v] = std::max(0.0F, -distance_[v]);
    const Vec3 p = where(v);
    for (int dk = -1; dk <= 1; ++dk) {
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
          const std::size_t w = v + static_cast<std::size_t>(di) +
                                nx * (static_cast<std::size_t>(dj) + ny * static_cast<std::size_t>(dk));
          if (half_thickness_[w] <= half_thickness_[v]) continue;
          if (length(where(ball[w]) - p) > half_thickness_[w] + 1.5 * cell_) continue;
          half_thickness_[v] = half_thickness_[w];
          ball[v] = ball[w];
        }
      }
    }
  }
}

/// Over the cells of the body only, so that limbs stay as thin as they are.
void DistanceField::smooth_thickness(int passes) {
  const auto nx = static_cast<std::ptrdiff_t>(size_[0]), ny = static_cast<std::ptrdiff_t>(size_[1]);
  const std::ptrdiff_t steps[6] = {1, -1, nx, -nx, nx * ny, -nx * ny};
  std::vector<std::size_t> body;
  for (std::size_t v = 0; v < half_thickness_.size(); ++v)
    if (half_thickness_[v] > 0) body.push_back(v);
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<float> next = half_thickness_;
    for (const std::size_t v : body) {
      float sum = half_thickness_[v];
      int count = 1;
      for (const std::ptrdiff_t step : steps) {
        const float t = half_thickness_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(v) + step)];
        if (t <= 0) continue;
        sum += t;
        ++count;
      }
      next[v] = sum / static_cast<float>(count);
    }
    half_thickness_ = std::move(next);
  }
}

double DistanceField::sample(const std::vector<float>& values, Vec3 p) const {
  const Vec3 q = (most_of(box_.low, least_of(box_.high, p)) - box_.low) * (1 / cell_);
  const int i = std::clamp(static_cast<int>(q.x), 0, size_[0] - 2);
  const int j = std::clamp(static_cast<int>(q.y), 0, size_[1] - 2);
  const int k = std::clamp(static_cast<int>(q.z), 0, size_[2] - 2);
  const double u = std::min(1.0, q.x - i), v = std::min(1.0, q.y - j), w = std::min(1.0, q.z - k);
  const auto row = [&](int jj, int kk) {
    const std::size_t at0 = at(i, jj, kk);
    return values[at0] * (1 - u) + values[at0 + 1] * u;
  };
  const auto layer = [&](int kk) { return row(j, kk) * (1 - v) + row(j + 1, kk) * v; };
  return layer(k) * (1 - w) + layer(k + 1) * w;
}

double DistanceField::beyond(Vec3 p) const { return length(p - most_of(box_.low, least_of(box_.high, p))); }

double DistanceField::distance(Vec3 p, double slim) const {
  const double d = distance(p);
  return slim > 0 && d < cell_ ? d + slim * half_thickness(p) : d;
}

Vec3 DistanceField::outwards(Vec3 p, double slim) const {
  const double e = 0.5 * cell_;
  const Vec3 g{distance(p + Vec3{e, 0, 0}, slim) - distance(p - Vec3{e, 0, 0}, slim),
               distance(p + Vec3{0, e, 0}, slim) - distance(p - Vec3{0, e, 0}, slim),
               distance(p + Vec3{0, 0, e}, slim) - distance(p - Vec3{0, 0, e}, slim)};
  return normalized(g);
}

}  // namespace toile::dressing
