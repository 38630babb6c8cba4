#include "core/sweep/contact_sheet.h"

#include <algorithm>
#include <cstddef>

#include "core/base/check.h"
#include "core/base/markup.h"
#include "core/base/text.h"

namespace toile::sweep {
namespace {

constexpr int kMargin = 24, kGap = 10, kNamesWidth = 150, kHead = 78, kCaption = 38;
constexpr int kColumn = kStillWidth + kGap, kRow = kStillHeight + kCaption + kGap;

std::string at(int x, int y) { return "x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\""; }

std::string sized(int width, int height) {
  return "width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"";
}

/// Clipped by letters: librsvg breaks no lines.
std::string short_of(const std::string& text, std::size_t letters) {
  std::size_t seen = 0, at = 0;
  for (; at < text.size(); ++at) {
    const bool begins = (static_cast<unsigned char>(text[at]) & 0xc0U) != 0x80U;
    if (begins && seen++ == letters) break;
  }
  return at == text.size() ? text : text.substr(0, at) + "…";
}

std::string words(int x, int y, const char* look, const std::string& text, std::size_t letters) {
  return "<text " + at(x, y) + " " + look + ">" + in_markup(short_of(text, letters)) + "</text>\n";
}

constexpr const char* kTitle = "font-size=\"22\" font-weight=\"bold\" fill=\"#222\"";
constexpr const char* kName = "font-size=\"15\" font-weight=\"bold\" fill=\"#222\"";
constexpr const char* kNote = "font-size=\"12.5\" fill=\"#444\"";
constexpr const char* kTrouble = "font-size=\"12.5\" fill=\"#a3221b\"";

std::string verdict(const Figures& f) {
  std::string text = f.worn == "no"       ? "not worn"
                     : f.worn == "partly" ? "partly worn"
                     : f.worn == "yes"    ? "worn"
                                          : "";
  if (!text.empty()) text += ", ";
  return text + (f.settled ? "settled" : "not settled");
}

bool is_well(const Figures& f) {
  return f.settled && f.worn != "no" && f.cloth_body + f.cloth_cloth + f.worst_body + f.worst_cloth == 0;
}

bool is_tight(const Figures& f) {
  for (const std::optional<Ease>& ease : {f.bust, f.waist, f.hip})
    if (ease && ease->fit == "too_tight") return true;
  return false;
}

std::string eases(const Figures& f) {
  std::string text;
  const auto add = [&](const char* name, const std::optional<Ease>& ease) {
    if (!ease) return;
    if (!text.empty()) text += "  ";
    text += std::string(name) + (ease->ease_mm < 0 ? " −" : " +") +
            fixed_text(std::max(ease->ease_mm, -ease->ease_mm) / 10, 1);
  };
  add("bust", f.bust);
  add("waist", f.waist);
  add("hip", f.hip);
  return text.empty() ? text : text + " cm";
}

std::string still(int x, int y, const Cell& cell, const std::string& png) {
  if (!png.empty())
    return "<image " + at(x, y) + " " + sized(kStillWidth, kStillHeight) +
           " preserveAspectRatio=\"xMidYMid slice\" xlink:href=\"data:image/png;base64," + base64(png) +
           "\"/>\n";
  std::string said = "<rect " + at(x, y) + " " + sized(kStillWidth, kStillHeight) + " fill=\"#eee\"/>\n";
  said += words(x + 14, y + kStillHeight / 2, kNote, cell.state, 30);
  return said + words(x + 14, y + kStillHeight / 2 + 18, kNote, cell.reason, 32);
}

std::string caption(int x, int y, const Cell& cell) {
  if (!cell.figures) return "";
  const Figures& f = *cell.figures;
  return words(x + 2, y + 15, is_well(f) ? kNote : kTrouble, verdict(f), 34) +
         words(x + 2, y + 31, is_tight(f) ? kTrouble : kNote, eases(f), 36);
}

}  // namespace

ContactSheet contact_sheet(const Table& table, const std::vector<std::string>& stills) {
  TOILE_CHECK(stills.size() == table.cells.size());
  const int columns = static_cast<int>(table.fabrics.size()), rows = static_cast<int>(table.bodies.size());
  ContactSheet sheet;
  sheet.width = 2 * kMargin + kNamesWidth + columns * kColumn - kGap;
  sheet.height = 2 * kMargin + kHead + rows * kRow - kGap;
  std::string& svg = sheet.svg;
  svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" " +
        sized(sheet.width, sheet.height) + " viewBox=\"0 0 " + std::to_string(sheet.width) + " " +
        std::to_string(sheet.height) + "\" font-family=\"DejaVu Sans, sans-serif\">\n<rect " +
        sized(sheet.width, sheet.height) + " fill=\"#fff\"/>\n";
  svg += words(kMargin, kMargin + 22, kTitle, table.name, 10 + 16 * table.fabrics.size());
  for (int fabric = 0; fabric < columns; ++fabric)
    svg += words(kMargin + kNamesWidth + fabric * kColumn + 2, kMargin + kHead - 10, kName,
                 table.fabrics[static_cast<std::size_t>(fabric)], 26);
  for (int body = 0; body < rows; ++body) {
    const int y = kMargin + kHead + body * kRow;
    svg += words(kMargin, y + 18, kName, table.bodies[static_cast<std::size_t>(body)], 15);
    for (int fabric = 0; fabric < columns; ++fabric) {
      const std::size_t cell =
          static_cast<std::size_t>(body) * table.fabrics.size() + static_cast<std::size_t>(fabric);
      const int x = kMargin + kNamesWidth + fabric * kColumn;
      svg += still(x, y, table.cells[cell], stills[cell]);
      svg += caption(x, y + kStillHeight, table.cells[cell]);
    }
  }
  svg += "</svg>\n";
  return sheet;
}

}  // namespace toile::sweep
