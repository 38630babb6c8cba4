#include "core/pattern/dxf/names.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/told_folds.h"
#include "core/pattern/dxf/told_quantity.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {
namespace {

/// Distance from the outline, 0 inside; nothing when the text stands too far beside the piece to belong to
/// it.
std::optional<double> nearness(const std::vector<Vec2>& outline, const Aabb2& box, Vec2 at, double reach) {
  if (!box.grown(reach).contains(at)) return std::nullopt;
  if (geometry::contains(outline, at)) return 0.0;
  double nearest = length(outline[0] - at);
  for (std::size_t i = 0, n = outline.size(); i < n; ++i)
    nearest = std::min(nearest, geometry::distance_to_segment(at, outline[i], outline[(i + 1) % n]));
  return nearest;
}

/// A text that may name a piece. The order is that of preference.
struct Title {
  bool stated = false, named = false;  // "Piece Name: …"; a word rather than a figure or a mark
  bool brief = false;                  // a few words, as names are: titles of the drawing say more
  double height = 0, off = 0;
  int line = 0;
  std::string name;
  std::size_t entity = 0;
  bool better(const Title& b) const {
    if (stated != b.stated) return stated;
    if (named != b.named) return named;
    if (brief != b.brief) return brief;
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

/// Whether the text is there to tell how often a piece is cut, whatever else it says.
bool tells_how_often(std::string_view text) {
  return tells_only_quantity(text) || is_cutting_order(text) || begins_with_count(text);
}

/// Two of a kind are a left one and a right one; what is cut on the fold is its own mirror image.
void count(DxfPiece& piece, const DxfQuantity& quantity) {
  piece.quantity = quantity.as_drawn + quantity.mirrored;
  piece.counted = true;
  piece.mirrored = quantity.told_apart || piece.unfolded ? quantity.mirrored : piece.quantity / 2;
}

/// "Quantity: 2" and the like.
std::string take_quantity(DxfFound& found, const std::string& value, int line, DxfNotes& notes) {
  auto quantity = told_quantity(value);  // "CUT 2", "1 paire"
  if (!quantity) quantity = quantity_of(value);
  if (!quantity || quantity->as_drawn + quantity->mirrored < 1) {
    notes.warn(line, "the quantity says '" + value + "'; one piece is read", found.id);
    return "quantity, of no use";
  }
  count(found.piece, *quantity);
  return found.piece.mirrored > 0 ? "quantity, some of them turned over" : "quantity";
}

/// Notes that the text says of the piece that it is cut on the fold, if it does; `at`: where it stands, mm.
void hear_of_fold(DxfFound& found, const std::string& text, int line, std::optional<Vec2> at) {
  if (tells_fold(text) && !found.fold.line) found.fold.line = line;
  if (at && tells_only_fold(text)) found.fold.labels.push_back(*at);
}

std::string take_annotation(DxfFound& found, const std::string& value) {
  if (found.piece.annotation.empty()) found.piece.annotation = value;
  return "annotation";
}

/// Gives the piece what the statement says. What it tells in the report; empty: nothing for a piece.
std::string take_statement(DxfFound& found, const DxfStatement& s, int line, DxfNotes& notes) {
  if (s.key == "quantity") return take_quantity(found, s.value, line, notes);
  if (s.key == "annotation") return take_annotation(found, s.value);
  if (s.key == "size") return "size of the piece";
  if (s.key == "category") {
    found.piece.category = s.value;
    return "category";
  }
  if (s.key == "material") {
    found.piece.material = s.value;
    return "material";
  }
  return "";
}

/// What the only piece of a place has heard from the place's statements.
struct Heard {
  std::set<std::string> keys;
  std::set<std::size_t> entities;  ///< texts that said something
};

void hear(const DxfText& text, const DxfPlace& place, DxfFound& found, Heard& heard, DxfNotes& notes) {
  const std::optional<DxfStatement> s = statement_of(text.text);
  const bool name = s->key == "piece name";
  if (name && is_lost(s->value))
    notes.warn(text.line, "the piece's name was lost ('" + s->value + "'): it is called " + place.name,
               found.id);
  hear_of_fold(found, s->value, text.line, std::nullopt);
  const std::string told = name ? "name of the piece" : take_statement(found, *s, text.line, notes);
  if (told.empty()) return;
  heard.keys.insert(s->key);
  heard.entities.insert(text.entity);
  notes.mark(text.entity, DxfFate::kConverted, told, found.id);
}

/// Gives the place's only piece its statements; those of the sample size where it has none of its own.
Heard hear_statements(DxfFound& found, const DxfPlace& place, DxfNotes& notes) {
  Heard heard;
  if (place.name_is_stated) found.piece.name = place.name;
  for (const DxfText* text : place.statements) hear(*text, place, found, heard, notes);
  for (const DxfText* text : place.inherited)
    if (const auto s = statement_of(text->text);
        s && !heard.keys.contains(s->key) && s->key != "size" && s->key != "piece name")
      hear(*text, place, found, heard, notes);
  return heard;
}

/// A text as a title: its statement's value when it states a name.
Title title_of(const DxfText& text, const std::optional<DxfStatement>& statement) {
  const bool stated = statement && statement->key == "piece name" && !statement->value.empty();
  constexpr std::size_t kBrief = 5;  // words
  Title title{stated,     false, false, text.height, 0, text.line, stated ? statement->value : text.text,
              text.entity};
  title.brief = words_of_name(title.name).size() <= kBrief;
  title.named = is_word(title.name) && !is_lost(title.name) && !tells_only_quantity(title.name) &&
                !is_cutting_order(title.name) && !tells_only_fold(title.name);
  return title;
}

struct Nearest {
  std::size_t piece = 0;
  double off = 0;  ///< mm
};

/// How far beside a piece a text may stand that is so high, mm. By its height it reaches as far whatever unit
/// the drawing is taken in.
double reach_of(double height) {
  constexpr double kReach = 20;   // mm
  constexpr double kHeights = 4;  // of the text
  return std::max(kReach, kHeights * height);
}

std::optional<Nearest> nearest_piece(const std::vector<DxfFound>& pieces, const std::vector<Aabb2>& boxes,
                                     Vec2 at, double reach) {
  std::optional<Nearest> nearest;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::optional<double> off = nearness(pieces[i].drawn(), boxes[i], at, reach);
    if (off && (!nearest || *off < nearest->off)) nearest = Nearest{i, *off};
  }
  return nearest;
}

/// The piece that the text begins in, else the one that its middle lies in, as of a title that is wider than
/// its strip, else the nearest to where it begins.
std::optional<Nearest> piece_of_text(const std::vector<DxfFound>& pieces, const std::vector<Aabb2>& boxes,
                                     const DxfText& text, const DxfTransform& to_mm) {
  constexpr double kWide = 0.7;  // times the height, a letter
  const double reach = reach_of(length(to_mm.turned({0, text.height})));
  const std::optional<Nearest> first = nearest_piece(pieces, boxes, to_mm(text.at), reach);
  if (first && first->off == 0) return first;
  const auto letters = std::count_if(text.text.begin(), text.text.end(),
                                     [](char c) { return (c & 0xC0) != 0x80; });  // of UTF-8
  const double half = 0.5 * kWide * text.height * static_cast<double>(letters);
  const std::optional<Nearest> middle = nearest_piece(pieces, boxes, to_mm(text.at + Vec2{half, 0}), reach);
  return middle && middle->off == 0 ? middle : first;
}

}  // namespace

DxfNamed named_by_place(std::vector<DxfFound> pieces, const DxfPlace& place, double mm_per_unit,
                        const DxfLog& log) {
  DxfNamed named{std::move(pieces), {}};
  if (!place.is_block) return named;
  for (DxfFound& found : named.pieces) found.piece.size = place.size;
  std::set<std::size_t> taken;  // texts that this place has told of
  if (named.pieces.size() == 1) taken = hear_statements(named.pieces[0], place, named.notes).entities;
  for (const DxfPart& part : place.parts) {
    std::vector<DxfText> rest;
    for (const DxfText& text : part.block->texts)
      if (!taken.contains(text.entity)) rest.push_back(text);
    DxfNamed more = named_by_texts(std::move(named.pieces), rest, part.transform.scaled(mm_per_unit), log);
    named.pieces = std::move(more.pieces);
    named.notes.add(std::move(more.notes));
    for (const DxfText& text : rest) taken.insert(text.entity);
  }
  for (DxfFound& found : named.pieces) {
    if (is_lost(place.name)) continue;
    if (found.piece.name.empty()) found.piece.name = place.name;
    found.titles.push_back({place.name, std::nullopt});
  }
  return named;
}

DxfNamed named_by_texts(std::vector<DxfFound> pieces, const std::vector<DxfText>& texts,
                        const DxfTransform& to_mm, const DxfLog& log) {
  constexpr std::size_t kMostTexts = 5000;  // bounds the work on files of nothing but text
  DxfNamed named{std::move(pieces), {}};
  std::vector<Aabb2> boxes;
  for (const DxfFound& p : named.pieces) boxes.push_back(bounding_box(p.drawn()));
  std::vector<std::vector<Title>> titles(named.pieces.size());
  for (std::size_t t = 0; t < texts.size(); ++t) {
    const DxfText& text = texts[t];
    if (log.is_marked(text.entity)) continue;
    const std::optional<DxfStatement> statement = statement_of(text.text);
    named.notes.mark(text.entity, DxfFate::kDropped,
                     statement ? "says nothing of a piece's shape" : "a label");
    if (t >= kMostTexts) continue;
    const std::optional<Nearest> nearest = piece_of_text(named.pieces, boxes, text, to_mm);
    if (!nearest) continue;
    Title title = title_of(text, statement);
    title.off = nearest->off;
    DxfFound& found = named.pieces[nearest->piece];
    hear_of_fold(found, text.text, text.line, to_mm(text.at));
    if (statement && !title.stated) {
      const std::string told = take_statement(found, *statement, text.line, named.notes);
      if (!told.empty()) named.notes.mark(text.entity, DxfFate::kConverted, told, found.id);
      continue;
    }
    if (const auto quantity = told_quantity(text.text);
        quantity && !found.piece.counted && tells_how_often(text.text)) {
      count(found.piece, *quantity);
      named.notes.mark(text.entity, DxfFate::kConverted, "quantity", found.id);
    }
    titles[nearest->piece].push_back(std::move(title));
  }
  for (std::size_t i = 0; i < titles.size(); ++i) {
    DxfFound& found = named.pieces[i];
    std::stable_sort(titles[i].begin(), titles[i].end(),
                     [](const Title& a, const Title& b) { return a.better(b); });
    if (!found.piece.name.empty() || titles[i].empty() || is_lost(titles[i][0].name)) continue;
    found.piece.name = titles[i][0].name;
    named.notes.mark(titles[i][0].entity, DxfFate::kConverted, "name of the piece", found.id);
    for (const Title& title : titles[i])
      if (title.named && !titles[i][0].stated) found.titles.push_back({title.name, title.entity});
  }
  return named;
}

std::vector<DxfFound> counted_by_names(std::vector<DxfFound> pieces) {
  constexpr std::size_t kSeveral = 3;  // pieces
  std::map<std::string, int> drawn;
  std::set<int> told;
  for (const DxfFound& p : pieces) {
    const auto quantity = told_quantity(p.piece.name);
    told.insert(quantity ? quantity->as_drawn : 0);
    ++drawn[p.piece.name];
  }
  if (told.size() == 1 && pieces.size() >= kSeveral) return pieces;  // "2X" is a size
  for (DxfFound& p : pieces)
    if (const auto quantity = told_quantity(p.piece.name); quantity && !p.piece.counted)
      if (drawn[p.piece.name] == 1) count(p.piece, *quantity);
  return pieces;
}

std::vector<DxfFound> named_apart(std::vector<DxfFound> pieces) {
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
  return pieces;
}

}  // namespace toile::dxf
