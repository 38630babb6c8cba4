#pragma once
// Small DXF texts for tests.

#include <initializer_list>
#include <string>
#include <utility>

#include "core/base/types.h"
#include "core/pattern/dxf/settings.h"

namespace toile::dxf_text {

using Groups = std::initializer_list<std::pair<int, std::string>>;

inline std::string groups(Groups list) {
  std::string out;
  for (const auto& [code, value] : list) out += std::to_string(code) + "\n" + value + "\n";
  return out;
}

/// Small drawings say no unit and are too small to guess it.
inline dxf::DxfSettings in_mm() {
  dxf::DxfSettings settings;
  settings.mm_per_unit = 1;
  return settings;
}

inline std::string number(double v) { return std::to_string(v); }

inline std::string header(int units) {
  return groups(
      {{0, "SECTION"}, {2, "HEADER"}, {9, "$INSUNITS"}, {70, std::to_string(units)}, {0, "ENDSEC"}});
}

inline std::string section(const std::string& name, const std::string& body) {
  return groups({{0, "SECTION"}, {2, name}}) + body + groups({{0, "ENDSEC"}});
}

inline std::string entities(const std::string& body) {
  return section("ENTITIES", body) + groups({{0, "EOF"}});
}

inline std::string line(Vec2 a, Vec2 b, const std::string& layer = "0") {
  return groups(
      {{0, "LINE"}, {8, layer}, {10, number(a.x)}, {20, number(a.y)}, {11, number(b.x)}, {21, number(b.y)}});
}

inline std::string polyline(std::initializer_list<Vec2> points, const std::string& layer = "0",
                            int flags = 1) {
  std::string out = groups({{0, "POLYLINE"}, {8, layer}, {66, "1"}, {70, std::to_string(flags)}});
  for (Vec2 p : points) out += groups({{0, "VERTEX"}, {8, layer}, {10, number(p.x)}, {20, number(p.y)}});
  return out + groups({{0, "SEQEND"}});
}

inline std::string rectangle(Vec2 at, double width, double height, const std::string& layer = "0") {
  return polyline({at, at + Vec2{width, 0}, at + Vec2{width, height}, at + Vec2{0, height}}, layer);
}

inline std::string text(Vec2 at, const std::string& words, const std::string& layer = "0") {
  return groups({{0, "TEXT"}, {8, layer}, {10, number(at.x)}, {20, number(at.y)}, {40, "8"}, {1, words}});
}

inline std::string block(const std::string& name, const std::string& body, Vec2 base = {}) {
  return groups({{0, "BLOCK"}, {8, "1"}, {2, name}, {70, "0"}, {10, number(base.x)}, {20, number(base.y)}}) +
         body + groups({{0, "ENDBLK"}});
}

inline std::string insert(const std::string& name, Vec2 at) {
  return groups({{0, "INSERT"}, {8, "1"}, {2, name}, {10, number(at.x)}, {20, number(at.y)}});
}

/// A rectangle as four open POLYLINEs, one for each side, from the lower left corner counter-clockwise.
inline std::string open_sides(Vec2 at, double width, double height, const std::string& layer) {
  const Vec2 b = at + Vec2{width, 0}, c = at + Vec2{width, height}, d = at + Vec2{0, height};
  return polyline({at, b}, layer, 0) + polyline({b, c}, layer, 0) + polyline({c, d}, layer, 0) +
         polyline({d, at}, layer, 0);
}

}  // namespace toile::dxf_text
