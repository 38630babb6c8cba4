#include "core/body/measure/figure.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/aabb.h"
#include "core/body/measure/slices.h"

namespace toile::measure {

namespace {

// All shares below are of the stature. Where a place is looked for follows the proportions of adults and
// children roughly; what is found there is decided by the mesh.
constexpr double kScan = 0.0025;
constexpr double kTrunkDepth = 0.045;  ///< thighs that touch are thinner than this at the mid-plane
constexpr double kWaistOfFigure = 0.60, kUnusualOfFigure = 0.53;  ///< of the way from crotch to armpit
constexpr double kArmJump = 0.022;  ///< half breadth grows by so much where an arm joins the trunk
constexpr double kHandLow = 0.07, kHandHigh = 0.14;  ///< from the finger tips, where the wrist lies
constexpr double kUpperArmShare = 0.56;              ///< of the way from the shoulder to the wrist

Error not_standing(const char* what) {
  return {"body.not_standing",
          std::string("this is no standing person with arms off the trunk: ") + what +
              "; place landmarks by hand",
          ""};
}

/// Points of a cut near the mid-plane, their extent along z.
double depth_at(const BodyCut& cut, double middle, double within) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& p : cut.points) {
    if (std::abs(p.x - middle) > within) continue;
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  return high > low ? high - low : 0;
}

class FigureFinder {
 public:
  explicit FigureFinder(const geometry::TriangleMesh& mesh) : mesh_(mesh), cutter_(mesh) {}

  Result<BodyFigure> find() {
    measure_box();
    if (!(height() > 0)) return not_standing("it has no height");
    if (!find_crotch()) return not_standing("no two legs were found under one trunk");
    if (!find_armpits()) return not_standing("no place was found where arms join the trunk");
    find_trunk_girths();
    for (int side = 0; side < 2; ++side) {
      if (!find_arm(side)) return not_standing("an arm could not be followed from the hand to the trunk");
      find_leg(side);
    }
    find_neck();
    for (int side = 0; side < 2; ++side) {
      find_shoulder(side);
      find_bust(side);
    }
    find_neck_profile();
    f_.bust = (f_.bust_point[0].y + f_.bust_point[1].y) / 2;
    return f_;
  }

 private:
  double height() const { return f_.height(); }
  double at(double share) const { return f_.floor + share * height(); }
  static double sign_of(int side) { return side == kWearersLeft ? 1 : -1; }
  double girth_at_height(double y) const { return trunk_girth(cutter_, f_, y); }

  void measure_box() {
    if (mesh_.vertices.empty()) return;
    const Aabb3 box = bounding_box(mesh_.vertices);
    f_.floor = box.low.y;
    f_.top = box.high.y;
    f_.middle = box.middle().x;
  }

  bool find_crotch() {
    for (double s = 0.36; s < 0.60; s += kScan) {
      const BodyCut cut = middle_cut(cutter_, at(s), f_.middle);
      if (depth_at(cut, f_.middle, 0.02 * height()) < kTrunkDepth * height()) continue;
      f_.crotch = at(s);
      return s > 0.361;  // one solid from below the crotch on has no legs
    }
    return false;
  }

  /// From the waist upwards, each side's half breadth jumps where the arm joins.
  bool find_armpits() {
    std::array<double, 2> before{0, 0};
    std::array<bool, 2> found{false, false};
    std::array<Vec3, 2> edge;
    for (double s = 0.62; s < 0.86 && !(found[0] && found[1]); s += kScan) {
      const BodyCut cut = middle_cut(cutter_, at(s), f_.middle);
      if (cut.points.empty()) continue;
      for (int side = 0; side < 2; ++side) {
        if (found[side]) continue;
        const Vec3 outer = *std::max_element(cut.points.begin(), cut.points.end(), [&](Vec3 a, Vec3 b) {
          return sign_of(side) * a.x < sign_of(side) * b.x;
        });
        const double half = sign_of(side) * (outer.x - f_.middle);
        if (before[side] > 0 && half > before[side] + kArmJump * height()) {
          found[side] = true;
          f_.armpit[side] = edge[side];
        }
        before[side] = half;
        edge[side] = outer;
      }
    }
    return found[0] && found[1];
  }

  void find_trunk_girths() {
    const double armpit = std::min(f_.armpit[0].y, f_.armpit[1].y);
    double widest = 0, narrowest = HUGE_VAL;
    f_.hip = f_.crotch;
    for (double y = f_.crotch; y < f_.crotch + 0.09 * height(); y += kScan * height()) {
      if (const double g = girth_at_height(y); g > widest) {
        widest = g;
        f_.hip = y;
      }
    }
    f_.waist = at(0.62);
    for (double y = std::max(f_.hip + 0.04 * height(), at(0.56));
         y < std::min(armpit - 0.04 * height(), at(0.68)); y += kScan * height()) {
      // As the tape has it: the narrowest, the more so the nearer it is to where waists usually are.
      const double off = (y - f_.crotch) / (armpit - f_.crotch) - kWaistOfFigure;
      const double weighed = girth_at_height(y) * (1 + kUnusualOfFigure * off * off);
      if (weighed > 0 && weighed < narrowest) {
        narrowest = weighed;
        f_.waist = y;
      }
    }
  }

  struct ArmSection {
    double s;  ///< m along the arm
    Vec3 centre;
    double girth;
  };

  std::vector<ArmSection> arm_sections(Vec3 root, Vec3 along, double reach, double step) const {
    std::vector<ArmSection> sections;
    for (double s = 0; s < reach; s += step) {
      const Vec3 p = root + along * s;
      const BodyCut* nearest = nullptr;
      double best = 0.06 * height();
      const std::vector<BodyCut> cuts = cut_body(cutter_, p, along);
      for (const BodyCut& cut : cuts) {
        if (const double d = length(cut.box.middle() - p); d < best) {
          best = d;
          nearest = &cut;
        }
      }
      if (nearest == nullptr) continue;
      const double girth = tape_around(*nearest, along);
      if (girth > 0.03 * height() && girth < 0.28 * height())
        sections.push_back({s, nearest->box.middle(), girth});
    }
    return sections;
  }

  bool find_arm(int side) {
    ArmLine& arm = f_.arm[side];
    arm.tip = f_.armpit[side];
    for (const Vec3& p : mesh_.vertices) {
      if (p.y > at(0.3) && sign_of(side) * p.x > sign_of(side) * arm.tip.x) arm.tip = p;
    }
    Vec3 root = f_.armpit[side] + Vec3{0, 0.03 * height(), 0};
    Vec3 along = normalized(arm.tip - root);
    std::vector<ArmSection> sections;
    for (int round = 0; round < 3; ++round) {
      const double reach = dot(arm.tip - root, along);
      if (reach < 0.2 * height()) return false;
      sections = arm_sections(root, along, reach, 0.006 * height());
      if (sections.size() < 12) return false;
      const ArmSection& inner = sections[sections.size() / 5];
      const ArmSection& outer = sections[sections.size() * 7 / 10];
      along = normalized(outer.centre - inner.centre);
      root = inner.centre - along * inner.s;
    }
    return take_arm(side, sections, along);
  }

  /// Root, elbow, wrist and girth from the sections across the arm.
  bool take_arm(int side, const std::vector<ArmSection>& sections, Vec3 along) {
    ArmLine& arm = f_.arm[side];
    const double end = dot(arm.tip - sections.front().centre, along) + sections.front().s;
    const ArmSection* wrist = nullptr;
    for (const ArmSection& c : sections) {
      const double from_tip = end - c.s;
      if (from_tip < kHandLow * height() || from_tip > kHandHigh * height()) continue;
      if (wrist == nullptr || c.girth < wrist->girth) wrist = &c;
    }
    if (wrist == nullptr) return false;
    const auto nearest = [&](double s) {
      return *std::min_element(sections.begin(), sections.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.s - s) < std::abs(b.s - s);
      });
    };
    // Where the arm's own section begins, the armpit is passed.
    const double armpit = dot(f_.armpit[side] - sections.front().centre, along) + sections.front().s;
    const ArmSection first = nearest(std::max(armpit + 0.01 * height(), sections.front().s));
    arm.root = first.centre;
    arm.girth = first.girth;
    arm.wrist = wrist->centre;
    const double shoulder = first.s - 0.05 * height();
    arm.elbow = nearest(shoulder + kUpperArmShare * (wrist->s - shoulder)).centre;
    return true;
  }

  Vec3 leg_centre(int side, double y) const {
    Vec3 centre{f_.middle + sign_of(side) * 0.05 * height(), y, 0};
    double widest = 0;
    for (const BodyCut& cut : cut_body(cutter_, {0, y, 0}, {0, 1, 0})) {
      const Vec3 c = cut.box.middle();
      const double x = sign_of(side) * (c.x - f_.middle);
      const double girth = tape_around(cut, {0, 1, 0});
      if (x > 0 && x < 0.2 * height() && girth > widest) {
        widest = girth;
        centre = c;
      }
    }
    return centre;
  }

  void find_leg(int side) {
    LegLine& leg = f_.leg[side];
    leg.top = leg_centre(side, f_.crotch - 0.015 * height());
    leg.knee = leg_centre(side, at(0.278));
    double narrowest = HUGE_VAL;
    for (double s = 0.035; s < 0.10; s += kScan) {
      for (const BodyCut& cut : cut_body(cutter_, {0, at(s), 0}, {0, 1, 0})) {
        const double x = sign_of(side) * (cut.box.middle().x - f_.middle);
        const double girth = tape_around(cut, {0, 1, 0});
        if (x <= 0 || x > 0.25 * height() || girth < 0.07 * height() || girth > narrowest) continue;
        narrowest = girth;
        leg.ankle = cut.box.middle();
      }
    }
    if (narrowest == HUGE_VAL) leg.ankle = leg_centre(side, at(0.05));
  }

  /// The narrowest place above the shoulders, and where the section widens again towards the head.
  void find_neck() {
    double narrowest = HUGE_VAL;
    const double low = std::max(f_.armpit[0].y, f_.armpit[1].y) + 0.05 * height();
    for (double y = low; y < at(0.91); y += kScan * height()) {
      if (const double g = girth_at_height(y); g > 0 && g < narrowest) {
        narrowest = g;
        f_.neck = y;
      }
    }
    f_.chin = f_.neck + 0.02 * height();
    for (double y = f_.neck; y < at(0.94); y += kScan * height()) {
      f_.chin = y;
      if (girth_at_height(y) > 1.18 * narrowest) break;
    }
  }

  /// Height of the silhouette over x, seen from the front.
  std::vector<Vec3> ridge(int side, double from, double to, double step) const {
    std::vector<Vec3> line;
    for (double x = from; x <= to; x += step) {
      std::optional<Vec3> best;
      const double at_x = f_.middle + sign_of(side) * x;
      for (const BodyCut& cut : cut_body(cutter_, {at_x, 0, 0}, {1, 0, 0})) {
        for (const Vec3& p : cut.points) {
          if (p.y < f_.chin && p.y > at(0.5) && (!best || p.y > best->y)) best = p;
        }
      }
      if (best) line.push_back(*best);
    }
    return line;
  }

  void find_shoulder(int side) {
    const double step = 0.003 * height();
    const std::vector<Vec3> line = ridge(side, 0.02 * height(), 0.16 * height(), step);
    constexpr int kWindow = 5;
    const auto slope = [&](int i, int j) {
      return (line[i].y - line[j].y) / std::max(1e-9, std::abs(line[i].x - line[j].x));
    };
    f_.neck_side[side] = {f_.middle + sign_of(side) * 0.05 * height(), f_.neck, 0};
    f_.shoulder[side] = f_.armpit[side] + Vec3{0, 0.07 * height(), 0};
    const int count = static_cast<int>(line.size());
    // Outwards from the neck: its side ends where the line falls less than at 45 degrees.
    for (int i = 0; i + 3 < count; ++i) {
      if (line[i].y < f_.chin - 0.008 * height() && slope(i, i + 3) < 1) {
        f_.neck_side[side] = line[i];
        break;
      }
    }
    double sharpest = 0.1;
    for (int i = kWindow; i + kWindow < count; ++i) {
      const double x = sign_of(side) * (line[i].x - f_.middle);
      if (x < 0.088 * height() || x > 0.135 * height()) continue;
      const double turn = slope(i, i + kWindow) - slope(i - kWindow, i);
      if (turn > sharpest) {
        sharpest = turn;
        f_.shoulder[side] = line[i];
      }
    }
  }

  void find_bust(int side) {
    Vec3& point = f_.bust_point[side];
    const BodyCut chest = middle_cut(cutter_, f_.armpit[side].y - 0.02 * height(), f_.middle);
    const double half_way = chest.points.empty() ? -HUGE_VAL : chest.box.middle().z;
    point = {f_.middle + sign_of(side) * 0.05 * height(), at(0.72), -HUGE_VAL};
    for (const Vec3& p : mesh_.vertices) {
      const double x = sign_of(side) * (p.x - f_.middle);
      if (x < 0.025 * height() || x > 0.09 * height()) continue;
      if (p.y < f_.waist + 0.05 * height() || p.y > f_.armpit[side].y + 0.015 * height()) continue;
      if (p.z > std::max(point.z, half_way)) point = p;
    }
    if (std::isfinite(point.z)) return;
    // No corner of a coarse mesh lies there: the skin's own front below the armpit.
    point.z = 0;
    double most = -HUGE_VAL;
    for (const Vec3& p : chest.points)
      if (sign_of(side) * (p.x - f_.middle) > 0 && p.z > most) {
        most = p.z;
        point = p;
      }
  }

  /// Where the mid-plane's profile turns most from chest to neck, and from back to neck.
  void find_neck_profile() {
    const double side_y = (f_.neck_side[0].y + f_.neck_side[1].y) / 2;
    f_.neck_front = profile_turn(1, side_y - 0.06 * height(), side_y - 0.005 * height());
    f_.neck_back = profile_turn(-1, side_y - 0.03 * height(), side_y + 0.015 * height());
  }

  Vec3 profile_turn(double facing, double low, double high) const {
    const double step = 0.003 * height();
    constexpr int kWindow = 6;
    std::vector<Vec3> line;
    for (double y = low - kWindow * step; y <= high + kWindow * step; y += step) {
      const BodyCut cut = middle_cut(cutter_, y, f_.middle);
      const std::optional<Vec3> best = middle_skin(mesh_, cut, y, f_.middle, facing, 0.012 * height());
      line.push_back(best ? Vec3{f_.middle, y, best->z} : Vec3{f_.middle, y, 0});
    }
    double sharpest = -HUGE_VAL;
    Vec3 found = line[line.size() / 2];
    for (std::size_t i = kWindow; i + kWindow < line.size(); ++i) {
      const double turn = facing * (line[i + kWindow].z - 2 * line[i].z + line[i - kWindow].z);
      if (turn > sharpest) {
        sharpest = turn;
        found = line[i];
      }
    }
    return found;
  }

  const geometry::TriangleMesh& mesh_;
  PlaneCutter cutter_;
  BodyFigure f_;
};

}  // namespace

Result<BodyFigure> find_figure(const geometry::TriangleMesh& mesh) { return FigureFinder(mesh).find(); }

double trunk_girth(const PlaneCutter& cutter, const BodyFigure& figure, double height) {
  return tape_around(middle_cut(cutter, height, figure.middle), {0, 1, 0});
}

}  // namespace toile::measure
