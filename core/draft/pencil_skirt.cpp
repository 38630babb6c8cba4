#include "core/draft/pencil_skirt.h"

#include <algorithm>

#include "core/draft/dart.h"

namespace toile::draft {
namespace {

constexpr double kSideUp = 6;  // mm, of the side's upper end above the middle's

/// A quarter of the skirt: x from the middle, y from the hem, mm.
struct Quarter {
  double hem, hip, waist;  ///< widths, the waist's without its dart
  double hips, top;        ///< heights
  Dart dart;
};

Quarter quarter_of(const Wearer& w, const PencilSkirtStyle& s, bool back) {
  const double scale = w.height / 1680, knee = 0.285 * w.height;
  Quarter q{};
  q.hip = (w.hip + s.hip_ease * scale) / 4;
  q.hem = q.hip - s.pegged * scale;
  q.waist = (w.waist + s.waist_ease * scale) / 4;
  q.top = w.waist_height - knee;
  q.hips = w.hip_height - knee;
  const double much = std::max(0.0, q.hip - q.waist);
  q.dart.width = much * (back ? 0.62 : 0.48);
  q.dart.length = (back ? 130 : 95) * scale;
  return q;
}

/// The side from the hem up to the waist, then the waist to the middle. Both quarters have the same widths at
/// hem and hips; the wider dart takes the back's side less far in, which the waist's end makes up for.
void add_side_and_waist(Outline& out, const Quarter& q) {
  const double width = q.waist + (is_sewn(q.dart) ? q.dart.width : 0);
  const Vec2 hip{q.hip, q.hips}, top{width, q.top + kSideUp};
  const double below = q.hips * 0.3, above = (q.top - q.hips) * 0.42;
  out.curve("side", Vec2{q.hem, 0} + (hip - Vec2{q.hem, 0}) * 0.4, hip - Vec2{0, below}, hip);
  out.notch(-1e-9);
  out.curve(hip + Vec2{0, above}, top + Vec2{(q.hip - width) * 0.30, -above}, top);
  Dart dart = q.dart;
  dart.at = length(Vec2{0, q.top} - top) * 0.5;
  waist_with_dart(out, {0, q.top}, dart, "side", "middle");
}

pattern::Panel front_of(const Quarter& q) {
  Outline half({0, 0});
  half.line("hem", {q.hem, 0});
  add_side_and_waist(half, q);
  return unfolded("front", half, "left", "right");
}

/// The wearer's right: from the back it lies on the right, its middle at x = 0.
pattern::Panel right_back(const Quarter& q, double slit) {
  Outline out({0, 0});
  out.line("hem", {q.hem, 0});
  add_side_and_waist(out, q);
  out.line("middle", {0, slit}).line("slit", {0, 0});
  return piece("right back", out);
}

/// Makes the back's side as long as the front's by its upper end.
void match_sides(const Quarter& front, Quarter& back) {
  const auto side = [](const Quarter& q) {
    Outline out({q.hem, 0});
    add_side_and_waist(out, q);
    pattern::Panel open;
    open.outline.edges = out.edges();
    return length_of(open, {"side"});
  };
  double low = back.top - 30, high = back.top + 30;
  const double wanted = side(front);
  for (int i = 0; i < 50; ++i) {
    back.top = (low + high) / 2;
    (side(back) < wanted ? low : high) = back.top;
  }
}

void sew_together(Garment& g, const Quarter& front, const Quarter& back) {
  for (const std::string side : {"left", "right"}) {
    const std::string rear = side + " back";
    sew(g, "side_" + side, {{"front", "side_" + side}}, {{rear, "side"}});
    if (is_sewn(front.dart))
      sew(g, "dart_front_" + side, {{"front", "dart_side_" + side}}, {{"front", "dart_middle_" + side}});
    if (is_sewn(back.dart)) sew(g, "dart_back_" + side, {{rear, "dart_side"}}, {{rear, "dart_middle"}});
  }
  sew(g, "middle_back", {{"left back", "middle"}}, {{"right back", "middle"}});
  sew(g, "waistband", {{"waistband", "waist"}},
      {{"left back", "waist_middle"},
       {"left back", "waist_side"},
       {"front", "waist_side_left"},
       {"front", "waist_middle"},
       {"front", "waist_side_right"},
       {"right back", "waist_side"},
       {"right back", "waist_middle"}});
  sew(g, "waistband_end", {{"waistband", "end_a"}}, {{"waistband", "end_b"}});
}

}  // namespace

Garment draft_pencil_skirt(const Wearer& w, const PencilSkirtStyle& s) {
  const double scale = w.height / 1680;
  const Quarter front = quarter_of(w, s, false);
  Quarter back = quarter_of(w, s, true);
  match_sides(front, back);
  Garment g{.name = "pencil-skirt", .title = "Pencil skirt"};
  g.cloths = {{"suiting", "wool-suiting", {0.16, 0.05, 0.07}},
              {"denim", "denim-10oz", {0.03, 0.06, 0.14}},
              {"ponte", "ponte", {0.05, 0.05, 0.06}}};
  std::vector<pattern::Panel>& panels = g.pattern.panels;
  const pattern::Panel right = right_back(back, s.slit * scale);
  panels = {front_of(front), mirrored(right, "left back"), right};
  const double around = length_of(panels[0], {"waist_side_left", "waist_middle", "waist_side_right"}) +
                        2 * length_of(right, {"waist_side", "waist_middle"});
  panels.push_back(strip("waistband", "waist", around, s.band_height * scale));
  g.interlinings = {{"waistband", "interlining"}};
  sew_together(g, front, back);
  g.girths = {{"waist", w.waist, around}, {"hip", w.hip, 4 * front.hip}};
  lay_out(g);
  return g;
}

}  // namespace toile::draft
