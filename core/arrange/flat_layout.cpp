#include "core/arrange/flat_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/arrange/layout_measures.h"
#include "core/arrange/piece_image.h"
#include "core/arrange/upper_end.h"
#include "core/geometry/polygon2.h"

namespace toile::arrange {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSnap = 25 * kPi / 180;  ///< pieces lie along their grain unless seams turn them by more
constexpr int kSweeps = 200;
constexpr double kFolded = 0.25, kTooFarAside = 0.5;  ///< against lying on a neighbour

Vec2 flipped(Vec2 p) { return {-p.x, p.y}; }

/// The smaller angle from a to b, -π to π.
double turn_between(double a, double b) { return std::remainder(b - a, 2 * kPi); }

FlatMove mirror_at_zero() {
  FlatMove m;
  m.mirrored = true;
  return m;
}

/// One piece with its mirror image, or one that is its own, or one alone.
struct Unit {
  Index piece = kNone, partner = kNone;
  FlatMove onto;  ///< the partner's plane → the piece's; of a piece that is its own image, the mirroring
};

class Layer {
 public:
  Layer(const GarmentGraph& graph, const std::vector<Index>& members, FlatLayout& layout)
      : graph_(graph), layout_(layout), is_member_(graph.pieces.size(), false) {
    for (const Index m : members) is_member_[m] = true;
  }

  const GarmentPiece& piece(Index p) const { return graph_.pieces[p]; }
  bool is_mirrored(Index p, int face) const { return piece(p).outside * face < 0; }

  void find_units(const std::vector<Index>& members, bool with_mirrors) {
    std::vector<bool> taken(graph_.pieces.size(), false);
    for (const Index p : members) {
      if (taken[p]) continue;
      Unit unit{p, kNone, {}};
      if (with_mirrors) pair_up(members, taken, unit);
      taken[p] = true;
      if (unit.partner != kNone) taken[unit.partner] = true;
      layout_.partner[p] = unit.partner;
      if (unit.partner != kNone) layout_.partner[unit.partner] = p;
      units_.push_back(unit);
    }
  }

  void grow_from(Index root, const FlatMove& pose, int face) {
    place(unit_of(root), root, pose, face);
    for (std::size_t round = 0; round < units_.size(); ++round) {
      const Unit* next = nullptr;
      std::size_t most = 0;
      for (const Unit& unit : units_) {
        if (layout_.has(unit.piece)) continue;
        if (const std::size_t n = ties_to_placed(unit).points.size(); n > most) {
          most = n;
          next = &unit;
        }
      }
      if (next == nullptr) return;
      place_by_seams(*next);
    }
  }

  /// Shifts everything but the root until sewn edges lie on each other as well as they all can.
  void relax(Index root) {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (const Unit& unit : units_) {
        if (!layout_.has(unit.piece)) continue;
        Vec2 by = pull_on(unit);
        if (unit.piece == root) by.y = 0;
        shift(unit, by);
      }
    }
  }

  /// Turn of the root at which its grain, or its own axis, stands upright and its upper end is up.
  double upright(Index root, int face) const {
    const Vec2 up = upper_end(graph_, layout_.partner, root);
    double best = 0, most = -HUGE_VAL;
    for (const double angle : upright_angles(unit_of(root), face)) {
      const double y = turn_by(angle, is_mirrored(root, face)).turned(up).y;
      if (y > most) {
        most = y;
        best = angle;
      }
    }
    return best;
  }

  /// The root's pose on the sheet. A piece without an image cannot be centred by it: what of it is sewn to
  /// pieces of the other hand lies in the middle, else its own middle does. Where it is drawn says nothing,
  /// and pieces that are their own images come to the middle whatever it is.
  FlatMove root_pose(Index root, int face) const {
    FlatMove pose = turn_by(upright(root, face), is_mirrored(root, face));
    if (layout_.partner[root] == kNone) pose.t.x = -middle_of(graph_, root, pose);
    return pose;
  }

  std::vector<Unit>& units() { return units_; }

  void shift(const Unit& unit, Vec2 by) {
    if (unit.partner == unit.piece) by.x = 0;
    layout_.pose[unit.piece].t = layout_.pose[unit.piece].t + by;
    follow(unit);
  }

 private:
  struct Pulls {
    std::vector<Vec2> points, targets;  ///< in the unit's first piece's plane; on the sheet
    int faces = 0;                      ///< sum of the faces that they lie on
  };

  const Unit& unit_of(Index p) const {
    return *std::find_if(units_.begin(), units_.end(),
                         [&](const Unit& u) { return u.piece == p || u.partner == p; });
  }

  /// Another piece that is this one's image and not sewn as its front or back; else itself.
  void pair_up(const std::vector<Index>& members, const std::vector<bool>& taken, Unit& unit) {
    const GarmentPiece& mine = piece(unit.piece);
    // Which of several equal gores mirrors which only their seams can tell: they lie where these lead.
    if (mine.hand == 0 && count_alike(members, unit.piece) > 2) return;
    for (const Index q : members) {
      if (q == unit.piece || taken[q]) continue;
      const GarmentPiece& other = piece(q);
      const bool fits = other.face == mine.face && other.cover == mine.cover &&
                        (other.hand == -mine.hand || other.hand == 0 || mine.hand == 0);
      if (!fits) continue;
      // On one sheet, both right side out or both not, a mirror image is cut as one.
      const auto onto = image_on(graph_, q, unit.piece);
      if (onto && can_be_images(unit.piece, q)) {
        unit.partner = q;
        unit.onto = *onto;
        return;
      }
    }
    if (mine.hand != 0) return;
    const std::vector<FlatMove> own = own_mirrors(mine);
    if (own.empty()) return;
    // Of several axes the one that stands nearest to upright as the piece is drawn.
    const auto tilt = [](const FlatMove& m) { return std::abs(std::sin(m.angle() / 2)); };
    unit.partner = unit.piece;
    unit.onto = *std::min_element(own.begin(), own.end(),
                                  [&](const FlatMove& a, const FlatMove& b) { return tilt(a) < tilt(b); });
  }

  /// Pieces of one shape that are worn on one face, as far as names tell; the piece itself counts.
  int count_alike(const std::vector<Index>& members, Index p) const {
    return static_cast<int>(std::count_if(members.begin(), members.end(), [&](Index q) {
      const bool same =
          piece(q).face == piece(p).face && piece(q).cover == piece(p).cover && piece(q).hand == 0;
      return q == p || (same && (lay_on(piece(q), piece(p), false) || lay_on(piece(q), piece(p), true)));
    }));
  }

  /// Two equal pieces without names of their faces may be a front and its back as well: those are sewn along
  /// most of their outlines, or at both sides.
  bool can_be_images(Index p, Index q) const {
    if (piece(p).face != 0 || piece(p).hand != 0) return true;
    if (sewn_around(graph_, p, q)) return false;
    std::size_t between = 0, all = 0;
    for (const GarmentTie& tie : graph_.ties) {
      const bool on_p = tie.a == p || tie.b == p;
      if (on_p) ++all;
      if (on_p && (tie.a == q || tie.b == q)) ++between;
    }
    return all == 0 || 2 * between < all;
  }

  /// Angles at which the grain lies along the sheet's axes; of a piece that is its own image, at which its
  /// axis stands upright.
  std::vector<double> upright_angles(const Unit& unit, int face) const {
    const bool mirrored = is_mirrored(unit.piece, face);
    std::vector<double> angles;
    if (unit.partner == unit.piece) {
      const double across = unit.onto.angle() / 2;  // direction of the mirror's normal
      const Vec2 normal = turn_by(0, mirrored).turned({std::cos(across), std::sin(across)});
      const double at = -std::atan2(normal.y, normal.x);
      return {at, at + kPi};
    }
    const Vec2 grain = turn_by(0, mirrored).turned(piece(unit.piece).grain);
    const double at = kPi / 2 - std::atan2(grain.y, grain.x);
    angles.reserve(4);
    for (int k = 0; k < 4; ++k) angles.push_back(at + k * kPi / 2);
    return angles;
  }

  Vec2 on_sheet(Index p, Vec2 at) const { return layout_.pose[p](at); }

  /// The unit's ties to what is placed; those between its own two left out.
  Pulls ties_to_placed(const Unit& unit) const {
    Pulls pulls;
    for (const GarmentTie& tie : graph_.ties) {
      for (const bool first : {true, false}) {
        const Index mine = first ? tie.a : tie.b, other = first ? tie.b : tie.a;
        if (mine != unit.piece && mine != unit.partner) continue;
        if (other == unit.piece || other == unit.partner || !is_member_[other] || !layout_.has(other))
          continue;
        const Vec2 at = first ? tie.at_a : tie.at_b;
        const Vec2 target = on_sheet(other, first ? tie.at_b : tie.at_a);
        const bool image = mine != unit.piece;
        pulls.points.push_back(image ? unit.onto(at) : at);
        pulls.targets.push_back(image ? flipped(target) : target);
        pulls.faces += layout_.face[other];
      }
    }
    return pulls;
  }

  FlatMove fitted(const Unit& unit, int face, const Pulls& pulls) const {
    const FlatMove free = fit_move(pulls.points, pulls.targets, is_mirrored(unit.piece, face)).move;
    double nearest = free.angle();
    double least = HUGE_VAL;
    for (const double angle : upright_angles(unit, face)) {
      if (const double d = std::abs(turn_between(free.angle(), angle)); d < least) {
        least = d;
        nearest = angle;
      }
    }
    if (least > kSnap && unit.partner != unit.piece) return free;
    FlatMove snapped = turn_by(nearest, free.mirrored);
    Vec2 sum;
    for (std::size_t i = 0; i < pulls.points.size(); ++i) {
      sum = sum + pulls.targets[i] - snapped.turned(pulls.points[i]);
    }
    snapped.t = sum * (1 / static_cast<double>(pulls.points.size()));
    return snapped;
  }

  /// How much of the piece would lie on others of its sheet, 0 to 1.
  double covered(Index p, int face, const FlatMove& pose) const {
    int hits = 0, count = 0;
    const GarmentPiece& mine = piece(p);
    for (std::size_t i = 0; i < mine.outline.size(); i += 2) {
      const Vec2 at = pose(mine.centroid + (mine.outline[i] - mine.centroid) * 0.7);
      ++count;
      for (std::size_t q = 0; q < graph_.pieces.size(); ++q) {
        if (layout_.face[q] != face || static_cast<Index>(q) == p) continue;
        if (geometry::contains(outline_on_sheet(graph_.pieces[q], layout_.pose[q]), at)) {
          ++hits;
          break;
        }
      }
    }
    return count > 0 ? static_cast<double>(hits) / count : 0;
  }

  /// A quarter of the way around that pieces of this cover make: what lies farther aside belongs on the other
  /// sheet.
  double quarter_around(Cover cover) const {
    double around = 0;
    for (std::size_t p = 0; p < graph_.pieces.size(); ++p) {
      if (!is_member_[p] || graph_.pieces[p].cover != cover) continue;
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const Vec2 q : graph_.pieces[p].outline) {
        const double across = cross(graph_.pieces[p].grain, q);
        low = std::min(low, across);
        high = std::max(high, across);
      }
      around += high - low;
    }
    return around / 4;
  }

  /// Worn where its name says, or else on the sheet where it covers nothing, lies within the garment's
  /// breadth and has its stitches near.
  void place_by_seams(const Unit& unit) {
    const Pulls pulls = ties_to_placed(unit);
    const int told = piece(unit.piece).face;
    const double quarter = quarter_around(piece(unit.piece).cover);
    int best_face = told;
    double least = HUGE_VAL;
    for (const int face : {1, -1}) {
      if (told != 0 && face != told) continue;
      const FlatMove pose = fitted(unit, face, pulls);
      double away = 0;
      for (std::size_t i = 0; i < pulls.points.size(); ++i)
        away += length(pose(pulls.points[i]) - pulls.targets[i]);
      double demerit =
          covered(unit.piece, face, pose) + away / (quarter * static_cast<double>(pulls.points.size()));
      if (pulls.faces * face < 0) demerit += kFolded;
      if (std::abs(pose(piece(unit.piece).centroid).x) > 1.05 * quarter) demerit += kTooFarAside;
      if (demerit < least - 0.02) {
        least = demerit;
        best_face = face;
      }
    }
    place(unit, unit.piece, fitted(unit, best_face, pulls), best_face);
  }

  void place(const Unit& unit, Index p, const FlatMove& pose, int face) {
    layout_.pose[p] = pose;
    layout_.face[p] = face;
    if (unit.partner != kNone && p == unit.partner && p != unit.piece) {
      layout_.pose[unit.piece] = after(mirror_at_zero(), after(pose, inverse_image(unit)));
      layout_.face[unit.piece] = face;
    }
    follow(unit);
    centre(unit);
  }

  /// Seams between a piece and its image lie in the middle.
  void centre(const Unit& unit) {
    double sum = 0;
    int count = 0;
    for (const GarmentTie& tie : graph_.ties) {
      if (!is_own(tie, unit)) continue;
      sum += layout_.pose[unit.piece](tie.a == unit.piece ? tie.at_a : tie.at_b).x;
      ++count;
    }
    if (count > 0) shift(unit, {-sum / count, 0});
  }

  static bool is_own(const GarmentTie& tie, const Unit& unit) {
    return unit.partner != unit.piece &&
           ((tie.a == unit.piece && tie.b == unit.partner) || (tie.b == unit.piece && tie.a == unit.partner));
  }

  /// The first piece's plane → the partner's.
  FlatMove inverse_image(const Unit& unit) const {
    FlatMove inverse;
    inverse.mirrored = unit.onto.mirrored;
    inverse.c = unit.onto.c;
    inverse.s = unit.onto.mirrored ? unit.onto.s : -unit.onto.s;
    inverse.t = -inverse.turned(unit.onto.t);
    return inverse;
  }

  /// The partner to where the first piece's image is; a piece that is its own image to the middle.
  void follow(const Unit& unit) {
    FlatMove& pose = layout_.pose[unit.piece];
    if (unit.partner == unit.piece) {
      const Vec2 middle =
          (pose(piece(unit.piece).centroid) + pose(unit.onto(piece(unit.piece).centroid))) * 0.5;
      pose.t.x -= middle.x;
    } else if (unit.partner != kNone) {
      layout_.pose[unit.partner] = after(mirror_at_zero(), after(pose, unit.onto));
      layout_.face[unit.partner] = layout_.face[unit.piece];
    }
  }

  /// The mean way to its partners of stitches.
  Vec2 pull_on(const Unit& unit) const {
    const Pulls pulls = ties_to_placed(unit);
    Vec2 sum;
    for (std::size_t i = 0; i < pulls.points.size(); ++i) {
      sum = sum + pulls.targets[i] - layout_.pose[unit.piece](pulls.points[i]);
    }
    std::size_t count_x = pulls.points.size(), count_y = count_x;
    if (unit.partner != kNone && unit.partner != unit.piece) {
      // Stitches between a piece and its image want to lie at x = 0.
      for (const GarmentTie& tie : graph_.ties) {
        if (!is_own(tie, unit)) continue;
        const Vec2 at = tie.a == unit.piece ? tie.at_a : tie.at_b;
        sum.x -= layout_.pose[unit.piece](at).x;
        ++count_x;
      }
    }
    return {count_x > 0 ? sum.x / static_cast<double>(count_x) : 0,
            count_y > 0 ? sum.y / static_cast<double>(count_y) : 0};
  }

  const GarmentGraph& graph_;
  FlatLayout& layout_;
  std::vector<bool> is_member_;
  std::vector<Unit> units_;
};

/// Where the piece goes that is placed first: in front, unless a name puts it behind, or names put others in
/// front and none behind.
int face_of_root(const GarmentGraph& graph, const std::vector<Index>& members, Index root) {
  const auto any = [&](int face) {
    return std::any_of(members.begin(), members.end(),
                       [&](Index p) { return graph.pieces[p].face * face > 0; });
  };
  const int told = graph.pieces[root].face;
  return told < 0 || (told == 0 && any(1) && !any(-1)) ? -1 : 1;
}

FlatLayout try_trunk(const GarmentGraph& graph, const std::vector<Index>& members) {
  FlatLayout layout = empty_layout(graph.pieces.size());
  Layer layer(graph, members, layout);
  layer.find_units(members, true);
  const Index root = root_of_trunk(graph, members);
  const int face = face_of_root(graph, members, root);
  layer.grow_from(root, layer.root_pose(root, face), face);
  layer.relax(root);
  stand_in_the_middle(graph, members, layout);
  return layout;
}

/// Laid out with the wearer's left on the left.
FlatLayout lay_out_handed(GarmentGraph& graph, const std::vector<Index>& members) {
  FlatLayout layout = try_trunk(graph, members);
  if (hands_right(graph, layout) >= 0) return layout;
  for (GarmentPiece& piece : graph.pieces) piece.outside = -piece.outside;
  return try_trunk(graph, members);
}

}  // namespace

FlatLayout lay_out_trunk(GarmentGraph& graph, const std::vector<Index>& members) {
  constexpr double kLower = 2e-3;  // m
  if (members.empty()) return empty_layout(graph.pieces.size());
  FlatLayout layout = lay_out_handed(graph, members);
  const bool told =
      std::any_of(members.begin(), members.end(), [&](Index p) { return graph.pieces[p].face != 0; });
  if (told || front_is_lower(graph, layout) > -kLower) return layout;
  // The larger piece is no sure front: backs often are.
  for (const Index p : members) graph.pieces[p].face = -layout.face[p];
  return lay_out_handed(graph, members);
}

void lay_out_limb(const GarmentGraph& graph, const std::vector<Index>& members, Index root,
                  const FlatMove& root_pose, int root_face, FlatLayout& layout) {
  Layer layer(graph, members, layout);
  layer.find_units(members, false);
  layer.grow_from(root, root_pose, root_face);
}

}  // namespace toile::arrange
