#pragma once
// The figures of a fabric that nobody measured, from those that were: mass, drape coefficient, bending
// lengths, and what FAST or KES-F give. What was measured is taken as it is; what is missing and felt by the
// drape is found by draping (core/trials/cusick.h).

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/material/fabric.h"

namespace toile::trials {

/// What a laboratory has measured. A figure may come from one instrument only.
struct Measured {
  double areal_mass = 0;                                 ///< kg/m²
  std::optional<double> drape;                           ///< coefficient, 0 to 1
  std::optional<double> length_warp, length_weft;        ///< m, bending lengths (ASTM D1388, FAST-2)
  std::optional<double> kes_bend_warp, kes_bend_weft;    ///< gf·cm²/cm, B of KES-FB2
  std::optional<double> fast_e100_warp, fast_e100_weft;  ///< %, extension under 98.1 N/m (FAST-3)
  std::optional<double> fast_eb5;                        ///< %, extension on the bias under 4.9 N/m (FAST-3)
  std::optional<double> kes_emt_warp, kes_emt_weft;      ///< %, extension under 490 N/m (KES-FB1)
  std::optional<double> kes_shear;                       ///< gf/(cm·degree), G of KES-FB1
  std::optional<double> thickness;                       ///< m
};

/// Units of the instruments in the solver's. FAST: SiroFAST, CSIRO 1989; KES-F: S. Kawabata 1980.
double rigidity_of_length(double length, double areal_mass);  ///< N·m of a bending length (m): w·c³
double rigidity_of_kes(double b);                             ///< N·m of gf·cm²/cm
double shear_of_fast(double eb5);  ///< N/m per radian of the bias extension in %: 123 / EB5
double shear_of_kes(double g);     ///< N/m per radian of gf/(cm·degree)

/// A family of figures that can be missing together.
enum class Unknown { kBending, kShear, kStretch };

/// Takes what was measured; what is missing is that of an ordinary woven cloth of this mass. Errors:
/// calibrate.mass, calibrate.figure (out of range, or told twice), `where` naming it.
Result<material::Fabric> fabric_from(const Measured& measured);
/// What no figure tells.
std::vector<Unknown> missing(const Measured& measured);

/// The mean drape coefficient of a fabric, by `drapes` of the six drapes of the standard.
using DrapeTest = std::function<Result<double>(const material::Fabric& fabric)>;

struct Calibration {
  material::Fabric fabric;
  std::optional<Unknown> fitted;  ///< what the drape coefficient was used for; nothing where none was missing
  double drape = 0;               ///< of the fabric as it came out
  double off = 0;                 ///< its difference from the measured one; 0 where that was not
  bool within = false;            ///< by no more than a point; true where none was measured
  int tests = 0;                  ///< how often DrapeTest was asked
  /// What could not be told apart, in sentences.
  std::vector<std::string> open;
};

inline constexpr double kPoint = 0.01;

/// At most `most_tests` tests (3 at least). Error: those of fabric_from and of the test.
Result<Calibration> calibrate(const Measured& measured, const DrapeTest& test, int most_tests);

/// A test by the first `drapes` of the six drapes, of triangles that fit the fabric where `particle_distance`
/// (m) is 0.
DrapeTest cusick_test(int drapes, double particle_distance, const RunContext& context);

}  // namespace toile::trials
