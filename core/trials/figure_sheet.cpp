// The figure sheet: plain SVG, 900 by 560.

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/trials/fabric_trial.h"

namespace toile::trials {
namespace {

std::string number(double value, int digits = 1) { return fixed_text(value, digits); }

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += c;
  }
  return out;
}

std::string text_at(double x, double y, const std::string& text, const char* style = "") {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + style + ">" + escaped(text) + "</text>\n";
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
  const double left = 440, bottom = 520, width = 380, height = 170;
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
         " mm, known " + number(mm_from_metres(result.known)) + " mm (chord " + number(result.angle) +
         "°, 41.5° is right)";
}

std::string tension_line(const char* way, const TensionResult& result) {
  return std::string("tension per strain, ") + way + ": " + number(result.measured, 0) + " N/m, known " +
         number(result.known, 0) + " N/m";
}

std::string drape_lines(const fabric::FabricCard& card, const FabricTrial& trial) {
  const double percent = 100 * trial.coefficient();
  std::string band;
  if (card.drape_least_percent && card.drape_most_percent)
    band = "; published " + number(*card.drape_least_percent, 0) + " to " +
           number(*card.drape_most_percent, 0) + " %";
  return text_at(
             440, 222,
             "drape coefficient: " + number(percent) + " %, spread " + number(100 * trial.spread()) + band) +
         text_at(440, 242,
                 "folds: " + number(trial.nodes()) + "; " + std::to_string(trial.drapes.size()) +
                     " drapes, triangles of " + number(mm_from_metres(trial.particle_distance)) + " mm");
}

}  // namespace

std::string figure_sheet(const fabric::FabricCard& card, const FabricTrial& trial) {
  std::string out =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"560\" viewBox=\"0 0 900 560\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"900\" height=\"560\" fill=\"#fff\"/>\n";
  out += text_at(20, 34, card.title, "font-size=\"20\"");
  out += text_at(20, 56,
                 card.fibre + ", " + card.construction + ", " + card.weave + "; " +
                     number(card.areal_mass_g_m2, 0) + " g/m², " + number(card.thickness_mm, 2) + " mm");
  out += shadow_picture(trial.drapes.front().shadow);
  out += text_at(20, 500, "Piece of 30 cm (dashed) on a disc of 18 cm, from above: BS 5058, ISO 9073-9");
  out +=
      text_at(440, 90, "Strip 25 mm wide under its own weight: ASTM D1388, its chord at 41.5° where right");
  out += text_at(440, 110, cantilever_line("warp", trial.warp));
  out += text_at(440, 130, cantilever_line("weft", trial.weft));
  out += text_at(440, 150, cantilever_line("bias", trial.bias));
  out += text_at(440, 176, tension_line("warp", trial.pull_warp));
  out += text_at(440, 196, tension_line("weft", trial.pull_weft));
  out += drape_lines(card, trial);
  out += text_at(440, 320, "Tension over strain as the fabric's file has it");
  out += stretch_picture(card);
  return out + "</svg>\n";
}

}  // namespace toile::trials
