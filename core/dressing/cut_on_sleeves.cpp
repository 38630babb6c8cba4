#include "core/dressing/cut_on_sleeves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/sewing/rings.h"

namespace toile::dressing {

namespace {

constexpr double kReaches = 1.6;  ///< times the armpits' distance from the middle: then it is for the arms
constexpr double kEnd = 0.05;     ///< m, from the outermost point, that are the end of a sleeve
constexpr double kAtArm = 0.12;   ///< m, from the arm's line, what is a sleeve
constexpr double kBend = 0.1;     ///< m, over which the cloth turns from the shoulder's line into the arm's
constexpr double kFromArmpit = 0.9;  ///< of the armpits' distance, where the bend begins

/// How far a piece reaches to one side of the body's middle plane, and the middle of the opening there, m.
struct Wing {
  double reach = 0, opening = 0;
};

/// Whether each vertex lies on a border of the sewn garment.
std::vector<bool> on_border(const sewing::GarmentMesh& g) {
  std::vector<bool> border(g.weld.size(), false);
  for (const std::vector<Index>& ring : sewing::rings_of(g))
    for (const Index v : ring) border[v] = true;
  for (std::size_t v = 0; v < border.size(); ++v) border[v] = border[g.weld[v]];
  return border;
}

/// The opening is what of the outer end no seam shuts, above the waist: the hem may reach as far. All of it
/// where seams shut it.
Wing wing_of(const sewing::GarmentMesh& g, const std::vector<bool>& border, std::size_t piece,
             const measure::BodyFigure& f, double side, std::span<const Vec3> x) {
  Wing wing;
  for (Index v = g.first_vertex[piece]; v < g.first_vertex[piece + 1]; ++v)
    wing.reach = std::max(wing.reach, side * (x[v].x - f.middle));
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (Index v = g.first_vertex[piece]; v < g.first_vertex[piece + 1]; ++v) {
    if (side * (x[v].x - f.middle) < wing.reach - kEnd || x[v].y < f.waist) continue;
    for (const int k : {0, 1}) {
      if (k == 0 && !border[v]) continue;
      low[k] = std::min(low[k], x[v].y);
      high[k] = std::max(high[k], x[v].y);
    }
  }
  const int k = low[0] < high[0] ? 0 : 1;
  wing.opening = low[k] <= high[k] ? (low[k] + high[k]) / 2 : f.waist;
  return wing;
}

/// Height of the arm's line at a distance from the body's middle plane at which the arm has not left the
/// trunk yet; of arms that hang down, not much above their root.
double begin_of_arm(const measure::ArmLine& arm, double aside, double middle) {
  constexpr double kLeastOut = 0.5;  // of a length along the arm
  const double back = std::abs(arm.root.x - middle) - aside;
  return arm.root.y - arm.along().y * back / std::max(kLeastOut, std::abs(arm.along().x));
}

}  // namespace

bool has_cut_on_sleeves(const sewing::Assembly& assembly, std::size_t piece, const measure::BodyFigure& f) {
  const sewing::GarmentMesh& g = assembly.garment;
  const double room = f.armpit[0].x - f.middle;
  bool shoulders = false, sleeves = false;
  for (Index v = g.first_vertex[piece]; v < g.first_vertex[piece + 1]; ++v) {
    const Vec3 p = assembly.positions[v];
    const double aside = std::abs(p.x - f.middle);
    shoulders = shoulders || (aside < room && p.y > f.armpit[0].y);
    sleeves = sleeves || (aside > kReaches * room && p.y > f.bust);
  }
  return shoulders && sleeves;
}

void lay_along_arms(const sewing::Assembly& assembly, std::span<const Covers> covers,
                    const measure::BodyFigure& f, std::vector<Vec3>& x) {
  const sewing::GarmentMesh& g = assembly.garment;
  const std::vector<bool> border = on_border(g);
  const double room = f.armpit[0].x - f.middle, begin = kFromArmpit * room;
  for (std::size_t p = 0; p < covers.size(); ++p) {
    if (covers[p] != Covers::kTrunk || !has_cut_on_sleeves(assembly, p, f)) continue;
    for (const measure::ArmLine& arm : f.arm) {
      const double side = arm.root.x > f.middle ? 1 : -1, shorter = std::abs(arm.along().x);
      const Wing wing = wing_of(g, border, p, f, side, x);
      if (wing.reach < kReaches * room) continue;
      const double top = begin_of_arm(arm, begin, f.middle);
      for (Index v = g.first_vertex[p]; v < g.first_vertex[p + 1]; ++v) {
        const double aside = side * (x[v].x - f.middle);
        if (aside < begin) continue;
        const double line = std::lerp(top, wing.opening, (aside - begin) / (wing.reach - begin));
        const double on_arm = top + (aside - begin) * arm.along().y;
        const double t = std::clamp((aside - begin) / kBend, 0.0, 1.0), share = t * t * (3 - 2 * t);
        x[v].x = f.middle + side * (begin + (aside - begin) * shorter);
        // What hangs far below the arms, as of a poncho, is not raised to them.
        x[v].y += share * std::min(0.0, on_arm - line);
      }
    }
  }
}

KeptOnArms::KeptOnArms(const sewing::Assembly& assembly, std::span<const Covers> covers,
                       const measure::BodyFigure& f, std::span<const Vec3> x) {
  const sewing::GarmentMesh& g = assembly.garment;
  for (const measure::ArmLine& arm : f.arm) {
    Sleeve sleeve{{}, arm.root, arm.along(), normalized(cross(arm.along(), {0, 0, 1}))};
    for (std::size_t p = 0; p < covers.size(); ++p) {
      if (covers[p] != Covers::kTrunk || !has_cut_on_sleeves(assembly, p, f)) continue;
      for (Index v = g.first_vertex[p]; v < g.first_vertex[p + 1]; ++v)
        if (dot(x[v] - arm.root, sleeve.along) > 0 &&
            std::abs(dot(x[v] - arm.root, sleeve.across)) < kAtArm &&
            (x[v].x > f.middle) == (arm.root.x > f.middle))
          sleeve.vertices.push_back(v);
    }
    if (!sleeve.vertices.empty()) sleeves_.push_back(std::move(sleeve));
  }
}

void KeptOnArms::keep(std::span<const Vec3> before, std::vector<Vec3>& x) const {
  for (const Sleeve& s : sleeves_) {
    // The line, by least squares, of displacements across over distances along the arm.
    double n = 0, out = 0, out_out = 0, across = 0, across_out = 0;
    for (const Index v : s.vertices) {
      const double t = dot(before[v] - s.root, s.along), d = dot(x[v] - before[v], s.across);
      n += 1;
      out += t;
      out_out += t * t;
      across += d;
      across_out += d * t;
    }
    const double spread = n * out_out - out * out;
    const double turned = spread > 0 ? (n * across_out - out * across) / spread : 0;
    const double moved = (across - turned * out) / n;
    for (const Index v : s.vertices)
      x[v] = x[v] - s.across * (moved + turned * dot(before[v] - s.root, s.along));
  }
}

}  // namespace toile::dressing
