#include "core/body/body.h"

namespace toile::body {

std::vector<Vec3> vertices_at(const std::vector<Vec3>& start, std::span<const Keyframe> motion, double time) {
  const std::vector<Vec3>* from = &start;
  double since = 0;
  for (const Keyframe& next : motion) {
    if (time < next.at) {
      const double share = (time - since) / (next.at - since);
      std::vector<Vec3> x = *from;
      for (std::size_t v = 0; v < x.size(); ++v) x[v] += (next.vertices[v] - x[v]) * share;
      return x;
    }
    from = &next.vertices;
    since = next.at;
  }
  return *from;
}

}  // namespace toile::body
