#pragma once
// Runs sewn to runs, and how much the result looks like a garment: cloth that lies smoothly around the points
// where pieces meet, a surface with two sides, openings and no handles.

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/pattern/seams/model.h"

namespace toile::seams {

struct SeamGluing {
  std::vector<Index> partner;  ///< of each run; kNone where it is free
  /// What speaks for each sewn run's pair by itself, when it is sewn against the outlines' direction and
  /// along it; the same for both runs of a pair.
  std::vector<std::array<double, 2>> merit;
  std::vector<char> turned;  ///< of each panel: sewn as if the drawing showed its wrong side

  void sew(Index a, Index b, const std::array<double, 2>& value) {
    partner[a] = b;
    partner[b] = a;
    merit[a] = merit[b] = value;
  }
  void undo(Index a) {
    if (partner[a] == kNone) return;
    partner[partner[a]] = kNone;
    partner[a] = kNone;
  }
  bool along(const SeamModel& m, Index a, Index b) const {
    return turned[m.runs[a].panel] != turned[m.runs[b].panel];
  }
};

SeamGluing nothing_sewn(const SeamModel& model);

struct GluingSettings {
  bool sides_known = false;  ///< whether all pieces are drawn from their right side
  /// One per panel: which of them the drawing probably shows from the other side. None: all from one.
  std::vector<char> turned = {};
};

/// What speaks for sewing a to b, apart from what else is sewn: their lengths (unless `lengths` is false),
/// shapes, notches, heights along the grain, and names; against and along the outlines' direction.
std::array<double, 2> pair_merit(const SeamModel& model, Index a, Index b, bool lengths = true);

/// Whether the kinds of the pieces, or a front that opens, keep the two runs apart: what no other part of a
/// seam makes good.
bool never_sewn(const SeamModel& model, Index a, Index b);

/// What a difference of lengths says: 6 for equal ones, 0 at a sixth.
double length_merit(double a, double b);

/// Says what garments are worth, one after the other, without asking for memory. The model must outlive it.
class GluingJudge {
 public:
  GluingJudge(const SeamModel& model, const GluingSettings& settings);
  /// The merit of all that is sewn together: of its pairs, and of the surface that comes out.
  double merit(const SeamGluing& gluing);

 private:
  /// What is asked of a run in every garment, close together in memory.
  struct Run {
    Index next, panel, mirror;
    Index before;         ///< the part of the same edge that ends at a notch where it begins; kNone
    bool cut, cut_start;  ///< one end, or the start, is no corner of the drawing
    bool round;           ///< turns by more than an opening does, and is no hem
    bool smooth;          ///< the outline runs on smoothly at its start
    double angle, length, share;
    bool torso, trim;  ///< its piece is of the bodice; a band, cuff or collar
    int half, face;    ///< half_of() it, and of its piece
    int level;         ///< +1 it faces up along the grain, -1 down; 0 neither, or names tell what hangs where
  };
  struct PointSums {
    double angle = 0;
    int corners = 0, free_ends = 0;
    bool cut = false, crotch = false;
    bool front = false, back = false, other = false;  ///< a corner is of the bodice's front, back, of neither
  };
  struct Gather {
    double ratio;
    Index ends[2];
    Index run;
  };
  bool along(const SeamGluing& g, Index a, Index b) const {
    return g.turned[runs_[a].panel] != g.turned[runs_[b].panel];
  }
  void join_corners(const SeamGluing& g);
  double pairs(const SeamGluing& g) const;
  bool is_parted(const SeamGluing& g, Index r) const;
  double sides(const SeamGluing& g) const;
  int second_lines_in_rows(const SeamGluing& g) const;
  double limbs(const SeamGluing& g);
  double straps(const SeamGluing& g);
  double middles(const SeamGluing& g);
  double levels(const SeamGluing& g);
  double free_edges(const SeamGluing& g);
  double points(const SeamGluing& g);
  double surface(const SeamGluing& g);
  double narrow_borders(const SeamGluing& g);
  double gathers(const SeamGluing& g);

  const SeamModel& m_;
  GluingSettings settings_;
  std::vector<Run> runs_;
  DisjointSets corners_, parts_, borders_;
  std::vector<char> is_whole_;  ///< of each panel of a nameless skirt: it is its own mirror image
  std::vector<Index> root_;     ///< of each corner, once they are joined
  std::vector<PointSums> sums_;
  std::vector<Gather> gathers_;
  std::vector<Index> free_at_;
  std::vector<Index> mate_;  ///< of each panel of a sleeve: the first of another that it is sewn to
  std::vector<Index> held_;  ///< of each panel of a strap: the first run that it is sewn to
  std::vector<int> lines_;
  std::vector<std::array<Index, 2>> hangs_;  ///< panels: the one hangs from the other
  std::vector<char> open_, sewn_;            ///< of each panel: an edge of it is free, is sewn
  double least_border_;                      ///< mm, of the bodice alone
  std::vector<double>
      border_length_;  ///< of the free runs that come together; nothing where not all are the bodice's
  int points_ = 0;
};

/// The same for one garment.
double gluing_merit(const SeamModel& model, const SeamGluing& gluing, const GluingSettings& settings);

/// The free borders: each a cycle of runs as one walks along it with the cloth at the left (seen from the
/// right side).
std::vector<std::vector<Index>> free_borders(const SeamModel& model, const SeamGluing& gluing);

/// Whether the runs, in the order in which one walks along them with the cloth at the left, would be a whole
/// border if they were free: what else is sewn brings the end of the last to the start of the first.
bool is_whole_border(const SeamModel& model, SeamGluing gluing, const std::vector<Index>& runs);

}  // namespace toile::seams
