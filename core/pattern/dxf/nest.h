#pragma once
// Which closed lines of a drawing lie in which, and which of them are one line drawn twice.

#include <cstddef>
#include <optional>
#include <vector>

#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/layers.h"

namespace toile::dxf {

/// mm, by which a line may stick out of the piece it belongs to.
inline constexpr double kBoxSlack = 1;

/// A closed chain with what is asked of it again and again.
struct DxfLoop {
  const DxfChain* chain = nullptr;  ///< outlives the loop
  std::size_t number = 0;           ///< the chain's, among those of its place
  DxfRole role = DxfRole::kOther;
  Aabb2 box;
  double area = 0;
  std::optional<std::size_t> parent;  ///< the smallest loop of its layer around it
  int depth = 0;                      ///< number of such loops: an odd one is a hole
};

DxfLoop loop_of(const DxfChain& chain, std::size_t number, DxfRole role);

/// Whether the inner loop lies wholly inside, without touching.
bool lies_within(const DxfLoop& inner, const DxfLoop& outer);

/// The loops with each one's parent among those of its layer.
std::vector<DxfLoop> nested(std::vector<DxfLoop> loops);

/// Distance from p to the closed polyline, mm.
double distance_to_loop(Vec2 p, const std::vector<Vec2>& loop);

/// Whether the inner loop lies within the outer one or along it, judged by a sample of its vertices.
bool is_covered(const DxfLoop& inner, const DxfLoop& outer);

/// Whether most of one loop lies within the other, judged by a sample of its vertices.
bool lies_mostly_within(const DxfLoop& inner, const DxfLoop& outer);

/// Whether one box holds the other, nearly.
bool same_place(const Aabb2& a, const Aabb2& b);

/// Whether the two are the same line, drawn twice.
bool is_repeated(const DxfLoop& a, const DxfLoop& b);

}  // namespace toile::dxf
