#include "core/material/elastic_line.h"

#include <cmath>

namespace toile::material {

std::vector<Vec2> elastic_line(double load, int steps) {
  const auto shoot = [&](double bend, std::vector<Vec2>* line) {
    double angle = 0;
    Vec2 p;
    for (int i = 0; i < steps; ++i) {
      if (line) line->push_back(p);
      const double s = (i + 0.5) / steps, middle = angle + 0.5 * bend / steps;
      p = p + Vec2{std::cos(middle), -std::sin(middle)} * (1.0 / steps);
      bend -= load * (1 - s) * std::cos(middle) / steps;
      angle += bend / steps;
    }
    if (line) line->push_back(p);
    return bend;
  };
  double low = 0, high = load;
  for (int i = 0; i < 60; ++i) (shoot((low + high) / 2, nullptr) < 0 ? low : high) = (low + high) / 2;
  std::vector<Vec2> line;
  shoot(high, &line);
  return line;
}

}  // namespace toile::material
