#include "core/pattern/dxf/names.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/words.h"

namespace toile {
namespace {

/// Distance from the outline, 0 inside; nothing when the text stands too far beside the piece to belong to
/// it.
std::optional<double> nearness(const DxfPiece& piece, const Aabb2& box, Vec2 at) {
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
  bool stated = false, named = false;  // "Piece Name: …"; a word rather than a figure or a mark
  double height = 0, off = 0;
  int line = 0;
  std::string name;
  std::size_t entity = 0;
  bool better(const Title& b) const {
    if (stated != b.stated) return stated;
    if (named != b.named) return named;
    if (height != b.height) return height > b.height;
    return off != b.off ? off < b.off : line < b.line;
  }
};

/// Words name pieces; figures and single letters are labels of points.
bool is_word(const std::string& text) {
  int letters = 0;
  for (const char c : text) {
    const bool letter =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
    letters += letter ? 1 : 0;
  }
  return letters >= 2 && text.front() != '#';
}

/// Gives the piece what the statement says. What it tells in the report; empty: nothing for a piece.
std::string take_statement(DxfPiece& piece, const DxfStatement& s, DxfContext& context, int id, int line) {
  if (s.key == "quantity" || s.key == "qty") {
    const auto quantity = quantity_of(s.value);
    const int sum = quantity ? quantity->as_drawn + quantity->mirrored : 0;
    if (sum < 1) {
      context.log.warn(line, "the quantity says '" + s.value + "'; one piece is read", id);
      return "quantity, of no use";
    }
    // Two of a kind are a left one and a right one; what is cut on the fold is its own mirror image.
    const bool pairs = !quantity->told_apart && !piece.unfolded;
    piece.quantity = sum;
    piece.mirrored = pairs ? sum / 2 : quantity->mirrored;
    return piece.mirrored > 0 ? "quantity, some of them turned over" : "quantity";
  }
  if (s.key == "size") return "size of the piece";
  if (s.key == "category") return piece.category = s.value, "category";
  if (s.key == "material" || s.key == "fabric") return piece.material = s.value, "material";
  if (s.key == "annotation") {
    if (piece.annotation.empty()) piece.annotation = s.value;
    const std::string words = lower(s.value);
    if (!piece.unfolded && words.find("on fold") != std::string::npos)
      context.log.warn(line, "the piece is to be cut on the fold, but no mirror line says where it lies", id);
    return "annotation";
  }
  return "";
}

void finish_name(DxfPiece& piece, const std::string& name) {
  if (piece.name.empty() && !is_lost(name)) piece.name = name;
}

}  // namespace

void name_pieces(std::vector<DxfFound>& pieces, const DxfPlace& place, DxfContext& context) {
  if (!place.is_block) return;
  std::set<std::size_t> taken;
  for (DxfFound& found : pieces) found.piece.size = place.size;
  if (pieces.size() == 1) {
    DxfPiece& piece = pieces[0].piece;
    if (place.name_is_stated) piece.name = place.name;
    std::set<std::string> own;
    const auto hear = [&](const DxfText& text) {
      const std::optional<DxfStatement> s = statement_of(text.text);
      std::string told = s->key == "piece name" ? "name of the piece" : "";
      if (s->key == "piece name" && is_lost(s->value))
        context.log.warn(text.line,
                         "the piece's name was lost ('" + s->value + "'): it is called " + place.name,
                         pieces[0].id);
      if (told.empty()) told = take_statement(piece, *s, context, pieces[0].id, text.line);
      if (told.empty()) return;
      own.insert(s->key);
      taken.insert(text.entity);
      context.log.mark(text.entity, DxfFate::converted, told, pieces[0].id);
    };
    for (const DxfText* text : place.statements) hear(*text);
    for (const DxfText* text : place.inherited)
      if (const auto s = statement_of(text->text);
          s && !own.contains(s->key) && s->key != "size" && s->key != "piece name")
        hear(*text);
  }
  for (const DxfPart& part : place.parts) {
    DxfTransform to_mm = part.transform;
    to_mm.x = to_mm.x * context.mm_per_unit;
    to_mm.y = to_mm.y * context.mm_per_unit;
    to_mm.origin = to_mm.origin * context.mm_per_unit;
    std::vector<DxfText> rest;
    for (const DxfText& text : part.block->texts)
      if (!taken.contains(text.entity)) rest.push_back(text);
    name_by_texts(pieces, rest, to_mm, context);
  }
  for (DxfFound& found : pieces) finish_name(found.piece, place.name);
}

void name_by_texts(std::vector<DxfFound>& pieces, const std::vector<DxfText>& texts,
                   const DxfTransform& to_mm, DxfContext& context) {
  constexpr std::size_t kMostTexts = 5000;  // bounds the work on files of nothing but text
  std::vector<Aabb2> boxes;
  for (const DxfFound& p : pieces) boxes.push_back(bounding_box(p.piece.outline));
  std::vector<std::optional<Title>> titles(pieces.size());
  for (std::size_t t = 0; t < texts.size(); ++t) {
    const DxfText& text = texts[t];
    if (context.log.is_marked(text.entity)) continue;
    const std::optional<DxfStatement> statement = statement_of(text.text);
    const bool stated = statement && statement->key == "piece name" && !statement->value.empty();
    context.log.mark(text.entity, DxfFate::dropped,
                     statement ? "says nothing of a piece's shape" : "a label");
    if (t >= kMostTexts) continue;
    Title title{stated, false, text.height, 0, text.line, stated ? statement->value : text.text, text.entity};
    title.named = is_word(title.name) && !is_lost(title.name);
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::optional<double> off = nearness(pieces[i].piece, boxes[i], to_mm(text.at));
      if (off && (!nearest || *off < title.off)) {
        nearest = i;
        title.off = *off;
      }
    }
    if (!nearest) continue;
    if (statement && !stated) {
      const std::string told =
          take_statement(pieces[*nearest].piece, *statement, context, pieces[*nearest].id, text.line);
      if (!told.empty()) context.log.mark(text.entity, DxfFate::converted, told, pieces[*nearest].id);
      continue;
    }
    if (!titles[*nearest] || title.better(*titles[*nearest])) titles[*nearest] = title;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!titles[i] || !pieces[i].piece.name.empty() || is_lost(titles[i]->name)) continue;
    pieces[i].piece.name = titles[i]->name;
    context.log.mark(titles[i]->entity, DxfFate::converted, "name of the piece", pieces[i].id);
  }
}

void finish_names(std::vector<DxfFound>& pieces) {
  std::set<std::string> taken;
  for (const DxfFound& p : pieces) taken.insert(p.piece.name);
  std::set<std::string> used;
  std::map<std::string, int> twins;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::string& name = pieces[i].piece.name;
    if (name.empty()) name = "piece" + std::to_string(i + 1);
    const std::string stem = name;
    while (used.contains(name) || (name != stem && taken.contains(name)))
      name = stem + "-" + std::to_string(std::max(2, ++twins[stem] + 1));
    used.insert(name);
  }
}

}  // namespace toile
