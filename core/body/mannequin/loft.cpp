#include "core/body/mannequin/loft.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace toile::mannequin {
namespace {

constexpr double kTableStep = 6e-4;  // of the stature, about 1 mm
constexpr double kLeast = 1e-9;      // keeps ratios finite on the axis itself
// The field is divided by its own slope to be nearly a distance; within these, so that a sharp rim does not
// blow it up.
constexpr double kLeastSlope = 0.6, kGreatestSlope = 6;

using Column = double LoftSection::*;
constexpr Column kColumns[] = {&LoftSection::u,          &LoftSection::v,    &LoftSection::half,
                               &LoftSection::front,      &LoftSection::back, &LoftSection::square_front,
                               &LoftSection::square_back};

// Slope at row i that keeps the cubic monotone (M. Steffen, "A simple method for monotonic interpolation in
// one dimension", Astronomy and Astrophysics 239, 1990).
double monotone_slope(std::span<const LoftSection> rows, size_t i, Column c) {
  if (i == 0 || i + 1 == rows.size()) {
    const size_t a = i == 0 ? 0 : i - 1;
    return (rows[a + 1].*c - rows[a].*c) / (rows[a + 1].t - rows[a].t);
  }
  const double h0 = rows[i].t - rows[i - 1].t, h1 = rows[i + 1].t - rows[i].t;
  const double s0 = (rows[i].*c - rows[i - 1].*c) / h0, s1 = (rows[i + 1].*c - rows[i].*c) / h1;
  // A row that is greatest or least of its neighbours stays so: no bulge that nobody drew.
  if (s0 * s1 <= 0) return 0;
  const double p = (s0 * h1 + s1 * h0) / (h0 + h1);
  const double limit = 2 * std::min(std::abs(s0), std::abs(s1));
  return std::abs(p) > limit ? (p < 0 ? -limit : limit) : p;
}

double hermite(double x, double h, double y0, double y1, double m0, double m1) {
  const double s = x / h, s2 = s * s, s3 = s2 * s;
  return y0 * (2 * s3 - 3 * s2 + 1) + m0 * h * (s3 - 2 * s2 + s) + y1 * (3 * s2 - 2 * s3) +
         m1 * h * (s3 - s2);
}

std::vector<LoftSection> interpolate(std::span<const LoftSection> rows, size_t count, double step) {
  std::vector<LoftSection> table(count);
  size_t row = 0;
  for (size_t i = 0; i < count; ++i) {
    const double t = rows.front().t + step * static_cast<double>(i);
    while (row + 2 < rows.size() && rows[row + 1].t < t) ++row;
    table[i].t = t;
    const double h = rows[row + 1].t - rows[row].t;
    for (Column c : kColumns) {
      table[i].*c = hermite(std::min(t - rows[row].t, h), h, rows[row].*c, rows[row + 1].*c,
                            monotone_slope(rows, row, c), monotone_slope(rows, row + 1, c));
    }
  }
  return table;
}

// Three box blurs are a Gaussian for our purpose, and need no exponential.
void blur(std::vector<LoftSection>& table, double deviation_in_steps) {
  const int w = static_cast<int>(std::sqrt(0.25 + deviation_in_steps * deviation_in_steps));
  const int n = static_cast<int>(table.size());
  if (w < 1) return;
  for (int round = 0; round < 3; ++round) {
    const std::vector<LoftSection> from = table;
    for (Column c : kColumns) {
      for (int i = 0; i < n; ++i) {
        double sum = 0;
        for (int j = i - w; j <= i + w; ++j) sum += from[std::clamp(j, 0, n - 1)].*c;
        table[i].*c = sum / (2 * w + 1);
      }
    }
  }
}

// Norm of (p, q) between L2 and L4, and its partial derivatives.
struct Norm {
  double g, by_p, by_q;
};

Norm mixed_norm(double p, double q, double squareness) {
  const double p2 = p * p, q2 = q * q;
  const double g2 = std::sqrt(p2 + q2 + kLeast * kLeast);
  if (squareness <= 0) return {g2, p / g2, q / g2};
  // L4 is a rounded square: backs and chests are flatter than an ellipse.
  const double g4 = std::sqrt(std::sqrt(p2 * p2 + q2 * q2) + kLeast * kLeast);
  const double a = (1 - squareness) / g2, b = squareness / (g4 * g4 * g4);
  return {(1 - squareness) * g2 + squareness * g4, p * (a + b * p2), q * (a + b * q2)};
}

}  // namespace

Loft::Loft(std::span<const LoftSection> rows, const LoftShape& shape)
    : start_(rows.front().t), end_(rows.back().t), shape_(shape) {
  TOILE_CHECK(rows.size() >= 2 && end_ > start_);
  const size_t count = static_cast<size_t>((end_ - start_) / kTableStep) + 2;
  step_ = (end_ - start_) / static_cast<double>(count - 1);
  table_ = interpolate(rows, count, step_);
  blur(table_, shape.smoothing / step_);
  for (const LoftSection& s : table_) {
    const double side = std::abs(s.u) + s.half, deep = std::abs(s.v) + std::max(s.front, s.back);
    reach_ = std::max(reach_, std::sqrt(side * side + deep * deep));
  }
}

LoftSection Loft::section(double t, LoftSection* slope) const {
  const double x = std::clamp((t - start_) / step_, 0.0, static_cast<double>(table_.size() - 1));
  const size_t i = std::min(static_cast<size_t>(x), table_.size() - 2);
  const double f = x - static_cast<double>(i);
  // Beyond the ends the last section goes on, and does not widen: caps close it.
  const bool outside = t < start_ || t > end_;
  LoftSection s;
  for (Column c : kColumns) {
    const double d = table_[i + 1].*c - table_[i].*c;
    s.*c = table_[i].*c + f * d;
    slope->*c = outside ? 0 : d / step_;
  }
  return s;
}

FieldSample Loft::at(Vec3 uvt) const {
  LoftSection d;
  const LoftSection s = section(uvt.z, &d);
  const double u = uvt.x - s.u, v = uvt.y - s.v;
  const bool front = v > 0;
  const double b = front ? s.front : s.back, db = front ? d.front : d.back;
  const double p = u / s.half, q = v / b;
  const Norm n = mixed_norm(p, q, front ? s.square_front : s.square_back);

  // Way into a cap; its slope is the sign of the end.
  double over = 0, sign = 0, cap = 1;
  if (uvt.z < start_ + shape_.cap_start) {
    over = start_ + shape_.cap_start - uvt.z;
    sign = -1;
    cap = shape_.cap_start;
  } else if (uvt.z > end_ - shape_.cap_end) {
    over = uvt.z - (end_ - shape_.cap_end);
    sign = 1;
    cap = shape_.cap_end;
  }
  const double tau = over / cap;
  const double k = std::sqrt(n.g * n.g + tau * tau + kLeast * kLeast);
  const double r = std::sqrt(u * u + v * v + over * over + kLeast * kLeast);

  const double g_u = n.by_p / s.half, g_v = n.by_q / b;
  const double g_t = -g_u * (d.u + p * d.half) - g_v * (d.v + q * db);
  const double f = r * (1 - 1 / k), by_r = (1 - 1 / k) / r, by_k = r / (k * k);
  const double k_g = n.g / k, k_t = tau / k * sign / cap;
  const Vec3 gradient{u * by_r + by_k * k_g * g_u, v * by_r + by_k * k_g * g_v,
                      (over * sign - u * d.u - v * d.v) * by_r + by_k * (k_g * g_t + k_t)};
  const double norm = std::clamp(length(gradient), kLeastSlope, kGreatestSlope);
  return {f / norm, gradient * (1 / norm)};
}

}  // namespace toile::mannequin
