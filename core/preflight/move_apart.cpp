#include "core/preflight/move_apart.h"

#include <algorithm>

#include "core/collision/contacts.h"
#include "core/preflight/start_field.h"

namespace toile::preflight {

namespace {

constexpr double kLeastGap = 1e-3;     ///< m; what is nearer than this is moved apart
constexpr double kClearOfBody = 3e-3;  ///< m, after a repair
/// Coplanar pieces lock each other's vertices; 10 mm apart they can slide over each other.
constexpr double kClearOfCloth = 10e-3;  // m
constexpr double kSameMirror = 2e-3;     ///< m; mirror images may differ by so much
/// A shift that keeps left and right alike may be this much longer than one that does not.
constexpr double kWorthOfSymmetry = 3;
constexpr int kRounds = 4;
/// More than this is a heap of pieces without places, not a start with faults: nothing is moved.
constexpr std::size_t kMostConflicts = 48;
/// Moves that are tried in all, so that a hopeless start is refused in seconds.
constexpr int kMostTries = 2000;
/// m, the shifts tried in each direction.
constexpr double kShifts[] = {1e-3,  2e-3,  3e-3,  4e-3,  5e-3,  6e-3,  8e-3,  10e-3,
                              13e-3, 16e-3, 20e-3, 25e-3, 30e-3, 35e-3, 40e-3, 50e-3};

struct Conflict {
  Index piece = kNone;
  Opponent with;
  Nearness at;  ///< at the start as it was placed
};

struct PieceShift {
  Index piece;
  Vec3 by;
};
using Move = std::vector<PieceShift>;

Vec3 mirrored(Vec3 v) { return {-v.x, v.y, v.z}; }

class Mover {
 public:
  explicit Mover(StartField& field) : field_(field) {
    for (Index i = 0; i < field.piece_count(); ++i) partner_.push_back(partner_of(i));
  }

  /// Those that there are, kMostConflicts at most.
  std::vector<Conflict> conflicts() const {
    std::vector<Conflict> found;
    for (Index i = 0; i < field_.piece_count() && found.size() < kMostConflicts; ++i) {
      for (const Opponent& o : field_.neighbours(i, {}, kLeastGap)) {
        if ((!o.is_body && o.index < i) || found.size() >= kMostConflicts) continue;
        const Nearness near = field_.nearness(i, {}, o, kLeastGap, 0);
        if (near.gap < kLeastGap) found.push_back({i, o, near});
      }
      const Nearness itself = field_.to_itself(i);
      if (itself.crosses || itself.gap < collision::kContactFloor) found.push_back({i, {false, i}, itself});
    }
    return found;
  }

  /// Tries to clear all conflicts, small pieces first: they move, and large ones stay.
  void clear_all() {
    for (int round = 0; round < kRounds; ++round) {
      std::vector<Conflict> open = conflicts();
      std::stable_sort(open.begin(), open.end(), [&](const Conflict& a, const Conflict& b) {
        return a.with.is_body != b.with.is_body ? a.with.is_body : size_of(a) < size_of(b);
      });
      bool moved = false;
      for (const Conflict& c : open) moved |= clear(c);
      if (!moved) return;
    }
  }

 private:
  double size_of(const Conflict& c) const {
    return c.with.is_body ? field_.area(c.piece) : std::min(field_.area(c.piece), field_.area(c.with.index));
  }

  Index partner_of(Index i) const {
    const auto alike = [](Vec3 a, Vec3 b) {
      return std::abs(a.x - b.x) < kSameMirror && std::abs(a.y - b.y) < kSameMirror &&
             std::abs(a.z - b.z) < kSameMirror;
    };
    if (std::abs(field_.centre(i).x) < kSameMirror) return i;
    for (Index j = 0; j < field_.piece_count(); ++j) {
      if (j != i && alike(field_.centre(j), mirrored(field_.centre(i))) &&
          alike(field_.half_size(j), field_.half_size(i)))
        return j;
    }
    return kNone;
  }

  /// Clears one conflict if it is still there; true when something moved.
  bool clear(const Conflict& c) {
    if (!c.with.is_body && c.with.index == c.piece) return false;  // no shift parts a piece from itself
    if (field_.nearness(c.piece, {}, c.with, kLeastGap, kLeastGap).gap >= kLeastGap) return false;
    for (const double clearance : {c.with.is_body ? kClearOfBody : kClearOfCloth, 2 * kLeastGap}) {
      Move best;
      double cost = 1e9;
      for (const Vec3 way : ways(c)) {
        for (const Move& unit : moves_along(c, way)) try_along(c, unit, clearance, best, cost);
      }
      if (best.empty()) continue;
      for (const PieceShift& s : best) field_.set_shift(s.piece, field_.shift(s.piece) + s.by);
      return true;
    }
    return false;
  }

  /// Directions worth trying, the natural ones first.
  std::vector<Vec3> ways(const Conflict& c) const {
    const Vec3 n = field_.normal(c.piece);
    std::vector<Vec3> out{n, -n};
    if (!c.with.is_body) {
      const Vec3 m = field_.normal(c.with.index);
      const Vec3 apart = normalized(field_.centre(c.piece) - field_.centre(c.with.index));
      out.insert(out.end(), {m, -m, apart});
    }
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      out.push_back(axis);
      out.push_back(-axis);
    }
    return out;
  }

  /// The unit moves along `way`: of the piece alone, of its opponent alone the other way, of both by halves.
  std::vector<Move> moves_along(const Conflict& c, Vec3 way) const {
    if (c.with.is_body) return {with_partners({{c.piece, way}})};
    const Index p = c.piece, q = c.with.index;
    if (partner_[p] == q) return {{{p, way * 0.5}, {q, way * -0.5}}};
    return {with_partners({{p, way}}), with_partners({{q, -way}}),
            with_partners({{p, way * 0.5}, {q, way * -0.5}})};
  }

  /// Mirror images move as mirror images; a piece in the middle stays there.
  Move with_partners(Move move) const {
    const Move asked = move;
    for (PieceShift& s : move) {
      if (partner_[s.piece] == s.piece) s.by.x = 0;
    }
    for (const PieceShift& s : asked) {
      const Index other = partner_[s.piece];
      const bool moves =
          std::any_of(asked.begin(), asked.end(), [&](const PieceShift& t) { return t.piece == other; });
      if (other != kNone && !moves) move.push_back({other, mirrored(s.by)});
    }
    return move;
  }

  /// Whether the move breaks the likeness of left and right.
  bool breaks_symmetry(const Move& move) const {
    return std::any_of(move.begin(), move.end(), [&](const PieceShift& s) {
      const Index other = partner_[s.piece];
      if (other == kNone) return false;
      const auto theirs =
          std::find_if(move.begin(), move.end(), [&](const PieceShift& t) { return t.piece == other; });
      return theirs == move.end() || length(theirs->by - mirrored(s.by)) > 1e-6;
    });
  }

  void try_along(const Conflict& c, const Move& unit, double clearance, Move& best, double& cost) {
    double longest = 0;
    for (const PieceShift& s : unit) longest = std::max(longest, length(s.by));
    if (longest < 0.3) return;  // what is left of the way leads nowhere
    const double price = breaks_symmetry(unit) ? kWorthOfSymmetry : 1;
    for (const double shift : kShifts) {
      if (price * shift * longest >= cost || ++tries_ > kMostTries) return;
      Move move = unit;
      for (PieceShift& s : move) s.by = s.by * shift;
      if (!clears(c, move, clearance)) continue;
      best = std::move(move);
      cost = price * shift * longest;
      return;
    }
  }

  static Vec3 shift_in(const Move& move, Index piece) {
    for (const PieceShift& s : move) {
      if (s.piece == piece) return s.by;
    }
    return {};
  }

  /// Whether the move clears the conflict and brings no moved piece nearer than a millimetre to anything
  /// else.
  bool clears(const Conflict& c, const Move& move, double clearance) const {
    const auto gap = [&](Index p, const Opponent& o, double enough) {
      const Vec3 relative = shift_in(move, p) - (o.is_body ? Vec3{} : shift_in(move, o.index));
      return field_.nearness(p, relative, o, enough, enough).gap;
    };
    if (gap(c.piece, c.with, clearance) < clearance) return false;
    for (const PieceShift& s : move) {
      for (const Opponent& o : field_.neighbours(s.piece, s.by, kLeastGap + 0.1)) {
        const bool same = (s.piece == c.piece && o == c.with) ||
                          (!c.with.is_body && !o.is_body && s.piece == c.with.index && o.index == c.piece);
        if (same || gap(s.piece, o, kLeastGap) >= kLeastGap) continue;
        const Nearness before = field_.nearness(s.piece, {}, o, kLeastGap, 0);
        const Vec3 relative = shift_in(move, s.piece) - (o.is_body ? Vec3{} : shift_in(move, o.index));
        const Nearness then = field_.nearness(s.piece, relative, o, kLeastGap, 0);
        if (then.gap < before.gap || (then.crosses && !before.crosses)) return false;
      }
    }
    return true;
  }

  StartField& field_;
  int tries_ = 0;
  std::vector<Index> partner_;  ///< mirror image of each piece: another, itself in the middle, or kNone
};

std::string name_of(const Opponent& o, const pattern::Pattern& pattern, std::span<const BodyProbe> probes) {
  return o.is_body ? "body " + probes[o.index].body().id : "piece " + pattern.panels[o.index].id;
}

Concern concern_of(const Opponent& o, const pattern::Pattern& pattern, std::span<const BodyProbe> probes) {
  return o.is_body ? body_named(probes[o.index].body().id) : piece_named(pattern.panels[o.index].id);
}

/// What was found, in words, as of a thing of the present.
Finding described(const Conflict& c, const pattern::Pattern& pattern, std::span<const BodyProbe> probes) {
  const std::string other = name_of(c.with, pattern, probes);
  const bool itself = !c.with.is_body && c.with.index == c.piece;
  Finding f;
  f.place = c.at.place;
  f.about = {piece_named(pattern.panels[c.piece].id)};
  if (!itself) f.about.push_back(concern_of(c.with, pattern, probes));
  if (itself) {
    f.kind = c.at.crosses ? FindingKind::kCrossesCloth : FindingKind::kTouches;
    f.message =
        "the piece passes through itself or lies on itself where it is placed; a larger radius parts it";
  } else if (c.at.crosses) {
    f.kind = c.with.is_body ? FindingKind::kCrossesBody : FindingKind::kCrossesCloth;
    f.message = c.with.is_body
                    ? "the piece passes through " + other + " where it is placed; move it clear of it"
                    : "two pieces pass through each other where they are placed; move them apart";
  } else if (c.at.inside) {
    f.kind = FindingKind::kInsideBody;
    f.message = "the piece lies inside " + other + "; place it outside, before the skin";
  } else if (c.at.gap < collision::kContactFloor) {
    f.kind = FindingKind::kTouches;
    f.message = "the piece touches " + other + " where it is placed; leave a millimetre or more";
  } else {
    f.kind = FindingKind::kGap;
    f.message = "the piece is placed only " + length_text(c.at.gap) + " from " + other +
                "; leave a millimetre or more, or it may stick there";
  }
  f.severity = traits_of(f.kind).usual;
  return f;
}

std::string moved_text(Index piece, const StartField& field, const pattern::Pattern& pattern) {
  const Vec3 s = field.shift(piece);
  return length(s) > 0 ? "piece " + pattern.panels[piece].id + " by " + length_text(length(s)) : "";
}

void tell_repair(Finding& f, const Conflict& c, const StartField& field, const pattern::Pattern& pattern) {
  f.repaired = true;
  f.severity = f.kind == FindingKind::kGap ? Severity::kNote : Severity::kWarning;
  const std::string first = moved_text(c.piece, field, pattern);
  const std::string second = c.with.is_body ? "" : moved_text(c.with.index, field, pattern);
  f.message += "; for this drape " + first + (!first.empty() && !second.empty() ? " and " : "") + second +
               (first.empty() || second.empty() ? " was" : " were") + " moved clear";
}

void apply_shifts(const StartField& field, sewing::Assembly& assembly) {
  for (Index v = 0; v < assembly.garment.vertex_count(); ++v) {
    assembly.positions[v] += field.shift(assembly.garment.panel_of_vertex[v]);
  }
}

}  // namespace

void move_apart(const pattern::Pattern& pattern, std::span<const BodyProbe> probes,
                sewing::Assembly& assembly, Findings& findings) {
  StartField field(assembly, probes);
  Mover mover(field);
  const std::vector<Conflict> before = mover.conflicts();
  if (before.empty()) return;
  if (before.size() < kMostConflicts) mover.clear_all();
  const std::vector<Conflict> after = mover.conflicts();
  for (const Conflict& c : before) {
    Finding f = described(c, pattern, probes);
    const bool open = std::any_of(after.begin(), after.end(),
                                  [&](const Conflict& a) { return a.piece == c.piece && a.with == c.with; });
    if (!open) tell_repair(f, c, field, pattern);
    findings.push_back(std::move(f));
  }
  apply_shifts(field, assembly);
}

}  // namespace toile::preflight
