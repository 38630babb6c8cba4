#include "core/exports/report_page.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/base/markup.h"
#include "core/base/text.h"

namespace toile::exports {
namespace {

using json::JsonValue;

constexpr std::string_view kStyle = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #222; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { margin: 0 0 .2rem; font-size: 1.6rem; } h2 { margin: 1.8rem 0 .4rem; font-size: 1.1rem; }
.verdict { margin: 0 0 1rem; } .pictures { display: flex; gap: .6rem; flex-wrap: wrap; }
figure { margin: 0; flex: 1 1 14rem; max-width: 22rem; } img { width: 100%; display: block; }
figcaption { color: #666; font-size: .85rem; } table { border-collapse: collapse; width: 100%; }
th, td { text-align: right; padding: .25rem .6rem; border-bottom: 1px solid #ddd; font-variant-numeric: tabular-nums; }
th:first-child, td:first-child, td.words { text-align: left; } tr.too_tight td { background: #fbe3e0; }
tr.stretched td { background: #fdf3d9; } li.warning { color: #8a5a00; } li.error { color: #a3221b; }
footer { margin-top: 2rem; color: #777; font-size: .8rem; overflow-wrap: anywhere; }
)";

std::string text_of(const JsonValue& in, std::string_view key) {
  const JsonValue* value = in.find(key);
  return value != nullptr && value->text() != nullptr ? *value->text() : "";
}

double number_of(const JsonValue& in, std::string_view key) {
  const JsonValue* value = in.find(key);
  return value != nullptr && value->number() != nullptr ? *value->number() : 0;
}

const std::vector<JsonValue>& list_of(const JsonValue& in, std::string_view key) {
  static const std::vector<JsonValue> none;
  const JsonValue* value = in.find(key);
  return value != nullptr && value->array() != nullptr ? *value->array() : none;
}

std::string verdict(const JsonValue& report) {
  const JsonValue* settled = report.find("settled");
  const bool rests = settled != nullptr && settled->boolean() != nullptr && *settled->boolean();
  std::string out = rests ? "At rest" : "Not at rest (" + in_markup(text_of(report, "stop_reason")) + ")";
  const std::string worn = text_of(report, "worn");
  if (worn == "yes") out += ", worn";
  if (worn == "partly") out += ", worn but for an open seam";
  if (worn == "no") out += ", not worn";
  return "<p class=\"verdict\">" + out + ".</p>\n";
}

std::string pictures_part(std::span<const PagePicture> pictures) {
  if (pictures.empty()) return "";
  std::string out = "<div class=\"pictures\">\n";
  for (const PagePicture& p : pictures) {
    const std::string title = in_markup(p.title);
    for (const std::string& part :
         {std::string("<figure><img alt=\""), title, std::string("\" src=\"data:image/png;base64,"),
          base64(p.png), std::string("\"><figcaption>"), title, std::string("</figcaption></figure>\n")}) {
      out += part;
    }
  }
  return out + "</div>\n";
}

std::string cell(std::string_view text, std::string_view attributes = "") {
  return "<td" + std::string(attributes) + ">" + std::string(text) + "</td>";
}

std::string centimetres(const JsonValue& line, std::string_view key) {
  return cell(fixed_text(number_of(line, key) / 10, 1));
}

std::string words_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string fit_part(const JsonValue& report) {
  const std::vector<JsonValue>& lines = list_of(report, "fit");
  if (lines.empty()) return "";
  std::string out =
      "<h2>Fit</h2>\n<table><tr><th>cm</th><th>body</th><th>garment, flat</th><th>ease</th>"
      "<th>as worn</th><th>taken above</th><th></th></tr>\n";
  for (const JsonValue& line : lines) {
    out += "<tr class=\"" + in_markup(text_of(line, "fit")) + "\">" +
           cell(words_of(in_markup(text_of(line, "at")))) + centimetres(line, "body_mm") +
           centimetres(line, "garment_mm") + centimetres(line, "ease_mm") + centimetres(line, "worn_mm") +
           centimetres(line, "shifted_mm") + cell(in_markup(text_of(line, "text")), " class=\"words\"") +
           "</tr>\n";
  }
  return out + "</table>\n";
}

/// What is mended already is nobody's concern any more.
std::string findings_part(const JsonValue& report) {
  std::string out;
  for (const JsonValue& f : list_of(report, "findings")) {
    const JsonValue* repaired = f.find("repaired");
    if (repaired != nullptr && repaired->boolean() != nullptr && *repaired->boolean()) continue;
    const std::string where = text_of(f, "where");
    out += "<li class=\"" + in_markup(text_of(f, "severity")) + "\">" +
           (where.empty() ? "" : "<b>" + in_markup(where) + ":</b> ") + in_markup(text_of(f, "message")) +
           "</li>\n";
  }
  return out.empty() ? "" : "<h2>Findings</h2>\n<ul>\n" + out + "</ul>\n";
}

std::string row(std::string_view name, const std::string& value) {
  return "<tr>" + cell(name) + cell(value) + "</tr>\n";
}

std::string percent(double ratio) { return fixed_text(100 * ratio, 1) + " %"; }

/// 99th percentile of what threads are stretched by.
double stretch_of(const JsonValue& report, std::string_view direction) {
  const JsonValue* strain = report.find("strain");
  const JsonValue* along = strain != nullptr ? strain->find(direction) : nullptr;
  const JsonValue* tension = along != nullptr ? along->find("tension") : nullptr;
  return tension != nullptr ? number_of(*tension, "p99") : 0;
}

std::string figures_part(const JsonValue& report) {
  const JsonValue none;
  const JsonValue* found = report.find("intersections");
  const JsonValue& crossings = found != nullptr ? *found : none;
  const auto whole = [](double n) { return fixed_text(n, 0); };
  return "<h2>Figures</h2>\n<table>\n" +
         row("crossings of cloth with body, with itself",
             whole(number_of(crossings, "cloth_body")) + ", " + whole(number_of(crossings, "cloth_cloth"))) +
         row("widest seam gap", fixed_text(number_of(report, "seam_gap_max_mm"), 2) + " mm") +
         row("stretch along warp, weft (99 % of the cloth below)",
             percent(stretch_of(report, "warp")) + ", " + percent(stretch_of(report, "weft"))) +
         row("height of the cloth", fixed_text(number_of(report, "lowest_m"), 3) + " to " +
                                        fixed_text(number_of(report, "highest_m"), 3) + " m") +
         row("particles, triangles",
             whole(number_of(report, "particles")) + ", " + whole(number_of(report, "triangles"))) +
         row("simulated, processor time", fixed_text(number_of(report, "simulated_s"), 2) + " s, " +
                                              fixed_text(number_of(report, "cpu_s"), 1) + " s") +
         "</table>\n";
}

}  // namespace

std::string report_page(const JsonValue& report, std::span<const PagePicture> pictures) {
  const std::string name = text_of(report, "name"), title = in_markup(name.empty() ? "Drape" : name);
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
         "</title><style>" + std::string(kStyle) + "</style></head><body>\n<h1>" + title + "</h1>\n" +
         verdict(report) + pictures_part(pictures) + fit_part(report) + findings_part(report) +
         figures_part(report) + "<footer>Positions " + in_markup(text_of(report, "hash")) +
         "</footer>\n</body></html>\n";
}

}  // namespace toile::exports
