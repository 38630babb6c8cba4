#include "core/pattern/garmentcode/turns.h"

#include <cmath>
#include <cstddef>

#include "core/base/units.h"

namespace toile::garmentcode {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// The rotation about axis k by `degrees`; right angles exactly.
Matrix rotation_about(std::size_t k, double degrees) {
  const double quarter = std::remainder(degrees, 360) / 90;
  double c = std::cos(quarter * (kPi / 2)), s = std::sin(quarter * (kPi / 2));
  if (quarter == std::round(quarter)) {
    c = std::round(c);
    s = std::round(s);
  }
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  Matrix m{};
  m[k][k] = 1;
  m[i][i] = c;
  m[i][j] = -s;
  m[j][i] = s;
  m[j][j] = c;
  return m;
}

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) m[i][j] += a[i][k] * b[k][j];
  return m;
}

}  // namespace

Vec3 fixed_angles(const std::array<double, 3>& own) {
  const Matrix r =
      times(times(rotation_about(0, own[0]), rotation_about(1, own[1])), rotation_about(2, own[2]));
  const double across = std::sqrt(r[0][0] * r[0][0] + r[1][0] * r[1][0]);
  const double y = std::atan2(-r[2][0], across);
  // Looking along ±x after the turn about y, turns about x and z are one: all of it is given to x.
  const bool locked = across < 1e-9;
  const double x = locked ? std::atan2(-r[1][2], r[1][1]) : std::atan2(r[2][1], r[2][2]);
  const double z = locked ? 0 : std::atan2(r[1][0], r[0][0]);
  return {degrees_from_radians(x), degrees_from_radians(y), degrees_from_radians(z)};
}

}  // namespace toile::garmentcode
