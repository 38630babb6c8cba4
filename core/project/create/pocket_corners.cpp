#include "core/project/create/pocket_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/pattern/curve.h"
#include "core/pattern/seams/lines.h"
#include "core/pattern/seams/model.h"
#include "core/pattern/seams/roles.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::create {
namespace {

constexpr double kLeastCut = 20, kMostCut = 320;  // mm, of side or waist that a pocket takes
constexpr double kAgree = 8;                      // mm, that the sides of front and back may differ by
constexpr double kMouthUp[2] = {0.15, 0.95};      // how much a mouth faces up
constexpr double kOnMouth = 1;                    // mm, of a notch from the mouth

/// A front's side, the mouth after it or before it, and its waist, in edges of the panel.
struct Mouth {
  Index side = kNone, mouth = kNone, waist = kNone;  ///< of the side the edge at the mouth
  double side_length = 0;                            ///< mm, from the hem
  bool after = false;                                ///< the outline runs from the side to the waist
};

const seams::SeamRun& beside(const seams::SeamModel& m, const seams::SeamRun& run, bool after) {
  return after ? m.runs[run.next] : seams::run_before(m, run);
}

/// The edges that go up from a hem to the waist, the lowest first; none where no waist is above them.
std::vector<const seams::SeamRun*> side_from(const seams::SeamModel& m, const seams::SeamRun& lowest,
                                             bool after) {
  std::vector<const seams::SeamRun*> side{&lowest};
  for (const seams::SeamRun* next = &beside(m, lowest, after); next->up < kMouthUp[1];
       next = &beside(m, *next, after)) {
    if (next == &lowest || next->up < -kMouthUp[1]) return {};  // it went around by the hem
    side.push_back(next);
  }
  return side;
}

bool begins_side(const seams::SeamModel& m, const seams::SeamRun& run) {
  return seams::begins_at_hem(m, run) && std::abs(run.up) < kMouthUp[0];
}

double length_of(const std::vector<const seams::SeamRun*>& side) {
  double length = 0;
  for (const seams::SeamRun* run : side) length += run->length;
  return length;
}

/// All that may be one; a crotch faces up a little, too, and is none.
std::vector<Mouth> mouths_of(const seams::SeamModel& m, Index panel) {
  std::vector<Mouth> mouths;
  for (const seams::SeamRun& lowest : m.runs) {
    if (lowest.panel != panel || !begins_side(m, lowest)) continue;
    for (const bool after : {true, false}) {
      std::vector<const seams::SeamRun*> side = side_from(m, lowest, after);
      if (side.size() < 2 || side.back()->up < kMouthUp[0] || seams::is_leg_crotch(m, *side.back())) continue;
      const seams::SeamRun& mouth = *side.back();
      side.pop_back();
      mouths.push_back({side.back()->edge, mouth.edge, beside(m, mouth, after).edge, length_of(side), after});
    }
  }
  return mouths;
}

/// The way on beyond an end of the edge, a unit vector.
Vec2 way_on(const pattern::PanelEdge& edge, bool at_end) {
  const pattern::CubicBezier& c = at_end ? edge.curves.back() : edge.curves.front();
  const Vec2 along = pattern::derivative(c, at_end ? 1 : 0);
  return normalized(at_end ? along : -along);
}

/// Where both go on to, and how far each does; nothing where they do not meet there.
struct Meeting {
  Vec2 at;
  double side = 0, waist = 0;  ///< mm
};

std::optional<Meeting> meeting_of(const pattern::Panel& front, const Mouth& mouth) {
  const std::vector<pattern::PanelEdge>& edges = front.outline.edges;
  const pattern::PanelEdge &side = edges[mouth.side], &waist = edges[mouth.waist];
  const Vec2 from = mouth.after ? side.curves.back().p3 : side.curves.front().p0;
  const Vec2 to = mouth.after ? waist.curves.front().p0 : waist.curves.back().p3;
  const Vec2 up = way_on(side, mouth.after), out = way_on(waist, !mouth.after);
  const double sine = cross(up, out);
  if (std::abs(sine) < 0.5) return std::nullopt;
  const double s = cross(to - from, out) / sine, w = cross(to - from, up) / sine;
  if (std::min(s, w) < kLeastCut || std::max(s, w) > kMostCut) return std::nullopt;
  return Meeting{from + s * up, s, w};
}

/// Lengths of backs' sides, and of these with a yoke's end, mm.
std::vector<double> sides_behind(const seams::SeamModel& m) {
  std::vector<double> yokes{0}, sides;
  for (const seams::SeamRun& run : m.runs) {
    const seams::PieceWords& words = m.words[run.panel];
    if (words.yoke && std::abs(run.up) < seams::kPairWeights.facing) yokes.push_back(run.length);
  }
  for (const seams::SeamRun& run : m.runs) {
    const seams::PieceWords& words = m.words[run.panel];
    if (words.face >= 0 || words.layer || words.yoke || !seams::has_leg_crotch(m, run.panel)) continue;
    if (!begins_side(m, run)) continue;
    for (const bool after : {true, false}) {
      const std::vector<const seams::SeamRun*> side = side_from(m, run, after);
      if (side.empty()) continue;
      for (const double yoke : yokes) sides.push_back(length_of(side) + yoke);
    }
  }
  return sides;
}

bool agrees(const std::vector<double>& lengths, double length) {
  return std::any_of(lengths.begin(), lengths.end(),
                     [&](double other) { return std::abs(other - length) < kAgree; });
}

}  // namespace

std::vector<PocketCorner> pocket_corners(std::span<const pattern::Panel> panels) {
  pattern::Pattern pattern;
  pattern.panels.assign(panels.begin(), panels.end());
  const seams::SeamModel m = seams::make_seam_model(pattern);
  if (std::none_of(m.words.begin(), m.words.end(), [](const auto& words) { return words.layer; })) return {};
  const std::vector<double> behind = sides_behind(m);
  std::vector<PocketCorner> corners;
  for (Index p = 0; p < static_cast<Index>(panels.size()); ++p) {
    if (m.words[p].face <= 0 || m.words[p].layer || !seams::has_leg_crotch(m, p)) continue;
    for (const Mouth& mouth : mouths_of(m, p)) {
      const std::optional<Meeting> meeting = meeting_of(panels[p], mouth);
      if (!meeting || agrees(behind, mouth.side_length) || !agrees(behind, mouth.side_length + meeting->side))
        continue;
      corners.push_back({p, mouth.mouth, meeting->at});
      break;
    }
  }
  return corners;
}

pattern::Panel with_corner(const pattern::Panel& front, const PocketCorner& pocket) {
  pattern::Panel whole = front;
  std::vector<pattern::PanelEdge>& edges = whole.outline.edges;
  const std::size_t n = edges.size(), at = static_cast<std::size_t>(pocket.mouth);
  const pattern::PanelEdge mouth = edges[at];
  const Vec2 from = mouth.curves.front().p0, to = mouth.curves.back().p3;
  edges[(at + n - 1) % n].curves.push_back(pattern::line_segment(from, pocket.corner));
  std::vector<pattern::CubicBezier>& next = edges[(at + 1) % n].curves;
  next.insert(next.begin(), pattern::line_segment(pocket.corner, to));
  edges.erase(edges.begin() + pocket.mouth);
  const std::vector<Vec2> line = pattern::flatten(mouth, 0.1);
  std::erase_if(whole.notches, [&](const pattern::Notch& notch) {
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Vec2 along = line[k] - line[k - 1];
      const double share = std::clamp(dot(notch.at - line[k - 1], along) / dot(along, along), 0.0, 1.0);
      if (length(notch.at - line[k - 1] - share * along) < kOnMouth) return true;
    }
    return false;
  });
  return whole;
}

}  // namespace toile::create
