#include "core/body/mannequin/shape.h"

#include <algorithm>
#include <cmath>

#include "core/body/mannequin/field_sample.h"

namespace toile::mannequin {
namespace {

constexpr double kAnkle = 0.05, kChest = 0.785;  // heights that keep their distance to the floor, to the nape
constexpr double kLeastRise = 0.08, kLeastRibs = 0.06;  // crotch to waist, waist to chest
// How much of a change of girth each direction takes: bellies and breasts grow forwards.
constexpr double kWidthShare = 0.85, kFrontShare = 1.3, kBackShare = 1.0;
// Between a leg and the middle, and from how far below the crotch: what lies nearer grows together.
constexpr double kLegGap = 0.0110, kThighsFree = 0.05;
// A small child's trunk is rounder than a grown-up's; children's heads tell how small they are.
constexpr double kSmallChild = 0.33, kRoundTrunk = 0.08;
constexpr double kBellyFront = 0.6, kBellyBack = 0.7;
// Breasts: their reach below the centre against the tape's place below them, for ribs as they usually are.
constexpr double kUnderBust = 0.41;  // of the way from nape to crotch, where the tape goes
constexpr double kRibsMove = 0.018;
constexpr double kUsualReach = 1.25, kUsualFullness = 1.01, kReachPerFullness = 4;
constexpr double kFineStroke = 0.0150;  // on the head, narrower ones need small triangles
constexpr double kFingerStroke = 0.007;
constexpr double kArmRoot = 0.01, kArmClear = 0.07;    // along the arm: where it leaves the trunk
constexpr double kArmReach = 0.05;                     // from the arm's axis
constexpr double kRaisedArm = 0.7071, kRaise = 0.045;  // shoulders rise with arms held higher than 45°

double mix(double a, double b, double s) { return a + (b - a) * s; }
double grown(double scale, double share) { return 1 + share * (scale - 1); }

struct Knot {
  double at, value;
};

// Smooth steps from knot to knot, level beyond the ends.
double eased(std::span<const Knot> knots, double x) {
  if (x <= knots.front().at) return knots.front().value;
  for (size_t i = 1; i < knots.size(); ++i)
    if (x < knots[i].at)
      return mix(knots[i - 1].value, knots[i].value, smooth_step(knots[i - 1].at, knots[i].at, x));
  return knots.back().value;
}

LoftSection section_at(std::span<const LoftSection> rows, double t) {
  size_t i = 1;
  while (i + 1 < rows.size() && rows[i].t < t) ++i;
  const LoftSection &a = rows[i - 1], &b = rows[i];
  const double s = std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0);
  return {t,
          mix(a.u, b.u, s),
          mix(a.v, b.v, s),
          mix(a.half, b.half, s),
          mix(a.front, b.front, s),
          mix(a.back, b.back, s),
          0,
          0};
}

std::vector<LoftSection> copied(std::span<const LoftSection> rows) { return {rows.begin(), rows.end()}; }

}  // namespace

PlacedFigure::PlacedFigure(const BodyShape& shape) : figure_(*shape.figure), shape_(shape) {
  set_heights();
  place_leg();
  place_trunk();
  place_neck_and_head();
  place_arm();
  place_masses();
  place_strokes();
}

void PlacedFigure::set_heights() {
  const Figure& f = figure_;
  const double chin = 1 - (1 - f.chin) * shape_.head;
  const double nape = chin - (f.chin - f.nape) * shape_.head;
  const double chest = nape - (f.nape - kChest);
  const double crotch = f.crotch * shape_.of(measure::Measure::kInseam);
  double waist = nape - (f.nape - f.waist) * shape_.of(measure::Measure::kBackLength);
  waist = std::clamp(waist, crotch + kLeastRise, chest - kLeastRibs);
  heights_ = {{0, 0},          {kAnkle, kAnkle}, {f.crotch, crotch}, {f.waist, waist},
              {kChest, chest}, {f.nape, nape},   {f.chin, chin},     {1, 1}};
  // The ribs' girth is set where the tape will go, which lies a share of the way down a longer or shorter
  // trunk.
  const double usual_tape = f.nape - kUnderBust * (f.nape - f.crotch);
  const double moved = figure_height_of(tape_below_bust()) - usual_tape;
  ribs_ = f.underbust + std::clamp(moved, -kRibsMove, kRibsMove);
}

double PlacedFigure::tape_below_bust() const {
  const double nape = height_of(figure_.nape);
  return nape - kUnderBust * (nape - height_of(figure_.crotch));
}

double PlacedFigure::figure_height_of(double y) const {
  size_t i = 1;
  while (i + 1 < heights_.size() && heights_[i].to < y) ++i;
  const Anchor &a = heights_[i - 1], &b = heights_[i];
  return a.from + (b.from - a.from) * (y - a.to) / (b.to - a.to);
}

double PlacedFigure::height_of(double y) const {
  size_t i = 1;
  while (i + 1 < heights_.size() && heights_[i].from < y) ++i;
  const Anchor &a = heights_[i - 1], &b = heights_[i];
  return a.to + (b.to - a.to) * (y - a.from) / (b.from - a.from);
}

Vec3 PlacedFigure::carried_from(const PlacedFigure& other, Vec3 p) const {
  const double side = p.x < 0 ? -1 : 1;
  const Vec3 trunk{side * p.x, height_of(other.figure_height_of(p.y)), p.z};
  const Vec3 d = Vec3{side * p.x, p.y, p.z} - other.shoulder;
  const double along = dot(d, other.along_arm), out = dot(d, other.out_of_arm);
  const double off = std::sqrt(out * out + d.z * d.z);
  const double arm_share =
      smooth_step(kArmRoot, kArmClear, along) * (1 - smooth_step(kArmReach, 2 * kArmReach, off));
  const double longer = along < other.wrist ? along * (wrist / other.wrist) : along + wrist - other.wrist;
  const Vec3 on_arm = shoulder + along_arm * longer + out_of_arm * out + Vec3{0, 0, d.z};
  const Vec3 q = trunk + (on_arm - trunk) * arm_share;
  return {side * q.x, q.y, q.z};
}

PlacedFigure::Scale PlacedFigure::trunk_scale(double y) const {
  const Figure& f = figure_;
  const double hip = shape_.of(measure::Measure::kHip), waist = shape_.of(measure::Measure::kWaist),
               under = shape_.of(measure::Measure::kUnderbust), full = shape_.of(measure::Measure::kBust);
  // With breasts, these take most of a change of the bust; a chest takes it whole.
  const double chest = f.bust_share > 0 ? mix(under, full, 0.45) : full;
  const Knot girth[] = {{f.hip, hip},    {f.waist, waist},           {ribs_, under},
                        {f.bust, chest}, {0.800, grown(chest, 0.6)}, {0.840, grown(chest, 0.4)}};
  const double s = eased(girth, y);
  // A waist fuller than hip and chest are is a belly: it grows forwards, and the small of the back stays.
  const double belly = std::max(0.0, s - mix(hip, chest, smooth_step(f.hip, f.bust, y)));
  const double width = grown(s, kWidthShare), broad = shape_.of(measure::Measure::kShoulderWidth);
  const double young = std::min((shape_.head - 1) / kSmallChild, 1.0);
  const double flat = 1 - kRoundTrunk * young, deep = 1 + kRoundTrunk * young;
  return {mix(width * flat, broad, smooth_step(f.bust, 0.80, y)),
          grown(s + kBellyFront * belly, kFrontShare) * deep,
          grown(s - kBellyBack * belly, kBackShare) * deep};
}

void PlacedFigure::place_trunk() {
  torso = copied(figure_.torso);
  for (LoftSection& r : torso) {
    const Scale s = trunk_scale(r.t);
    r.half *= s.width;
    r.front *= s.front;
    r.back *= s.back;
    r.t = height_of(r.t);
  }
  const double broad = shape_.of(measure::Measure::kShoulderWidth);
  yoke = copied(figure_.yoke);
  for (LoftSection& r : yoke) {
    const Scale s = trunk_scale(r.u);
    const double outer = smooth_step(0.05, 0.12, r.t);
    const double sleeve = grown(shape_.of(measure::Measure::kUpperArm), 0.55);
    r.half *= mix(1, sleeve, outer);
    r.front *= mix(s.front, sleeve, outer);
    r.back *= mix(s.back, sleeve, outer);
    r.u = height_of(r.u);
    r.t *= broad;
  }
}

void PlacedFigure::place_neck_and_head() {
  const double girth = shape_.of(measure::Measure::kNeck), size = shape_.head;
  neck = copied(figure_.neck);
  for (LoftSection& r : neck) {
    const double s = mix(grown(girth, 0.7), girth, smooth_step(0.82, 0.85, r.t));
    r.half *= s;
    r.front *= s;
    r.back *= s;
    r.v = mix(r.v, r.v * size, smooth_step(0.84, 0.90, r.t));
    r.t = height_of(r.t);
  }
  head = copied(figure_.head);
  for (LoftSection& r : head) {
    r.half *= size;
    r.front *= size;
    r.back *= size;
    r.v *= size;
    r.t = height_of(r.t);
  }
}

double PlacedFigure::arm_scale(double t) const {
  const double upper = shape_.of(measure::Measure::kUpperArm), thin = shape_.of(measure::Measure::kWrist);
  const Knot knots[] = {{-0.01, grown(upper, 0.7)},
                        {0.05, upper},
                        {0.11, upper},
                        {figure_.elbow, mix(upper, thin, 0.4)},
                        {0.22, mix(upper, thin, 0.5)},
                        {figure_.wrist - 0.02, thin}};
  return eased(knots, t);
}

void PlacedFigure::place_arm() {
  const double stretch = shape_.of(measure::Measure::kArmLength), longer = (stretch - 1) * figure_.wrist;
  const double raise = std::max(0.0, shape_.arm_sine - kRaisedArm) * kRaise;
  shoulder = {figure_.shoulder.x * shape_.of(measure::Measure::kShoulderWidth),
              height_of(figure_.shoulder.y) + raise, figure_.shoulder.z};
  along_arm = {shape_.arm_sine, -shape_.arm_cosine, 0};
  out_of_arm = {shape_.arm_cosine, shape_.arm_sine, 0};
  arm = copied(figure_.arm);
  hand = copied(figure_.hand);
  for (LoftSection& r : arm) {
    const double s = arm_scale(r.t);
    r.half *= s;
    r.front *= s;
    r.back *= s;
    r.t *= stretch;
  }
  const double fist = grown(shape_.of(measure::Measure::kWrist), 0.4);
  for (LoftSection& r : hand) {
    const double s = mix(arm_scale(r.t), fist, smooth_step(figure_.wrist, figure_.wrist + 0.02, r.t));
    r.half *= s;
    r.front *= s;
    r.back *= s;
    r.t += longer;
  }
  elbow = figure_.elbow * stretch;
  wrist = figure_.wrist * stretch;
  hand_end = figure_.hand_end + longer;
  thumb[0] = on_arm({-0.003, figure_.wrist + 0.016, 0.0300});
  thumb[1] = on_arm({-0.008, figure_.wrist + 0.050, 0.0405});
}

double PlacedFigure::leg_scale(double y) const {
  const Figure& f = figure_;
  const double thigh = shape_.of(measure::Measure::kThigh), calf = shape_.of(measure::Measure::kCalf);
  const Knot knots[] = {{0.06, grown(calf, 0.45)},
                        {0.15, calf},
                        {0.225, calf},
                        {f.knee, mix(calf, thigh, 0.45)},
                        {f.crotch - 0.07, thigh},
                        {f.crotch + 0.01, thigh},
                        {f.hip, shape_.of(measure::Measure::kHip)}};
  return eased(knots, y);
}

// A thicker leg moves outwards, so that the gap between them stays; wider hips take the legs along.
LoftSection PlacedFigure::leg_section(double y) const {
  LoftSection r = section_at(figure_.leg, y);
  const double s = leg_scale(y), hip = grown(shape_.of(measure::Measure::kHip), kWidthShare);
  r.u += std::max(1.04 * (s - 1) * r.half, 0.45 * (s - 1) * r.half + 0.45 * (hip - 1) * r.half);
  r.half *= s;
  r.front *= s;
  r.back *= s;
  const double free_legs = 1 - smooth_step(figure_.crotch - kThighsFree, figure_.crotch, y);
  r.u = std::max(r.u, free_legs * (r.half + kLegGap));
  r.t = height_of(y);
  return r;
}

void PlacedFigure::place_leg() {
  leg = copied(figure_.leg);
  for (LoftSection& r : leg) {
    const LoftSection s = leg_section(r.t);
    r.u = s.u;
    r.half = s.half;
    r.front = s.front;
    r.back = s.back;
    r.t = s.t;
  }
  foot = copied(figure_.foot);
  foot_origin = {leg[0].u, 0, leg[0].v};
}

// How far breasts reach down: no farther below the tape's place under them than ribs of this girth leave room
// for. Without this, thinner ribs under full breasts made the tape there longer, not shorter.
double PlacedFigure::breast_reach(double usual) const {
  const double above_tape = height_of(figure_.breast.centre.y) - tape_below_bust();
  const double ribs = 0.55 * shape_.of(measure::Measure::kBust) + 0.45 * shape_.of(measure::Measure::kWaist);
  const double fullness = shape_.of(measure::Measure::kUnderbust) / ribs;
  const double most = std::clamp(kUsualReach + kReachPerFullness * (fullness - kUsualFullness), 0.75, 1.6);
  return std::clamp(most * above_tape, 0.4 * usual, usual);
}

void PlacedFigure::place_masses() {
  const Figure& f = figure_;
  const Scale chest = trunk_scale(f.breast.centre.y), hips = trunk_scale(f.hip);
  const LoftSection ribs = section_at(f.torso, f.breast.centre.y);
  const double growth = shape_.of(measure::Measure::kBust) /
                        std::sqrt(std::sqrt(std::max(shape_.of(measure::Measure::kUnderbust), 0.1)));
  const double size = f.bust_share > 0 ? std::clamp(grown(growth, f.bust_share), 0.35, 2.2) : chest.width;
  bust = f.breast;
  bust.centre = {bust.centre.x * mix(chest.width, size, 0.25), height_of(bust.centre.y),
                 bust.centre.z + 0.6 * ribs.front * (chest.front - 1)};
  bust.low = bust.low * size;
  bust.high = bust.high * size;
  // Fuller breasts reach down little farther: the ribs below them stay the underbust's.
  if (f.bust_share > 0) bust.low.y = breast_reach(f.breast.low.y * grown(size, 0.25));
  buttock = f.buttock;
  const double s = shape_.of(measure::Measure::kHip);
  buttock.centre = {buttock.centre.x * hips.width, height_of(buttock.centre.y),
                    buttock.centre.z - 0.03 * (s - 1)};
  buttock.low = buttock.low * s;
  buttock.high = buttock.high * s;
  // Between crotch and waist they are as high as there is room.
  const double rise = (height_of(f.waist) - height_of(f.crotch)) / (f.waist - f.crotch);
  const double room = std::min(1.0, rise);
  buttock.low.y *= room;
  buttock.high.y *= room;
}

Vec3 PlacedFigure::on_trunk(Vec3 p) const {
  const Scale s = trunk_scale(p.y);
  const double middle = section_at(figure_.torso, p.y).v, deep = p.z - middle;
  return {p.x * s.width, height_of(p.y), middle + deep * (deep > 0 ? s.front : s.back)};
}

Vec3 PlacedFigure::on_head(Vec3 p) const { return {p.x * shape_.head, height_of(p.y), p.z * shape_.head}; }

Vec3 PlacedFigure::on_leg(Vec3 p) const {
  const LoftSection before = section_at(figure_.leg, p.y), after = leg_section(p.y);
  const double s = after.half / before.half;
  return {after.u + (p.x - before.u) * s, after.t, after.v + (p.z - before.v) * s};
}

Vec3 PlacedFigure::on_arm(Vec3 p) const {
  const double stretch = shape_.of(measure::Measure::kArmLength), s = arm_scale(p.y);
  const double along = p.y < figure_.wrist ? p.y * stretch : p.y + (stretch - 1) * figure_.wrist;
  const LoftSection axis = section_at(figure_.arm, p.y);
  return shoulder + along_arm * along + out_of_arm * (axis.u + (p.x - axis.u) * s) +
         Vec3{0, 0, axis.v + (p.z - axis.v) * s};
}

void PlacedFigure::place_strokes() {
  const auto add = [this](Stroke s) {
    const auto placed = [&](Vec3 p) {
      switch (s.carrier) {
        case Carrier::kTrunk:
          return on_trunk(p);
        case Carrier::kHead:
          return on_head(p);
        case Carrier::kLeg:
          return on_leg(p);
        case Carrier::kArm:
          return on_arm(p);
      }
      return p;
    };
    s.a = placed(s.a);
    s.b = placed(s.b);
    if (s.carrier == Carrier::kArm && s.radius < kFingerStroke) s.height *= shape_.face;
    if (s.carrier == Carrier::kHead) {
      s.radius *= shape_.head;
      s.height *= shape_.head * (s.radius < kFineStroke * shape_.head ? shape_.face : 1);
    }
    strokes.push_back(s);
  };
  for (const Stroke& s : figure_.strokes) add(s);
  for (const Stroke& s : common_strokes()) add(s);
}

BodyJoints PlacedFigure::joints() const {
  const auto in_arm = [&](double t) {
    const LoftSection r = section_at(arm, t);
    return shoulder + along_arm * t + out_of_arm * r.u + Vec3{0, 0, r.v};
  };
  const auto in_leg = [&](double y) {
    const LoftSection r = leg_section(y);
    return Vec3{r.u, r.t, r.v};
  };
  const LoftSection tip = hand.back(), base = section_at(figure_.neck, figure_.nape);
  BodyJoints j;
  j.head_top = {0, 1, head.back().v};
  j.chin = {0, height_of(figure_.chin), head.front().v + head.front().front};
  j.neck = {0, height_of(figure_.nape), base.v};
  j.shoulder = shoulder;
  j.elbow = in_arm(elbow);
  j.wrist = in_arm(wrist);
  j.hand_tip = shoulder + along_arm * tip.t + out_of_arm * tip.u + Vec3{0, 0, tip.v};
  j.hip = in_leg(figure_.hip);
  j.knee = in_leg(figure_.knee);
  j.ankle = in_leg(kAnkle);
  const double cosine = std::sqrt(1 - kToeOut * kToeOut);
  j.toe = foot_origin + Vec3{kToeOut, 0, cosine} * foot.back().t;
  return j;
}

}  // namespace toile::mannequin
