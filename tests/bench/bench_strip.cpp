// bench_strip [--seconds 3] [--damping 8] [--rate 3000]
// How far taut cloth stretches at the default step: strips of 45 by 300 mm and 0.2 kg/m² that hang and carry
// ten times their weight, for stiffnesses from 100 to 5000 N/m on triangles of 10, 15 and 20 mm. Prints
// strain over load / stiffness (1 is right) after so many seconds, and from when on it stays within 5 %.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/core/solver/strip.h"

namespace {

using namespace toile;

constexpr double kHeight = 0.3, kLow = 0.08, kHigh = 0.22, kHeavy = 98.1;  // m, m, m, m/s²

struct Hung {
  test::Strip strip;
  solver::ClothSolver solver;
  double weight, stiffness;  ///< N/m², N/m where it may narrow
};

material::Fabric fabric_of(double k) {
  material::Fabric fabric;
  fabric.areal_mass = 0.2;
  fabric.stretch_warp = fabric.stretch_weft = k;
  fabric.stretch_coupling = 0.3 * k;
  fabric.stretch_shear = 0.35 * k;
  return fabric;
}

Hung hang(double k, double edge, double rate) {
  const material::Fabric fabric = fabric_of(k);
  test::Strip strip = test::make_strip({0, 45}, 1e3 * kHeight, edge, {0, 1}, fabric);
  std::vector<Vec3> x;
  std::vector<solver::constraints::HeldVertex> held;
  for (const Vec2& p : strip.rest) {
    x.push_back({p.x, p.y - kHeight, 0});
    if (p.y > kHeight - 1e-4) held.push_back({static_cast<Index>(x.size()) - 1, false, x.back()});
  }
  solver::ClothSolver solver(strip.model, std::move(x), {}, 1 / rate);
  solver.set_holds(std::move(held));
  return {std::move(strip), std::move(solver), fabric.areal_mass * kHeavy, k * (1 - 0.3 * 0.3)};
}

/// Mean strain between two heights over what the load there asks for: slope of the displacement, less the
/// parabola of a load that grows upwards, by least squares.
double strain_over_load(const Hung& hung) {
  double s0 = 0, s1 = 0, s2 = 0, t0 = 0, t1 = 0;
  for (std::size_t i = 0; i < hung.strip.rest.size(); ++i) {
    const double p = hung.strip.rest[i].y;
    if (p < kLow || p > kHigh) continue;
    const double q = p - (kLow + kHigh) / 2;
    const double u = hung.solver.positions()[i].y - (p - kHeight) - hung.weight / hung.stiffness * q * q / 2;
    s0 += 1;
    s1 += q;
    s2 += q * q;
    t0 += u;
    t1 += q * u;
  }
  const double slope = (s0 * t1 - s1 * t0) / (s0 * s2 - s1 * s1);
  return slope / (hung.weight * (kLow + kHigh) / 2 / hung.stiffness);
}

}  // namespace

int main(int count, char** words) {
  double seconds = 3, damping = 8, rate = 3000;
  for (int i = 1; i + 1 < count; i += 2) {
    double* of = std::strcmp(words[i], "--seconds") == 0   ? &seconds
                 : std::strcmp(words[i], "--damping") == 0 ? &damping
                                                           : &rate;
    *of = std::atof(words[i + 1]);
  }
  std::printf("stiffness_N_m,edge_mm,strain_over_load,within_5_percent_from_s\n");
  for (const double edge : {0.01, 0.015, 0.02}) {
    for (const double k : {100.0, 500.0, 2000.0, 5000.0}) {
      Hung hung = hang(k, edge, rate);
      solver::StepForces forces;
      forces.gravity = kHeavy;
      forces.damping = damping;
      double right_from = 0;
      const int steps = static_cast<int>(std::lround(seconds * rate));
      for (int s = 1; s <= steps; ++s) {
        hung.solver.step(forces);
        if (s % 100 == 0 && std::abs(strain_over_load(hung) - 1) > 0.05) right_from = s / rate;
      }
      std::printf("%.0f,%.0f,%.3f,%.2f\n", k, 1e3 * edge, strain_over_load(hung), right_from);
      std::fflush(stdout);
    }
  }
}
