#include <string>

#include "core/base/markup.h"
#include "core/base/text.h"
#include "core/print/print.h"
#include "core/print/sheet.h"

namespace toile::print {
namespace {

/// y runs down in SVG.
std::string place(Vec2 p, const Sheet& sheet) {
  return fixed_text(p.x, 3) + " " + fixed_text(sheet.size.y - p.y, 3);
}

std::string path_of(const Stroke& stroke, const Sheet& sheet) {
  std::string path = "M" + place(stroke.curves.front().p0, sheet);
  for (const pattern::CubicBezier& c : stroke.curves)
    path += "C" + place(c.p1, sheet) + " " + place(c.p2, sheet) + " " + place(c.p3, sheet);
  return path + (stroke.closed ? "Z" : "");
}

/// As attributes: plotters' programs often pass over style sheets.
const char* looks_of(Pen pen) {
  switch (pen) {
    case Pen::kOutline:
      return "class=\"outline\" stroke-width=\"0.4\"";
    case Pen::kInner:
      return "class=\"inner\" stroke-width=\"0.25\" stroke-dasharray=\"4 2\"";
    case Pen::kGrain:
      return "class=\"grain\" stroke-width=\"0.25\"";
    case Pen::kMark:
      return "class=\"mark\" stroke-width=\"0.25\"";
  }
  return "";
}

}  // namespace

Result<std::string> pattern_svg(const pattern::Pattern& pattern, const std::string& title) {
  if (pattern.panels.empty()) return Error{"print.nothing", "the pattern has no piece to print", ""};
  constexpr double kRoll = 1400;  // mm, a usual width of cloth and of plotters' paper
  const Sheet sheet = lay_out(pattern, title, kRoll);
  const std::string width = fixed_text(sheet.size.x, 3), height = fixed_text(sheet.size.y, 3);
  std::string svg =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
      width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height + "\">\n<title>" +
      in_markup(title) + "</title>\n<g fill=\"none\" stroke=\"#000\">\n";
  for (const Stroke& stroke : sheet.strokes) {
    if (stroke.curves.empty()) continue;
    svg += std::string("<path ") + looks_of(stroke.pen) + " d=\"" + path_of(stroke, sheet) + "\"/>\n";
  }
  svg += "</g>\n<g fill=\"#333\" font-family=\"sans-serif\">\n";
  for (const Caption& caption : sheet.captions)
    svg += "<text x=\"" + fixed_text(caption.at.x, 3) + "\" y=\"" +
           fixed_text(sheet.size.y - caption.at.y, 3) + "\" font-size=\"" + fixed_text(caption.height, 1) +
           "\">" + in_markup(caption.text) + "</text>\n";
  return svg + "</g>\n</svg>\n";
}

}  // namespace toile::print
