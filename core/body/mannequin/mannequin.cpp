#include "core/body/mannequin/mannequin.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/body/mannequin/broyden.h"
#include "core/body/mannequin/carry.h"
#include "core/body/mannequin/field.h"
#include "core/body/mannequin/polygonise.h"
#include "core/body/mannequin/proportions.h"
#include "core/body/mannequin/remesh.h"

namespace toile::mannequin {
namespace {

constexpr double kSkinArea = 0.62;        // of the stature squared, near enough to choose a grid
constexpr double kFinestCell = 5.0e-3;    // of the stature; remeshing refines from there
constexpr double kCoarsestCell = 7.0e-3;  // fingertips and the gap between the legs need this
constexpr double kCellPerEdge = 0.5;
constexpr double kFold = 0.5, kFoldedMiss = 1000;     // cosine; worse than any miss
constexpr double kAgreeing = 2;                       // least length of three normals' sum
constexpr int kNewMeshes = 2;                         // tries after the first
constexpr double kWorse = 1.5, kShorter = 0.5;        // than the best step so far; a share of the next
constexpr int kCorrections = 16, kEveningRounds = 3;  // corrections of the shape, by what the mesh measures
constexpr int kRelaxing = 2;                          // corrections after which triangles are evened out
constexpr double kGoodGirth = 0.0007, kGoodLength = 0.0025;          // m, good enough to stop correcting
constexpr double kGirthTolerance = 0.005, kLengthTolerance = 0.010;  // m
constexpr Index kSureTriangles = 2000;  // fewer do not always hold what a tape should read
constexpr double kGreatestGirth = 2.2, kGreatestLength = 1.35;  // factors; their inverses are the least
constexpr double kGreatestStep = 0.12, kGreatestOff = 0.15;  // of a factor, of a measure, in one correction

struct Limit {
  double low, high;  // shares of the height
};

// By Measure. Wide enough for most people, narrow enough for one surface without folds.
constexpr Limit kLimits[measure::kMeasureCount] = {
    {1, 1},       {0.42, 0.78}, {0.36, 0.72}, {0.31, 0.74}, {0.45, 0.80}, {0.15, 0.32}, {0.16, 0.27},
    {0.10, 0.28}, {0.07, 0.15}, {0.27, 0.39}, {0.24, 0.48}, {0.15, 0.32}, {0.38, 0.52}, {0.17, 0.30}};

// With one decimal at most: "92", "61.5".
std::string decimal(double value) {
  std::string text = fixed_text(std::round(value * 10) / 10, 1);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

/// What a setting is written in: times `scale`, then the unit's name.
struct Written {
  double scale;
  std::string unit;
};

// Bounds are rounded inwards, so that what is proposed is taken.
Status check_range(std::string_view name, double value, double low, double high, const Written& as,
                   const std::string& why = "") {
  if (value >= low * (1 - 1e-12) && value <= high * (1 + 1e-12)) return {};  // false for NaN too
  const double least = std::ceil(low * as.scale * 10 - 1e-6) / 10,
               most = std::floor(high * as.scale * 10 + 1e-6) / 10;
  const bool readable = std::isfinite(value) && std::abs(value) < 1e12;
  const std::string given = readable ? decimal(value * as.scale) + as.unit : "no number that can be";
  return Error{"mannequin.setting",
               std::string(name) + " is " + given + "; " + why + "it must lie between " + decimal(least) +
                   " and " + decimal(most) + as.unit + ".",
               std::string(name)};
}

Status check(const MannequinSettings& s, const measure::MeasureSet& wanted) {
  const double h = *wanted[measure::Measure::kHeight];
  const bool child = s.sex == Sex::kChild;
  TRY(check_range("height", h, child ? 0.8 : 1.3, child ? 1.75 : 2.2, {100, " cm"}));
  for (int i = 1; i < measure::kMeasureCount; ++i) {
    const measure::Measure m = measure::measure_at(i);
    const Limit l = kLimits[i];
    if (!s.asked[m]) continue;
    const std::string why = "for a height of " + decimal(h * 100) + " cm ";
    if (Status r =
            check_range(measure::measure_name(m), *s.asked[m], l.low * h, l.high * h, {100, " cm"}, why);
        !r)
      return r;
  }
  const double angle = degrees_from_radians(s.arm_angle);
  if (!(std::abs(angle - 90) < 1e-6)) {
    if (Status r = check_range("arm_angle", angle, 30, 60, {1, "°"}, "unless it is 90° "); !r) return r;
  }
  return check_range("triangles", s.triangle_count, 1000, 60000, {1, ""});
}

// Taylor series: rounds alike everywhere, which the library's sine does not promise. |x| < 1.6.
double sine(double x) {
  double term = x, sum = x;
  for (int n = 1; n < 12; ++n) sum += term *= -x * x / ((2 * n) * (2 * n + 1));
  return sum;
}

double grid_cell(Index triangle_count) {
  const double edge = std::sqrt(kSkinArea / triangle_count * 4 / std::sqrt(3.0));
  return std::clamp(edge * kCellPerEdge, kFinestCell, kCoarsestCell);
}

geometry::TriangleMesh first_mesh(const BodyShape& shape, Index triangle_count) {
  const BodyField field(shape);
  const ImplicitSurface surface = [&field](Vec3 p) { return field.at(p); };
  const double breadth = field.half_breadth();
  const GridBox box{{-breadth, -0.02, -0.22}, {breadth, 1.03, 0.26}, grid_cell(triangle_count)};
  return remesh(polygonise(surface, box), surface, remesh_settings(field, triangle_count));
}

// Other triangles on the same surface, where a change of shape has crowded or folded them.
geometry::TriangleMesh evened(geometry::TriangleMesh mesh, const BodyShape& shape, Index triangle_count) {
  const BodyField field(shape);
  const ImplicitSurface surface = [&field](Vec3 p) { return field.at(p); };
  RemeshSettings settings = remesh_settings(field, triangle_count);
  settings.rounds = kEveningRounds;
  return remesh(std::move(mesh), surface, settings);
}

/// Finds the factors whose body measures what was asked, by Broyden's method: it starts as if each factor
/// moved its own measure only, and learns from every step how they move each other's. Factors of what was not
/// asked stay where proportions put them.
class ShapeSolver {
 public:
  ShapeSolver(const measure::MeasureSet& asked, const measure::MeasureSet& wanted, BodyShape start)
      : shape(start), asked_(asked) {
    for (int i = 1; i < measure::kMeasureCount; ++i) {
      const measure::Measure m = measure::measure_at(i);
      shape.of(m) = limited(i, *wanted[m] / *wanted[measure::Measure::kHeight] / shape.figure->of(m));
      if (asked[m]) free_.push_back(i);
    }
    follow();
    restart();
  }

  /// Forgets where it was, as when the mesh is another; keeps what was learnt.
  void restart() {
    last_step_.clear();
    least_miss_ = HUGE_VAL;
    bad_steps_ = 0;
  }
  /// Begins anew from a shape.
  void restart(const BodyShape& from) {
    shape = from;
    broyden_.clear();
    restart();
  }

  /// How far the worst of all measures is off, as a share of what is good enough.
  double miss(const measure::BodyMeasures& got) const {
    double worst = 0;
    for (int i : free_) {
      const measure::Measure m = measure::measure_at(i);
      const double off = got[m] ? std::abs(got[m]->value - *asked_[m]) : 1;
      worst = std::max(worst, off / (measure::is_girth(m) ? kGoodGirth : kGoodLength));
    }
    return worst;
  }

  void correct(const measure::BodyMeasures& got) {
    std::vector<double> off = offs(got);
    if (broyden_.empty()) broyden_.begin(free_.size());
    if (!last_step_.empty()) broyden_.learn(last_step_, last_off_, off);
    const double missed = miss(got);
    double share = 1;
    if (missed < kWorse * least_miss_) {
      bad_steps_ = 0;
      if (missed < least_miss_) {
        least_miss_ = missed;
        best_ = shape;
        best_off_ = off;
      }
    } else {
      // From the best place so far, with a shorter step; what keeps leading astray is not worth keeping.
      if (++bad_steps_ > 1) broyden_.begin(free_.size());
      shape = best_;
      off = best_off_;
      share = kShorter;
    }
    step(off, share);
  }

  BodyShape shape;

 private:
  static double limited(int measure, double factor) {
    const double most = measure::is_girth(measure::measure_at(measure)) ? kGreatestGirth : kGreatestLength;
    return std::clamp(factor, 1 / most, most);
  }

  // How far each measure asked for is off, as a share of itself.
  std::vector<double> offs(const measure::BodyMeasures& got) const {
    std::vector<double> off;
    for (int i : free_) {
      const measure::Measure m = measure::measure_at(i);
      off.push_back(got[m] ? std::clamp(got[m]->value / *asked_[m] - 1, -kGreatestOff, kGreatestOff) : 0);
    }
    return off;
  }

  void step(const std::vector<double>& off, double share) {
    last_off_ = off;
    last_step_ = broyden_.step(off, share);
    for (size_t k = 0; k < free_.size(); ++k) {
      double& factor = shape.factor[free_[k]];
      const double change = std::clamp(last_step_[k], -kGreatestStep, kGreatestStep);
      const double next = limited(free_[k], factor * (1 + change));
      last_step_[k] = next / factor - 1;  // as it was taken within the limits
      factor = next;
    }
    follow();
  }

  // Nobody asked: ribs lie between chest and waist, so that the trunk has no step.
  void follow() {
    if (asked_[measure::Measure::kUnderbust] || shape.figure->bust_share > 0) return;
    shape.of(measure::Measure::kUnderbust) =
        0.55 * shape.of(measure::Measure::kBust) + 0.45 * shape.of(measure::Measure::kWaist);
  }

  const measure::MeasureSet& asked_;
  std::vector<int> free_;  ///< measures asked for
  Broyden broyden_;
  std::vector<double> last_off_, last_step_;
  BodyShape best_;  ///< of those on this mesh
  std::vector<double> best_off_;
  double least_miss_ = HUGE_VAL;
  int bad_steps_ = 0;
};

BodyJoints scaled(const BodyJoints& joints, double height) {
  BodyJoints j = joints;
  for (Vec3* p : {&j.head_top, &j.chin, &j.neck, &j.shoulder, &j.elbow, &j.wrist, &j.hand_tip, &j.hip,
                  &j.knee, &j.ankle, &j.toe})
    *p = *p * height;
  return j;
}

/// The best of some rounds.
struct Fit {
  geometry::TriangleMesh mesh;
  BodyShape shape;
  std::optional<measure::BodyMeasures> measures;  ///< nothing: no round made a body
  double miss = HUGE_VAL;
  BodyShape next = {};  ///< to go on from, with another mesh
};

// Smallest cosine between a triangle and the field's normals at its corners, where these agree: a fold in the
// mesh has a low one. Across a thin edge, a hand's or a toe's, they do not, and the triangle stands between
// them.
double least_facing(const geometry::TriangleMesh& mesh, const BodyField& field) {
  std::vector<Vec3> normal;
  for (const Vec3& p : mesh.vertices) normal.push_back(normalized(field.at(p).gradient));
  double least = 1;
  for (const Tri& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vec3 sum = normal[t[0]] + normal[t[1]] + normal[t[2]];
    if (length(sum) < kAgreeing) continue;
    least = std::min(least, dot(normalized(cross(b - a, c - a)), normalized(sum)));
  }
  return least;
}

Fit corrected(ShapeSolver& solver, Index triangle_count, double height) {
  Fit best, nearest;  // the latter by its measures alone, folded or not
  best.shape = nearest.shape = solver.shape;
  geometry::TriangleMesh unit = first_mesh(solver.shape, triangle_count);
  int times_folded = 0;
  for (int i = 0; i <= kCorrections; ++i) {
    const bool folded = least_facing(unit, BodyField(solver.shape)) < kFold;
    times_folded = folded ? times_folded + 1 : 0;
    geometry::TriangleMesh mesh = stand(unit, height);
    const Result<measure::BodyMeasures> got = measure::measure_body(mesh);
    if (!got) break;
    const double off = solver.miss(*got), miss = off + (folded ? kFoldedMiss : 0);
    if (off < nearest.miss) nearest = {{}, solver.shape, *got, off};
    if (miss < best.miss) best = {std::move(mesh), solver.shape, *got, miss};
    if (miss <= 1) break;
    const BodyShape before = solver.shape;
    if (off > 1) solver.correct(*got);
    // A mesh that is folded is evened, and one that stays folded made anew.
    if (times_folded > 1) {
      unit = first_mesh(solver.shape, triangle_count);
    } else {
      unit = fitted(std::move(unit), before, solver.shape, triangle_count, i < kRelaxing ? 1 : 0);
      if (folded || i == kRelaxing) unit = evened(std::move(unit), solver.shape, triangle_count);
    }
    if (folded || i == kRelaxing) solver.restart();
  }
  best.next = nearest.shape;
  return best;
}

// Names the measure, what was asked, what the nearest body has, and what would do.
Error not_met(measure::Measure m, double asked, const std::optional<measure::TakenMeasure>& got,
              Index triangle_count) {
  const std::string name(measure::measure_name(m)), bound = measure::is_girth(m) ? "5 mm" : "10 mm";
  std::string text = "These measures do not go together in one body: " + name + " was asked at " +
                     decimal(asked * 100) + " cm, ";
  if (got) {
    text += "and the nearest body has " + decimal(got->value * 100) + " cm, off by more than " + bound +
            ". Ask for about " + decimal(got->value * 100) + " cm, or leave it out";
  } else {
    text += "and cannot be taken on the nearest body. Leave it out";
  }
  if (triangle_count < kSureTriangles)
    text += ", or ask for " + std::to_string(kSureTriangles) + " triangles or more";
  return {"mannequin.measures", text + ".", name};
}

// Only what was asked for has to be met.
Status check_met(const MannequinSettings& settings, const measure::BodyMeasures& got) {
  double worst = 1;
  Status status;
  for (int i = 0; i < measure::kMeasureCount; ++i) {
    const measure::Measure m = measure::measure_at(i);
    const std::optional<double>& asked = settings.asked[m];
    if (!asked) continue;
    const double off = got[m] ? std::abs(got[m]->value - *asked) : 1;
    const double share = off / (measure::is_girth(m) ? kGirthTolerance : kLengthTolerance);
    if (share <= worst) continue;
    worst = share;
    status = not_met(m, *asked, got[m], settings.triangle_count);
  }
  return status;
}

}  // namespace

Result<Mannequin> make_mannequin(const MannequinSettings& settings) {
  const measure::MeasureSet wanted = with_proportions(settings.sex, settings.asked);
  TRY(check(settings, wanted));
  const double h = *wanted[measure::Measure::kHeight];
  BodyShape start;
  start.figure = &figure_of(settings.sex);
  start.head = head_size(settings.sex, h);
  start.face = std::clamp((settings.triangle_count - 5000) / 10000.0, 0.0, 1.0);
  start.arm_sine = sine(settings.arm_angle);
  start.arm_cosine = sine(kQuarterTurn - settings.arm_angle);
  measure::MeasureSet targets = settings.asked;
  for (measure::Measure m : {measure::Measure::kBust, measure::Measure::kWaist, measure::Measure::kHip})
    targets[m] = wanted[m];
  ShapeSolver solver(targets, wanted, start);

  Fit fit = corrected(solver, settings.triangle_count, h);
  // What a crowded mesh has spoilt, a new one on the shape found so far may mend.
  for (int i = 0; i < kNewMeshes && fit.measures && !check_met(settings, *fit.measures); ++i) {
    solver.restart(fit.next);
    Fit again = corrected(solver, settings.triangle_count, h);
    fit.next = again.next;
    if (again.measures && again.miss < fit.miss) fit = std::move(again);
  }
  if (!fit.measures) return Error{"mannequin.measures", "These measures do not make a body.", ""};
  TRY(check_met(settings, *fit.measures));
  return Mannequin{std::move(fit.mesh), wanted, *fit.measures, scaled(PlacedFigure(fit.shape).joints(), h),
                   fit.shape};
}

}  // namespace toile::mannequin
