#pragma once
// The seams with which a garment that is given as pieces alone would be worn.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/pattern/seams/accept.h"
#include "core/pattern/seams/propose.h"
#include "tests/core/pattern/garments.h"

namespace toile::garments {

inline pattern::Panel strip(const std::string& name, double length, double height) {
  return piece(name, {{0, 0}, {length, 0}, {length, height}, {0, height}});
}

/// The panel `by` times as large.
inline pattern::Panel scaled(pattern::Panel panel, double by) {
  for (pattern::PanelEdge& edge : panel.outline.edges)
    for (pattern::CubicBezier& c : edge.curves)
      for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3}) *p = *p * by;
  return panel;
}

/// A bodice, its own mirror image, from the right end of its hem: the edges from there to the armhole's lower
/// end and from there to the shoulder's, where `neck` is the shoulder's inner end and the neck's curve.
/// Edges: hem, side, armhole, shoulder, neck, shoulder, armhole, side.
inline pattern::Panel bodice(const std::string& name, const Node& hem, const Node& underarm, Vec2 shoulder,
                             const Node& neck) {
  const auto image = [](Vec2 p) { return Vec2{-p.x, p.y}; };
  const auto back_along = [&](double x, double y,
                              const Node& edge) {  // the mirrored edge, the other way round
    return edge.control ? Node{x, y, image(*edge.second), image(*edge.control)} : Node{x, y};
  };
  return piece(name, {{-hem.x, hem.y},
                      hem,
                      underarm,
                      {shoulder.x, shoulder.y},
                      {neck.x, neck.y, neck.control, image(*neck.control)},
                      {-neck.x, neck.y},
                      back_along(-shoulder.x, shoulder.y, underarm),
                      back_along(-underarm.x, underarm.y, hem)});
}

/// A front or a back 500 mm wide, whose neck is as high as that in its middle, mm: a bodice().
inline pattern::Panel plain_top(const std::string& name, double neck) {
  return bodice(name, {250, 0}, {245, 380, Vec2{190, 390}, Vec2{185, 430}}, {200, 600},
                {70, 640, Vec2{60, neck}});
}

/// A sleeve for two of these, its cap in two halves. Edges: hem, side, cap, cap, side.
inline pattern::Panel plain_sleeve(const std::string& name, double half_hem = 110) {
  return piece(name, {{-half_hem, 0},
                      {half_hem, 0},
                      {185, 420, Vec2{90, 430}, Vec2{90, 560}},
                      {0, 560, Vec2{-90, 560}, Vec2{-90, 430}},
                      {-185, 420}});
}

}  // namespace toile::garments

namespace toile::test {

/// The edges of a seam's side, as "piece.edge", in their order by name.
inline std::vector<std::string> named(const pattern::Pattern& pattern,
                                      const std::vector<pattern::SeamEdge>& side) {
  std::vector<std::string> names;
  for (const pattern::SeamEdge& e : side)
    names.push_back(pattern.panels[e.panel].id + "." + pattern.panels[e.panel].outline.edges[e.edge].id);
  std::sort(names.begin(), names.end());
  return names;
}

/// The seams with which a garment is worn.
class WornSeams {
 public:
  explicit WornSeams(std::vector<pattern::Panel> panels) : pattern_{std::move(panels), {}} {
    proposals_ = seams::propose_seams(pattern_);
    sewn_ = seams::sewn_to_wear(pattern_, proposals_, 0.8);
  }
  bool has(std::vector<std::string> a, std::vector<std::string> b) const {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    for (std::size_t i = 0; i < proposals_.size(); ++i) {
      const auto x = named(pattern_, proposals_[i].seam.a), y = named(pattern_, proposals_[i].seam.b);
      if (sewn_[i] && ((x == a && y == b) || (x == b && y == a))) return true;
    }
    return false;
  }
  /// The share of `edge` that is sewn to the named one, from 0 to 1; {0, 0} where none is.
  std::pair<double, double> part(const std::string& edge, const std::string& other) const {
    for (std::size_t i = 0; i < proposals_.size(); ++i)
      for (const auto& [mine, theirs] : {std::pair{proposals_[i].seam.a, proposals_[i].seam.b},
                                         std::pair{proposals_[i].seam.b, proposals_[i].seam.a}})
        if (sewn_[i] && named(pattern_, mine) == std::vector{edge} &&
            named(pattern_, theirs) == std::vector{other})
          return {mine.front().from, mine.front().to};
    return {0, 0};
  }
  /// All of them, a line each, to be read where a test fails.
  std::string text() const {
    std::string lines;
    for (std::size_t i = 0; i < proposals_.size(); ++i) {
      if (!sewn_[i]) continue;
      for (const auto* side : {&proposals_[i].seam.a, &proposals_[i].seam.b}) {
        for (const std::string& edge : named(pattern_, *side)) lines += edge + " ";
        lines += side == &proposals_[i].seam.a ? "to " : "\n";
      }
    }
    return lines;
  }
  bool takes(const std::string& edge) const {
    for (std::size_t i = 0; i < proposals_.size(); ++i)
      for (const auto* side : {&proposals_[i].seam.a, &proposals_[i].seam.b}) {
        const auto all = named(pattern_, *side);
        if (sewn_[i] && std::find(all.begin(), all.end(), edge) != all.end()) return true;
      }
    return false;
  }

 private:
  pattern::Pattern pattern_;
  std::vector<seams::SeamProposal> proposals_;
  std::vector<bool> sewn_;
};

}  // namespace toile::test
