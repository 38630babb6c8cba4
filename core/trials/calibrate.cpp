#include "core/trials/calibrate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/fabric/card.h"
#include "core/trials/cusick.h"

namespace toile::trials {
namespace {

constexpr double kEarthGravity = 9.81;    // m/s²
constexpr double kFastLoad = 98.1;        // N/m, 100 gf/cm
constexpr double kKesLoad = 490;          // N/m, 500 gf/cm
constexpr double kOrdinaryLength = 0.02;  // m, bending length where nothing is known
constexpr double kOrdinaryStretch = 1200, kOrdinaryShear = 60, kOrdinaryBias = 0.75;  // N/m; N/m; share
/// Factors beyond which no apparel fabric lies from an ordinary one.
constexpr double kMostFactor = 30;

struct Figure {
  const char* name;
  std::optional<double> value;
  double least, most;
};

std::array<Figure, 13> figures_of(const Measured& m) {
  return {{{"mass", m.areal_mass, 0.005, 3},
           {"drape", m.drape, 0.02, 0.99},
           {"warp-length", m.length_warp, 1e-3, 0.2},
           {"weft-length", m.length_weft, 1e-3, 0.2},
           {"kes-b-warp", m.kes_bend_warp, 1e-4, 10},
           {"kes-b-weft", m.kes_bend_weft, 1e-4, 10},
           {"fast-e100-warp", m.fast_e100_warp, 0.05, 200},
           {"fast-e100-weft", m.fast_e100_weft, 0.05, 200},
           {"fast-eb5", m.fast_eb5, 0.1, 100},
           {"kes-emt-warp", m.kes_emt_warp, 0.1, 300},
           {"kes-emt-weft", m.kes_emt_weft, 0.1, 300},
           {"kes-g", m.kes_shear, 0.01, 20},
           {"thickness", m.thickness, 2e-5, 0.02}}};
}

Status in_range(const Measured& measured) {
  for (const Figure& f : figures_of(measured)) {
    if (!f.value || (*f.value >= f.least && *f.value <= f.most)) continue;
    return Error{"calibrate.figure",
                 number_text(*f.value) + " is not between " + number_text(f.least) + " and " +
                     number_text(f.most) + "; look at its unit",
                 f.name};
  }
  const auto twice = [](const std::optional<double>& a, const std::optional<double>& b) { return a && b; };
  if (twice(measured.length_warp, measured.kes_bend_warp) ||
      twice(measured.length_weft, measured.kes_bend_weft))
    return Error{"calibrate.figure", "bending is told twice: as a length and by KES-F",
                 "kes-b-warp, kes-b-weft"};
  if (twice(measured.fast_eb5, measured.kes_shear))
    return Error{"calibrate.figure", "shear is told twice: by FAST and by KES-F", "fast-eb5, kes-g"};
  if (twice(measured.fast_e100_warp, measured.kes_emt_warp) ||
      twice(measured.fast_e100_weft, measured.kes_emt_weft))
    return Error{"calibrate.figure", "stretch is told twice: by FAST and by KES-F", "fast-e100-*, kes-emt-*"};
  return {};
}

std::optional<double> rigidity(const std::optional<double>& length, const std::optional<double>& kes,
                               double areal_mass) {
  if (length) return rigidity_of_length(*length, areal_mass);
  if (kes) return rigidity_of_kes(*kes);
  return std::nullopt;
}

std::optional<double> stiffness(const std::optional<double>& fast, const std::optional<double>& kes) {
  if (fast) return kFastLoad / (*fast / 100);
  if (kes) return kKesLoad / (*kes / 100);
  return std::nullopt;
}

/// Both, where one is known as large as the other; `ordinary` where neither is.
void set_pair(const std::optional<double>& warp, const std::optional<double>& weft, double ordinary,
              double& out_warp, double& out_weft) {
  out_warp = warp.value_or(weft.value_or(ordinary));
  out_weft = weft.value_or(warp.value_or(ordinary));
}

void scale(material::Fabric& fabric, Unknown what, double factor) {
  if (what == Unknown::kBending) {
    fabric.bend_warp *= factor;
    fabric.bend_weft *= factor;
    fabric.bend_bias *= factor;
  } else if (what == Unknown::kShear) {
    fabric.stretch_shear *= factor;
  } else {
    fabric.stretch_warp *= factor;
    fabric.stretch_weft *= factor;
    fabric.stretch_coupling *= factor;
  }
}

material::Fabric scaled(material::Fabric fabric, Unknown what, double factor) {
  scale(fabric, what, factor);
  return fabric;
}

const char* name_of(Unknown what) {
  constexpr std::array<const char*, 3> kNames{"bending", "shear", "stretch"};
  return kNames.at(static_cast<std::size_t>(what));
}

bool has(const std::vector<Unknown>& list, Unknown what) {
  return std::find(list.begin(), list.end(), what) != list.end();
}

/// A factor that was tried, on a logarithmic scale, and how far its drape is off.
struct Try {
  double log_factor = 0, drape = 0;
};

/// Looks for the factor whose drape is the measured one: it grows with the factor but for the chance in which
/// folds it falls.
class FactorSearch {
 public:
  FactorSearch(const material::Fabric& fabric, Unknown what, double wanted, const DrapeTest& test, int most)
      : fabric_(fabric), what_(what), wanted_(wanted), test_(test), most_(most) {}

  Status run() {
    TRY(attempt(0));
    // A tenfold rigidity is about as much as the whole scale of drape is worth; so steps begin small.
    double step = 1;
    while (!found() && left() && !bracketed()) {
      const double next = best_end() + (tries_.front().drape < wanted_ ? step : -step);
      if (std::abs(next) > std::log(kMostFactor)) break;
      TRY(attempt(next));
      step *= 1.6;
    }
    while (!found() && left() && bracketed()) TRY(attempt(between()));
    return {};
  }

  Try best() const {
    return *std::min_element(tries_.begin(), tries_.end(),
                             [&](const Try& a, const Try& b) { return off(a) < off(b); });
  }
  const std::vector<Try>& tries() const { return tries_; }
  bool found() const { return off(best()) <= kPoint; }

 private:
  Status attempt(double log_factor) {
    const double drape = TRY(test_(scaled(fabric_, what_, std::exp(log_factor))));
    tries_.push_back({log_factor, drape});
    if (drape < wanted_ && (!low_ || log_factor > low_->log_factor)) low_ = tries_.back();
    if (drape >= wanted_ && (!high_ || log_factor < high_->log_factor)) high_ = tries_.back();
    return {};
  }
  double off(const Try& t) const { return std::abs(t.drape - wanted_); }
  bool left() const { return static_cast<int>(tries_.size()) < most_; }
  bool bracketed() const { return low_ && high_ && low_->log_factor < high_->log_factor; }
  double best_end() const { return tries_.back().log_factor; }
  /// By the rule of false position, kept off the ends so that a flat stretch is left.
  double between() const {
    const double rise = high_->drape - low_->drape;
    const double share = rise > 0 ? (wanted_ - low_->drape) / rise : 0.5;
    return low_->log_factor + std::clamp(share, 0.15, 0.85) * (high_->log_factor - low_->log_factor);
  }

  material::Fabric fabric_;
  Unknown what_;
  double wanted_;
  const DrapeTest& test_;
  int most_;
  std::vector<Try> tries_;
  std::optional<Try> low_, high_;
};

std::string length_words(const material::Fabric& f) {
  const double c = fabric::bending_length((f.bend_warp + f.bend_weft) / 2, f.areal_mass);
  return fixed_text(1e3 * c, 1) + " mm";
}

/// The two extremes of the tried factors whose drapes are within two points of the measured one.
void tell_range(const FactorSearch& search, double wanted, Unknown what, Calibration& out) {
  double least = 1e9, most = -1e9;
  for (const Try& t : search.tries()) {
    if (std::abs(t.drape - wanted) > 2 * kPoint) continue;
    least = std::min(least, t.log_factor);
    most = std::max(most, t.log_factor);
  }
  if (most - least < 0.05) return;
  out.open.push_back(std::string("any ") + name_of(what) + " from " +
                     number_text(std::round(100 * std::exp(least - search.best().log_factor))) + " to " +
                     number_text(std::round(100 * std::exp(most - search.best().log_factor))) +
                     " % of what was found drapes within two points of it");
}

/// Whether the drape feels what it was not used for: a figure that may be twice as large and drapes alike is
/// not told by it.
Status tell_unfelt(const std::vector<Unknown>& unknown, const DrapeTest& test, int left, Calibration& out) {
  for (const Unknown what : unknown) {
    if (out.fitted == what) continue;
    if (left-- <= 0) {
      out.open.push_back(std::string(name_of(what)) + " was not measured and is that of an ordinary cloth");
      continue;
    }
    const double drape = TRY(test(scaled(out.fabric, what, 2)));
    ++out.tests;
    const double change = 100 * (drape - out.drape);
    const bool felt = std::abs(change) > 100 * kPoint;
    out.open.push_back(
        std::string(name_of(what)) +
        " was not measured and is that of an ordinary cloth; twice of it changes the drape by " +
        fixed_text(change, 1) + " points" +
        (felt && out.fitted ? ", which " + std::string(name_of(*out.fitted)) + " could make as well"
         : felt             ? ""
                            : ", so that the drape does not tell it"));
  }
  return {};
}

void tell_directions(const Measured& m, Calibration& out) {
  const bool warp = m.length_warp || m.kes_bend_warp, weft = m.length_weft || m.kes_bend_weft;
  if (!warp && !weft) {
    out.open.push_back(
        "bending along warp and weft are taken to be alike, as a drape coefficient is of all "
        "directions together: a mean bending length of " +
        length_words(out.fabric));
  } else if (warp != weft) {
    out.open.push_back(std::string("bending along the ") + (warp ? "weft" : "warp") +
                       " was not measured and is taken to be as along the " + (warp ? "warp" : "weft"));
  }
  out.open.push_back(
      "bending on the bias was not measured: three quarters of the mean of warp and weft, as is usual");
}

}  // namespace

double rigidity_of_length(double length, double areal_mass) {
  return areal_mass * kEarthGravity * length * length * length;
}
double rigidity_of_kes(double b) { return b * 9.80665e-5; }  // gf·cm²/cm = 9.80665e-3 N × 1e-4 m² / 1e-2 m
double shear_of_fast(double eb5) { return 123 / eb5; }
double shear_of_kes(double g) { return g * 0.980665 * 180 / 3.14159265358979323846; }

std::vector<Unknown> missing(const Measured& m) {
  std::vector<Unknown> unknown;
  if (!m.length_warp && !m.length_weft && !m.kes_bend_warp && !m.kes_bend_weft)
    unknown.push_back(Unknown::kBending);
  if (!m.fast_eb5 && !m.kes_shear) unknown.push_back(Unknown::kShear);
  if (!m.fast_e100_warp && !m.fast_e100_weft && !m.kes_emt_warp && !m.kes_emt_weft)
    unknown.push_back(Unknown::kStretch);
  return unknown;
}

Result<material::Fabric> fabric_from(const Measured& m) {
  TRY(in_range(m));
  material::Fabric f;
  f.id = "calibrated";
  f.areal_mass = m.areal_mass;
  set_pair(rigidity(m.length_warp, m.kes_bend_warp, m.areal_mass),
           rigidity(m.length_weft, m.kes_bend_weft, m.areal_mass),
           rigidity_of_length(kOrdinaryLength, m.areal_mass), f.bend_warp, f.bend_weft);
  f.bend_bias = kOrdinaryBias * (f.bend_warp + f.bend_weft) / 2;
  set_pair(stiffness(m.fast_e100_warp, m.kes_emt_warp), stiffness(m.fast_e100_weft, m.kes_emt_weft),
           kOrdinaryStretch, f.stretch_warp, f.stretch_weft);
  f.stretch_coupling = 0.1 * std::sqrt(f.stretch_warp * f.stretch_weft);
  f.stretch_shear = m.fast_eb5    ? shear_of_fast(*m.fast_eb5)
                    : m.kes_shear ? shear_of_kes(*m.kes_shear)
                                  : kOrdinaryShear;
  if (m.thickness) f.thickness = *m.thickness;
  return f;
}

Result<Calibration> calibrate(const Measured& measured, const DrapeTest& test, int most_tests) {
  Calibration out;
  out.fabric = TRY(fabric_from(measured));
  const std::vector<Unknown> unknown = missing(measured);
  if (!measured.drape) {
    out.within = true;
    for (const Unknown what : unknown)
      out.open.push_back(std::string(name_of(what)) + " was not measured and is that of an ordinary cloth");
    tell_directions(measured, out);
    return out;
  }
  const bool fits = has(unknown, Unknown::kBending) || has(unknown, Unknown::kShear);
  if (fits) {
    out.fitted = has(unknown, Unknown::kBending) ? Unknown::kBending : Unknown::kShear;
    const int kept = static_cast<int>(unknown.size()) - 1;  // tests that tell what else is felt
    FactorSearch search(out.fabric, *out.fitted, *measured.drape, test, std::max(3, most_tests) - kept);
    TRY(search.run());
    scale(out.fabric, *out.fitted, std::exp(search.best().log_factor));
    out.drape = search.best().drape;
    out.tests = static_cast<int>(search.tries().size());
    tell_range(search, *measured.drape, *out.fitted, out);
  } else {
    out.drape = TRY(test(out.fabric));
    out.tests = 1;
  }
  out.off = out.drape - *measured.drape;
  out.within = std::abs(out.off) <= kPoint;
  TRY(tell_unfelt(unknown, test, std::max(3, most_tests) - out.tests, out));
  tell_directions(measured, out);
  return out;
}

DrapeTest cusick_test(int drapes, double particle_distance, const RunContext& context) {
  // Each face up and each turn come once before one comes again.
  constexpr std::array kOrder{0, 3, 4, 1, 2, 5};
  return [drapes, particle_distance, context, kOrder](const material::Fabric& fabric) -> Result<double> {
    const double fitting = particle_distance > 0 ? particle_distance : fabric::fitting_distance(fabric);
    double sum = 0;
    for (int k = 0; k < drapes; ++k) {
      const int number = kOrder.at(static_cast<std::size_t>(k));
      const CusickDrape drape = TRY(cusick_drape(fabric, number, fitting, context));
      sum += drape.shadow.coefficient;
    }
    return sum / drapes;
  };
}

}  // namespace toile::trials
