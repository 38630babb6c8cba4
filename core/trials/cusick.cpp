#include "core/trials/cusick.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/units.h"
#include "core/drape/pipeline.h"
#include "core/trials/specimen.h"

namespace toile::trials {
namespace {

constexpr double kCell = 0.0005, kReach = 0.16;               // m
constexpr int kCells = static_cast<int>(2 * kReach / kCell);  // along a side

/// The disc as the head of a column, with its side so deep that cloth hangs clear of its foot.
body::Body disc_body() {
  constexpr int kSides = 120;
  constexpr double kLow = 0, kHigh = 0.25, kSkin = 0.2e-3;
  body::Body body;
  body.id = "disc";
  body.friction = 1;  // the standard clamps the piece between two discs
  body.skin_offset = kSkin;
  auto& x = body.mesh.vertices;
  auto& t = body.mesh.triangles;
  x = {{0, kLow, 0}, {0, kHigh, 0}};
  for (int i = 0; i < kSides; ++i) {
    const double a = 2 * kPi * i / kSides, r = kDiscRadius - kSkin;
    x.push_back({r * std::sin(a), kLow, r * std::cos(a)});
    x.push_back({r * std::sin(a), kHigh, r * std::cos(a)});
  }
  for (Index i = 0; i < kSides; ++i) {
    const Index a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % kSides);
    t.insert(t.end(), {{a, b, a + 1}, {b, b + 1, a + 1}, {0, b, a}, {1, a + 1, b + 1}});
  }
  return body;
}

drape::DrapeInput input_of(const material::Fabric& fabric, int number, double particle_distance) {
  constexpr double kTurns[] = {0, 20, 43}, kAbove = 0.252;  // degrees; m
  const double turn = radians_from_degrees(kTurns[number / 2 % 3]);
  drape::DrapeInput input;
  input.name = "Cusick drape";
  input.pattern.panels = {circle(mm_from_metres(kSpecimenRadius), {std::sin(turn), std::cos(turn)})};
  sewing::RigidPlacement flat;
  flat.translation = {0, kAbove + fabric.thickness, 0};
  flat.rotation = {-kPi / 2, 0, 0};
  flat.flipped = number % 2 == 1;
  input.placements = {flat};
  input.fabrics = {fabric};
  input.fabric_of_panel = {0};
  input.bodies = {disc_body()};
  input.settings.particle_distance = particle_distance;
  input.settings.max_time = 12;
  input.settings.ground = false;
  return input;
}

/// Cells over the ground, row by row, and which of them cloth hides.
class ShadowGrid {
 public:
  ShadowGrid() : dark_(static_cast<std::size_t>(kCells) * kCells, 0) {}

  void darken(Vec2 a, Vec2 b, Vec2 c) {
    if (cross(b - a, c - a) < 0) std::swap(b, c);
    const int x0 = cell_of(std::min({a.x, b.x, c.x})), x1 = cell_of(std::max({a.x, b.x, c.x}));
    const int y0 = cell_of(std::min({a.y, b.y, c.y})), y1 = cell_of(std::max({a.y, b.y, c.y}));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const Vec2 p{middle_of(x), middle_of(y)};
        if (cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0)
          dark_[at(x, y)] = 1;
      }
    }
  }

  /// m², with the disc's own shadow.
  double area() const {
    int cells = 0;
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x)
        cells += dark_[at(x, y)] || std::hypot(middle_of(x), middle_of(y)) < kDiscRadius;
    }
    return cells * kCell * kCell;
  }

  /// m from the middle to the farthest shadow that way, the disc's at least.
  double reach(double angle) const {
    for (double r = kReach - kCell; r > kDiscRadius; r -= kCell / 2) {
      if (dark_[at(cell_of(r * std::cos(angle)), cell_of(r * std::sin(angle)))]) return r;
    }
    return kDiscRadius;
  }

 private:
  static int cell_of(double m) {
    return std::clamp(static_cast<int>(std::floor((m + kReach) / kCell)), 0, kCells - 1);
  }
  static double middle_of(int cell) { return (cell + 0.5) * kCell - kReach; }
  static std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(x);
  }

  std::vector<char> dark_;
};

/// How often an outline, smoothed over 15°, swings out past its mean and in again by more than a millimetre.
int nodes_of(const std::vector<double>& outline) {
  constexpr int kHalf = 7;
  constexpr double kSwing = 0.001;  // m
  const int n = static_cast<int>(outline.size());
  const double mean = std::accumulate(outline.begin(), outline.end(), 0.0) / n;
  int nodes = 0, side = 0;
  for (int i = 0; i < 2 * n; ++i) {  // the first turn finds the side on which the second begins
    double sum = 0;
    for (int k = -kHalf; k <= kHalf; ++k) sum += outline[static_cast<std::size_t>((i + k + n) % n)];
    const double off = sum / (2 * kHalf + 1) - mean;
    if (off > kSwing && side != 1) {
      nodes += i >= n && side == -1;
      side = 1;
    }
    if (off < -kSwing) side = -1;
  }
  return nodes;
}

}  // namespace

Shadow shadow_of(std::span<const Vec3> positions, std::span<const Tri> triangles) {
  ShadowGrid grid;
  const auto above = [&](Index v) {
    const Vec3& p = positions[static_cast<std::size_t>(v)];
    return Vec2{p.x, p.z};
  };
  for (const Tri& t : triangles) grid.darken(above(t[0]), above(t[1]), above(t[2]));
  Shadow out;
  const double disc = kPi * kDiscRadius * kDiscRadius, whole = kPi * kSpecimenRadius * kSpecimenRadius;
  out.coefficient = (grid.area() - disc) / (whole - disc);
  for (int degree = 0; degree < 360; ++degree)
    out.outline.push_back(grid.reach(radians_from_degrees(degree)));
  out.nodes = nodes_of(out.outline);
  return out;
}

Result<CusickDrape> cusick_drape(const material::Fabric& fabric, int number, double particle_distance,
                                 const RunContext& context) {
  const drape::DrapeInput input = input_of(fabric, number, particle_distance);
  const drape::DrapeResult result = TRY(drape::drape(input, context, nullptr));
  if (context.cancelled()) return Error{"cancelled", "the trial was cancelled", "", ErrorKind::kCancelled};
  return CusickDrape{shadow_of(result.positions, result.garment.triangles), result.settled(),
                     static_cast<int>(result.positions.size()), result.cpu_s, result.worst};
}

}  // namespace toile::trials
