#include "core/pattern/dxf_read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf_chains.h"
#include "core/pattern/dxf_entities.h"
#include "core/pattern/dxf_groups.h"
#include "core/pattern/dxf_layers.h"

namespace toile {
namespace {

/// All that is drawn in one place: the entities, or one insert of a block.
struct Place {
  const DxfBlock* block = nullptr;
  DxfTransform transform;
  bool inserted = false;
};

/// Blocks of the program's own, such as *Model_Space and $Paper_Space.
bool is_internal(const DxfBlock& block) {
  return block.name.empty() || block.name.front() == '*' || block.name.front() == '$';
}

Result<std::vector<Place>> places_of(const DxfFile& file) {
  std::map<std::string, const DxfBlock*> blocks;
  for (const DxfBlock& block : file.blocks) blocks.emplace(block.name, &block);
  std::vector<Place> places;
  for (const DxfInsert& insert : file.inserts) {
    const auto it = blocks.find(insert.block);
    if (it == blocks.end())
      return Error{"dxf.unknown_block",
                   "INSERT names the block '" + insert.block + "', which the file does not hold.",
                   line_text(insert.line)};
    places.push_back({it->second, transform_of(insert, *it->second), true});
  }
  if (!file.entities.curves.empty()) places.push_back({&file.entities, {}, false});
  if (places.empty())
    for (const DxfBlock& block : file.blocks)
      if (!is_internal(block)) places.push_back({&block, {}, true});
  return places;
}

std::string lower(std::string s) {
  for (char& c : s)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return s;
}

constexpr std::string_view kPieceName = "piece name:";

/// The name that "Piece Name: front" states, empty for other texts.
std::string stated_name(const std::string& text) {
  if (!lower(text).starts_with(kPieceName)) return {};
  const std::size_t begin = text.find_first_not_of(' ', kPieceName.size());
  return begin == std::string::npos ? std::string() : text.substr(begin);
}

/// Texts such as "Size: M" or "Cut by: hand" tell of the piece and do not name it.
bool is_statement(const std::string& text) {
  constexpr std::size_t kLongestKey = 24;
  const std::size_t colon = text.find(':');
  return colon != std::string::npos && colon > 0 && colon <= kLongestKey &&
         (colon + 1 == text.size() || text[colon + 1] == ' ');
}

/// Distance from the outline, 0 inside; nothing when the text stands too far beside the piece to belong to
/// it.
std::optional<double> nearness(const DxfPiece& piece, const Box2& box, Vec2 at) {
  constexpr double kTextReach = 20;  // mm
  if (!box.grown(kTextReach).contains(at)) return std::nullopt;
  if (contains(piece.outline, at)) return 0.0;
  double nearest = length(piece.outline[0] - at);
  for (std::size_t i = 0, n = piece.outline.size(); i < n; ++i)
    nearest = std::min(nearest, distance_to_segment(at, piece.outline[i], piece.outline[(i + 1) % n]));
  return nearest;
}

/// A text that may name a piece. The order is that of preference.
struct Title {
  bool stated = false;
  double off = 0;
  int line = 0;
  std::string name;
  bool better(const Title& b) const {
    if (stated != b.stated) return stated;
    return off != b.off ? off < b.off : line < b.line;
  }
};

/// Names pieces after the texts in or beside them: each text goes to the piece nearest to it.
void name_by_texts(std::vector<DxfPiece>& pieces, const std::vector<DxfText>& texts) {
  constexpr std::size_t kMostTexts = 2000;  // bounds the work on files of nothing but text
  std::vector<Box2> boxes;
  for (const DxfPiece& p : pieces) boxes.push_back(bounding_box(p.outline));
  std::vector<std::optional<Title>> titles(pieces.size());
  for (std::size_t t = 0; t < std::min(texts.size(), kMostTexts); ++t) {
    const std::string stated = stated_name(texts[t].text);
    if (stated.empty() && is_statement(texts[t].text)) continue;
    Title title{!stated.empty(), 0, texts[t].line, stated.empty() ? texts[t].text : stated};
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::optional<double> off = nearness(pieces[i], boxes[i], texts[t].at);
      if (off && (!nearest || *off < title.off)) nearest = i, title.off = *off;
    }
    if (nearest && (!titles[*nearest] || title.better(*titles[*nearest]))) titles[*nearest] = title;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (titles[i] && pieces[i].name.empty()) pieces[i].name = titles[i]->name;
}

/// Reads all places into pieces.
class Reader {
 public:
  Reader(DxfFile file, const DxfSettings& settings) : file_(std::move(file)), settings_(settings) {}

  Result<DxfDrawing> run() {
    Result<std::vector<Place>> places = places_of(file_);
    if (!places) return places.error();
    for (const Place& place : *places)
      if (auto error = read(place)) return *error;
    if (drawing_.pieces.empty()) return nothing_found();
    name_by_texts(drawing_.pieces, in_mm(file_.entities.texts, {}));
    finish_names();
    for (DxfPiece& piece : drawing_.pieces)
      if (auto error = check(piece)) return *error;
    drawing_.mm_per_unit = file_.mm_per_unit;
    drawing_.notes = file_.notes.told();
    return std::move(drawing_);
  }

 private:
  std::optional<Error> read(const Place& place) {
    drawn_ += place.block->texts.size() + 1;
    Result<std::vector<DxfChain>> chains =
        chains_of(*place.block, place.transform, file_.mm_per_unit, settings_, drawn_);
    if (!chains) return chains.error();
    for (const DxfChain& c : *chains)
      if (!c.closed && !open_) open_ = c;
    Result<std::vector<DxfPiece>> pieces = pieces_of_chains(*chains, settings_, file_.notes);
    if (!pieces) return pieces.error();
    if (place.inserted) name_after_block(*pieces, place);
    loops_ += pieces->size();
    if (loops_ > settings_.max_loops)
      return Error{"dxf.too_large",
                   "The drawing has more than " + std::to_string(settings_.max_loops) + " pieces, the limit.",
                   ""};
    for (DxfPiece& p : *pieces) drawing_.pieces.push_back(std::move(p));
    return std::nullopt;
  }

  std::vector<DxfText> in_mm(const std::vector<DxfText>& texts, const DxfTransform& transform) const {
    std::vector<DxfText> moved = texts;
    for (DxfText& t : moved) t.at = transform(t.at) * file_.mm_per_unit;
    return moved;
  }

  void name_after_block(std::vector<DxfPiece>& pieces, const Place& place) const {
    if (pieces.size() == 1)
      for (const DxfText& t : place.block->texts)
        if (pieces[0].name.empty()) pieces[0].name = stated_name(t.text);
    name_by_texts(pieces, in_mm(place.block->texts, place.transform));
    for (DxfPiece& p : pieces)
      if (p.name.empty()) p.name = place.block->name;
  }

  /// Gives the nameless a number and twins a suffix.
  void finish_names() {
    std::set<std::string> taken;
    for (const DxfPiece& p : drawing_.pieces) taken.insert(p.name);
    std::set<std::string> used;
    std::map<std::string, int> twins;
    for (std::size_t i = 0; i < drawing_.pieces.size(); ++i) {
      std::string& name = drawing_.pieces[i].name;
      if (name.empty()) name = "piece" + std::to_string(i + 1);
      const std::string stem = name;
      while (used.contains(name) || (name != stem && taken.contains(name)))
        name = stem + "-" + std::to_string(std::max(2, ++twins[stem] + 1));
      used.insert(name);
    }
  }

  static std::optional<Error> check(DxfPiece& piece) {
    const std::string where = line_text(piece.line) + ", piece " + piece.name;
    Result<std::vector<Vec2>> outline = clean_outline(piece.outline);
    if (!outline) return as_dxf(outline.error(), where);
    piece.outline = std::move(*outline);
    for (std::vector<Vec2>& hole : piece.holes) {
      Result<std::vector<Vec2>> cleaned = clean_outline(hole);
      if (!cleaned) return as_dxf(cleaned.error(), where + ", hole");
      hole = std::move(*cleaned);
    }
    return std::nullopt;
  }

  /// The fault of an outline under a code of this format.
  static Error as_dxf(const Error& error, const std::string& where) {
    const std::string fault = error.code.substr(error.code.find('.') + 1);
    return {"dxf." + (fault == "too_few_points" ? "zero_area" : fault), error.message,
            where + (error.where.empty() ? "" : ", " + error.where)};
  }

  Error nothing_found() const {
    if (open_) return open_outline(*open_);
    return {"dxf.no_outline",
            "The drawing holds no closed outline: neither POLYLINE, LWPOLYLINE, LINE, ARC, CIRCLE nor SPLINE "
            "makes one.",
            ""};
  }

  DxfFile file_;
  const DxfSettings& settings_;
  DxfDrawing drawing_;
  std::optional<DxfChain> open_;  // the first line that does not close
  std::size_t drawn_ = 0, loops_ = 0;
};

}  // namespace

Result<DxfDrawing> read_dxf(std::string_view text, const DxfSettings& settings) {
  Result<DxfFile> file = parse_dxf(text, settings);
  if (!file) return file.error();
  return Reader(std::move(*file), settings).run();
}

Result<DxfDrawing> read_dxf(std::istream& in, const DxfSettings& settings) {
  std::string text;
  std::array<char, 1 << 16> buffer;
  // One byte over the limit is enough to know.
  while (text.size() <= settings.max_bytes && (in.read(buffer.data(), buffer.size()), in.gcount() > 0))
    text.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
  return read_dxf(text, settings);
}

Result<Panel> panel_from_piece(const DxfPiece& piece, std::span<const Vec2> forced_corners,
                               const OutlineSettings& settings) {
  const auto place = [&](Error error) {
    error.where = "piece " + piece.name + (error.where.empty() ? "" : ", " + error.where);
    return error;
  };
  Result<Loop> outline = loop_from_polyline(piece.outline, forced_corners, settings);
  if (!outline) return place(outline.error());
  Panel panel;
  panel.id = piece.name;
  panel.outline = std::move(*outline);
  panel.grain = piece.grain.value_or(Vec2{0, 1});
  for (std::size_t h = 0; h < piece.holes.size(); ++h) {
    Result<Loop> hole = loop_from_polyline(piece.holes[h], {}, settings);
    if (!hole) return place(hole.error());
    panel.holes.push_back(reversed(*hole));
    for (PanelEdge& edge : panel.holes.back().edges)
      edge.id = std::string("h").append(std::to_string(h)).append(edge.id);
  }
  return panel;
}

}  // namespace toile
