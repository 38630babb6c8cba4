#include "tests/garments/random_pieces.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/pattern/curve.h"

namespace toile::test {
namespace {

/// The outline's way from its last point to `to`, swelling outwards by `bulge` of its length.
struct Stroke {
  Vec2 to;
  int side = -1;  ///< -1: none of the four
  double bulge = 0;
};

pattern::CubicBezier swollen(Vec2 a, Vec2 b, double bulge) {
  const Vec2 d = b - a, out = Vec2{d.y, -d.x} * bulge;
  return {a, a + d * (1.0 / 3) + out, a + d * (2.0 / 3) + out, b};
}

void add_edge(CutPiece& piece, int side, std::vector<pattern::CubicBezier> curves) {
  const auto index = static_cast<Index>(piece.panel.outline.edges.size());
  if (side >= 0) piece.sides[side].push_back(index);
  pattern::PanelEdge edge;
  edge.id = "e" + std::to_string(index);
  edge.curves = std::move(curves);
  piece.panel.outline.edges.push_back(std::move(edge));
}

/// Each stroke is an edge; the last one's end is the first one's start.
void draw(CutPiece& piece, const std::vector<Stroke>& strokes) {
  Vec2 from = strokes.back().to;
  for (const Stroke& s : strokes) {
    add_edge(piece, s.side, {swollen(from, s.to, s.bulge)});
    from = s.to;
  }
}

/// Arc around the origin from one angle to another, either way, its ends given exactly.
std::vector<pattern::CubicBezier> arc(double radius, double from, double to, Vec2 start, Vec2 end) {
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / (kPi / 2))));
  const double turn = (to - from) / parts, handle = radius * 4 / 3 * std::tan(turn / 4);
  const auto at = [&](double a) { return Vec2{radius * std::cos(a), radius * std::sin(a)}; };
  std::vector<pattern::CubicBezier> curves;
  Vec2 p = start;
  for (int k = 0; k < parts; ++k) {
    const double a = from + turn * k, b = a + turn;
    const Vec2 q = k + 1 == parts ? end : at(b);
    curves.push_back(
        {p, p + perpendicular(at(a)) * (handle / radius), q - perpendicular(at(b)) * (handle / radius), q});
    p = q;
  }
  return curves;
}

/// A clockwise hole of four arcs or one, or a square.
pattern::Loop hole_at(Chance& chance, Vec2 centre, double radius, int name) {
  pattern::Loop loop;
  const int edges = chance.happens(0.5) ? 4 : 1;
  const Vec2 first{radius, 0};
  std::vector<pattern::CubicBezier> curves = arc(radius, 0, -2 * kPi, first, first);
  for (pattern::CubicBezier& c : curves) c = {c.p0 + centre, c.p1 + centre, c.p2 + centre, c.p3 + centre};
  for (int e = 0; e < edges; ++e) {
    pattern::PanelEdge edge;
    edge.id = "h" + std::to_string(name) + std::to_string(e);
    const auto begin = curves.begin() + e * 4 / edges;
    edge.curves.assign(begin, begin + 4 / edges);
    loop.edges.push_back(std::move(edge));
  }
  return loop;
}

void quadrilateral(Chance& chance, CutPiece& piece, double w, double h, double taper, double bulge) {
  const double top = w * taper, lean = chance.between(-0.2, 0.2) * (w - top);
  const auto swell = [&] { return bulge > 0 ? chance.between(-bulge, bulge) : 0; };
  draw(piece, {{{w / 2, 0}, kBottom, swell()},
               {{lean + top / 2, h}, kRight, swell()},
               {{lean - top / 2, h}, kTop, swell()},
               {{-w / 2, 0}, kLeft, swell()}});
}

void disc(CutPiece& piece, double radius) {
  const Vec2 corner[4] = {{radius, 0}, {0, radius}, {-radius, 0}, {0, -radius}};
  for (int k = 0; k < 4; ++k) {
    add_edge(piece, (k + 1) % 4, arc(radius, k * kPi / 2, (k + 1) * kPi / 2, corner[k], corner[(k + 1) % 4]));
  }
}

/// A piece of a ring, open upwards; its outer arc is the bottom.
void sector(CutPiece& piece, double inner, double outer, double span) {
  const double a = -kPi / 2 - span / 2, b = -kPi / 2 + span / 2;
  const auto at = [](double r, double angle) { return Vec2{r * std::cos(angle), r * std::sin(angle)}; };
  add_edge(piece, kBottom, arc(outer, a, b, at(outer, a), at(outer, b)));
  add_edge(piece, kRight, {pattern::line_segment(at(outer, b), at(inner, b))});
  add_edge(piece, kTop, arc(inner, b, a, at(inner, b), at(inner, a)));
  add_edge(piece, kLeft, {pattern::line_segment(at(inner, a), at(outer, a))});
}

void l_shape(Chance& chance, CutPiece& piece, double w, double h) {
  const double x = w * chance.between(-0.3, 0.3), y = h * chance.between(0.25, 0.75);
  draw(piece, {{{w / 2, 0}, kBottom},
               {{w / 2, y}, kRight},
               {{x, y}, kTop},
               {{x, h}, kTop},
               {{-w / 2, h}, kTop},
               {{-w / 2, 0}, kLeft}});
}

/// A wedge out of the bottom: a dart when its legs are to be sewn, else a slit.
void notched(Chance& chance, CutPiece& piece, double w, double h, double opening, bool sewn) {
  const double x = w * chance.between(-0.25, 0.25), depth = h * chance.between(0.2, 0.7);
  draw(piece, {{{x - opening / 2, 0}, kBottom},
               {{x, depth}, -1},
               {{x + opening / 2, 0}, -1},
               {{w / 2, 0}, kBottom},
               {{w / 2, h}, kRight},
               {{-w / 2, h}, kTop},
               {{-w / 2, 0}, kLeft}});
  if (sewn) piece.darts.push_back({1, 2});
}

void measure(CutPiece& piece) { piece.box = bounding_box(pattern::flatten(piece.panel.outline, 0.1)); }

void add_holes(Chance& chance, CutPiece& piece, double w, double h) {
  const double radius = std::min(w, h) * chance.between(0.05, 0.2);
  if (w > 2 * h) {
    piece.panel.holes.push_back(hole_at(chance, {-w / 4, h / 2}, radius, 0));
    piece.panel.holes.push_back(hole_at(chance, {w / 4, h / 2}, radius, 1));
  } else {
    piece.panel.holes.push_back(hole_at(chance, {0, h / 2}, radius, 0));
  }
}

Vec2 random_grain(Chance& chance) {
  const int kind = chance.whole(0, 2);
  if (kind < 2) return kind == 0 ? Vec2{0, 1} : Vec2{1, 0};
  const double a = chance.between(0, 2 * kPi);
  return normalized(Vec2{std::cos(a), std::sin(a)});
}

}  // namespace

CutPiece cut_piece(Chance& chance, const std::string& id, double w, double h, double narrow) {
  static const char* const kShapes[] = {"rectangle", "rectangle", "trapezium", "disc",  "sector", "L",
                                        "curved",    "dart",      "slit",      "holed", "sliver"};
  CutPiece piece;
  piece.shape = kShapes[chance.whole(0, 10)];
  piece.panel.id = id;
  piece.panel.grain = random_grain(chance);
  const std::string& s = piece.shape;
  if (s == "rectangle") quadrilateral(chance, piece, w, h, 1, 0);
  if (s == "trapezium") quadrilateral(chance, piece, w, h, chance.log_between(0.15, 1.5), 0);
  if (s == "disc") disc(piece, std::sqrt(w * h / kPi));
  if (s == "sector") {
    const double outer = std::sqrt(w * h) * 0.7;
    sector(piece, outer * chance.between(0.1, 0.8), outer, chance.between(0.6, 1.9) * kPi);
  }
  if (s == "L") l_shape(chance, piece, w, h);
  if (s == "curved") quadrilateral(chance, piece, w, h, chance.between(0.7, 1.2), 0.15);
  if (s == "dart") notched(chance, piece, w, h, w * chance.between(0.03, 0.3), true);
  if (s == "slit") notched(chance, piece, w, h, std::min(0.2 * w, narrow * chance.between(0.05, 0.5)), false);
  if (s == "holed") {
    quadrilateral(chance, piece, w, h, 1, 0);
    add_holes(chance, piece, w, h);
  }
  if (s == "sliver") {
    const bool upright = chance.happens(0.5);
    const double thin = narrow * chance.between(0.2, 1);
    quadrilateral(chance, piece, upright ? thin : w, upright ? h : thin, chance.between(0.3, 1), 0);
  }
  measure(piece);
  return piece;
}

CutPiece cut_ring(Chance& chance, const std::string& id, double inner, double outer, bool slit) {
  CutPiece piece;
  piece.panel.id = id;
  piece.panel.grain = random_grain(chance);
  if (slit) {
    piece.shape = "half ring";
    sector(piece, inner, outer, chance.between(1.5, 1.97) * kPi);
  } else {
    piece.shape = "ring";
    disc(piece, outer);
    piece.panel.holes.push_back(hole_at(chance, {0, 0}, inner, 0));
  }
  measure(piece);
  return piece;
}

CutPiece copy_of(const CutPiece& piece, const std::string& id) {
  CutPiece copy = piece;
  copy.panel.id = id;
  return copy;
}

}  // namespace toile::test
