// The figure sheet: plain SVG, 1000 by 620.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/markup.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/trials/fabric_trial.h"

namespace toile::trials {
namespace {

std::string number(double value, int digits = 1) { return fixed_text(value, digits); }

std::string text_at(double x, double y, const std::string& text, const char* style = "") {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + style + ">" + in_markup(text) +
         "</text>\n";
}

std::string circle_at(Vec2 c, double r, const char* style) {
  return "<circle cx=\"" + number(c.x) + "\" cy=\"" + number(c.y) + "\" r=\"" + number(r) + "\" " + style +
         "/>\n";
}

/// From above, 1.2 pixels a millimetre: the flat piece, its shadow, the disc.
std::string shadow_picture(const Shadow& shadow) {
  constexpr double kScale = mm_from_metres(1.2);
  const Vec2 middle{200, 280};
  std::string path;
  for (std::size_t degree = 0; degree < shadow.outline.size(); ++degree) {
    const double a = radians_from_degrees(static_cast<double>(degree)), r = kScale * shadow.outline[degree];
    path += (degree == 0 ? "M" : " L") + number(middle.x + r * std::cos(a)) + " " +
            number(middle.y + r * std::sin(a));
  }
  return circle_at(middle, kScale * kSpecimenRadius,
                   "fill=\"none\" stroke=\"#999\" stroke-dasharray=\"5 4\"") +
         "<path d=\"" + path + " Z\" fill=\"#456\" stroke=\"none\"/>\n" +
         circle_at(middle, kScale * kDiscRadius, "fill=\"#9ab\" stroke=\"none\"");
}

/// Tension over strain, both axes from 0 to the larger curve's end.
std::string stretch_picture(const fabric::FabricCard& card) {
  const double left = 440, bottom = 580, width = 420, height = 170;
  double strain = 0, tension = 0;
  for (const fabric::StretchCurve* curve : {&card.stretch_warp, &card.stretch_weft}) {
    strain = std::max(strain, curve->back().strain_percent);
    tension = std::max(tension, curve->back().tension_n_m);
  }
  const auto line = [&](const fabric::StretchCurve& curve, const char* colour) {
    std::string points = number(left) + "," + number(bottom);
    for (const fabric::CurvePoint& p : curve)
      points += " " + number(left + width * p.strain_percent / strain) + "," +
                number(bottom - height * p.tension_n_m / tension);
    return "<polyline points=\"" + points + "\" fill=\"none\" stroke-width=\"2\" stroke=\"" +
           std::string(colour) + "\"/>\n";
  };
  return "<path d=\"M" + number(left) + " " + number(bottom - height) + " V" + number(bottom) + " H" +
         number(left + width) + "\" fill=\"none\" stroke=\"#333\"/>\n" + line(card.stretch_warp, "#b33") +
         line(card.stretch_weft, "#36b") +
         text_at(left + 6, bottom - height + 8, number(tension, 0) + " N/m") +
         text_at(left + width - 60, bottom + 18, number(strain, 0) + " % strain") +
         text_at(left + 110, bottom - height + 8, "warp", "fill=\"#b33\"") +
         text_at(left + 160, bottom - height + 8, "weft", "fill=\"#36b\"");
}

std::string cantilever_line(const char* way, const CantileverResult& result) {
  return std::string("bending length, ") + way + ": " + number(mm_from_metres(result.measured)) +
         " mm, known " + number(mm_from_metres(result.known)) + " mm (chord " + number(result.angle) + "°)";
}

/// Of a test whose result has a measured and a known figure.
template <typename Test>
std::string test_line(const std::string& what, const Test& result, const char* unit, int digits) {
  return what + ": " + number(result.measured, digits) + unit + ", known " + number(result.known, digits) +
         unit;
}

std::string drape_line(const fabric::FabricCard& card, const FabricTrial& trial) {
  std::string out = "drape coefficient: " + number(100 * trial.coefficient()) + " %, spread " +
                    number(100 * trial.spread());
  if (card.drape_least_percent && card.drape_most_percent)
    out += "; published " + number(*card.drape_least_percent, 0) + " to " +
           number(*card.drape_most_percent, 0) + " %";
  return out;
}

/// Heads of tests with what each gave, from the top.
std::string figures(const fabric::FabricCard& card, const FabricTrial& trial) {
  struct Group {
    const char* head;
    std::vector<std::string> lines;
  };
  const Group groups[] = {
      {"Strip 25 mm wide under its own weight (ASTM D1388: chord at 41.5°)",
       {cantilever_line("warp", trial.warp), cantilever_line("weft", trial.weft),
        cantilever_line("bias", trial.bias)}},
      {"Strip of 50 by 200 mm, stretched by 0.5 %",
       {test_line("tension per strain, warp", trial.pull_warp, " N/m", 0),
        test_line("tension per strain, weft", trial.pull_weft, " N/m", 0)}},
      {"Piece of 50 by 200 mm, sheared by 0.5° (as KES-FB1)",
       {test_line("shear stiffness", trial.shear, " N/m per radian", 1)}},
      {"Tube 100 mm across under air pressure p; tension around is p r",
       {test_line("tension per strain, warp around", trial.tube_warp, " N/m", 0),
        test_line("tension per strain, weft around", trial.tube_weft, " N/m", 0)}},
      {"Piece of 100 by 100 mm, sliding down a slope (as ISO 8295)",
       {test_line("coefficient of friction", trial.slide, "", 3)}},
      {"Piece of 30 cm on a disc of 18 cm (BS 5058, ISO 9073-9)",
       {drape_line(card, trial), "folds: " + number(trial.nodes()) + "; " +
                                     std::to_string(trial.drapes.size()) + " drapes, triangles of " +
                                     number(mm_from_metres(trial.particle_distance)) + " mm"}}};
  std::string out;
  double y = 34;
  for (const Group& group : groups) {
    out += text_at(440, y, group.head, "font-weight=\"bold\"");
    for (const std::string& line : group.lines) out += text_at(440, y += 17, line);
    y += 26;
  }
  return out;
}

}  // namespace

std::string figure_sheet(const fabric::FabricCard& card, const FabricTrial& trial) {
  std::string out =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000\" height=\"620\" viewBox=\"0 0 1000 620\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"1000\" height=\"620\" fill=\"#fff\"/>\n";
  out += text_at(20, 34, card.title, "font-size=\"20\"");
  out += text_at(20, 56,
                 card.fibre + ", " + card.construction + ", " + card.weave + "; " +
                     number(card.areal_mass_g_m2, 0) + " g/m², " + number(card.thickness_mm, 2) + " mm");
  out += shadow_picture(trial.drapes.front().shadow);
  out += text_at(20, 500, "Its drape from above; dashed: the flat piece");
  out += figures(card, trial);
  out += text_at(440, 394, "Tension over strain as the fabric's file has it", "font-weight=\"bold\"");
  out += stretch_picture(card);
  return out + "</svg>\n";
}

}  // namespace toile::trials
