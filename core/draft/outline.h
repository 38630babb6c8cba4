#pragma once
// Drawing a piece edge by edge, as one does with ruler and French curve.

#include <string>
#include <vector>

#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile::draft {

/// The line that is drawn so far; all in millimetres. Edges run counter-clockwise around the piece, y up. A
/// call with a name begins an edge, one without goes on with the edge before it.
class Outline {
 public:
  explicit Outline(Vec2 start) : at_(start) {}

  Outline& line(const std::string& edge, Vec2 to);
  /// A cubic with its two handles' ends.
  Outline& curve(const std::string& edge, Vec2 handle, Vec2 other_handle, Vec2 to);
  Outline& line(Vec2 to);
  Outline& curve(Vec2 handle, Vec2 other_handle, Vec2 to);
  /// A mark on the newest edge, `along` mm from its start; negative: from its end.
  Outline& notch(double along);

  Vec2 at() const { return at_; }
  const std::vector<pattern::PanelEdge>& edges() const { return edges_; }
  const std::vector<Vec2>& marks() const { return marks_; }

 private:
  Outline& add(const pattern::CubicBezier& curve);

  Vec2 at_;
  std::vector<pattern::PanelEdge> edges_;
  std::vector<Vec2> marks_;
};

/// The piece that a closed outline is. REQUIRES that it ends where it began.
pattern::Panel piece(const std::string& id, const Outline& outline);

/// Edges bottom, right, top, left; the lower edge's middle at the origin.
pattern::Panel rectangle(const std::string& id, double width, double height);

/// The whole piece of its right half (x >= 0), which is drawn from the middle line's lower end around to its
/// upper end. The first and the last edge go on across the middle under their own names; of the others those
/// at x > 0 are called EDGE_plus by the name that `plus` is, their mirror images EDGE_minus. REQUIRES both
/// ends at x = 0.
pattern::Panel unfolded(const std::string& id, const Outline& half, const std::string& plus,
                        const std::string& minus);

/// The piece turned over: x becomes -x, its outline still counter-clockwise. Edges keep their names.
pattern::Panel mirrored(const pattern::Panel& panel, const std::string& id);

/// Turned by `angle` radians about the origin.
pattern::Panel turned(pattern::Panel panel, double angle);

/// Lays the pieces side by side, in order, 40 mm apart, their lower ends level.
void lay_out(std::vector<pattern::Panel>& panels);

/// The edge of that name. REQUIRES that there is one.
const pattern::PanelEdge& edge_of(const pattern::Panel& panel, const std::string& edge);

}  // namespace toile::draft
