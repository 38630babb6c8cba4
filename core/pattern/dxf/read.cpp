#include "core/pattern/dxf/read.h"

#include <algorithm>
#include <array>
#include <streambuf>
#include <utility>
#include <variant>

#include "core/base/names.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/entities.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/layer_use.h"
#include "core/pattern/dxf/layers.h"
#include "core/pattern/dxf/names.h"
#include "core/pattern/dxf/pieces.h"
#include "core/pattern/dxf/places.h"
#include "core/pattern/dxf/repair.h"
#include "core/pattern/dxf/shared_titles.h"
#include "core/pattern/dxf/sizes.h"
#include "core/pattern/dxf/told_folds.h"
#include "core/pattern/dxf/units.h"

namespace toile::dxf {
namespace {

/// A file as its tables tell it, and where in it the pieces lie. The layout refers to the file.
struct Drawing {
  const DxfFile& file;
  DxfLayout layout;
  DxfLog log;                  ///< what the tables and the layout told
  std::optional<Error> fault;  ///< the first
};

/// One reading of all places in one unit.
struct Attempt {
  std::vector<DxfFound> pieces;
  DxfLog log;
  std::vector<std::string> names;    ///< by the pieces' numbers in the log, those left out included
  std::optional<Error> fault, open;  ///< DxfNotes'; an open line is the last thing to complain of
};

/// Width or height of all that stands in a place, drawing units: a guess where nothing closes.
Vec2 size_of(const DxfPlace& place) {
  std::vector<Vec2> points;
  for (const DxfPart& part : place.parts)
    for (const DxfCurve& c : part.block->curves)
      for (const DxfVertex& v : c.vertices) points.push_back(part.transform(v.at));
  return bounding_box(points).size();
}

/// Tells of what no place has used.
void mark_the_rest(const DxfBlock& block, DxfLog& log, const char* reason) {
  const auto mark = [&](std::size_t entity) {
    if (!log.is_marked(entity)) log.mark(entity, DxfFate::kDropped, reason);
  };
  for (const DxfCurve& c : block.curves) mark(c.entity);
  for (const DxfText& t : block.texts) mark(t.entity);
  for (const DxfMark& m : block.marks) mark(m.entity);
  for (const DxfInsert& i : block.inserts) mark(i.entity);
}

/// Whether any line of the file stands on a layer of sew lines.
bool has_sew_layer(const DxfFile& file, const DxfLayerMap& given) {
  const auto holds = [&](const DxfBlock& block) {
    return std::any_of(block.curves.begin(), block.curves.end(),
                       [&](const DxfCurve& c) { return repeated_role(c.layer, given) == DxfRole::kSew; });
  };
  return holds(file.entities) || std::any_of(file.blocks.begin(), file.blocks.end(), holds);
}

/// The fault of an outline under a code of this format.
Error error_of(const pattern::BadOutline& bad, const std::string& where) {
  const auto code = [&] {
    switch (bad.fault) {
      case pattern::OutlineFault::kNotFinite:
        return "dxf.not_finite";
      case pattern::OutlineFault::kTooFewPoints:
      case pattern::OutlineFault::kZeroArea:
        return "dxf.zero_area";
      case pattern::OutlineFault::kSelfCrossing:
        break;
    }
    return "dxf.self_crossing";
  };
  return {code(), bad.message, where + (bad.where.empty() ? "" : ", " + bad.where)};
}

Error too_many_pieces(const DxfSettings& settings) {
  return {"dxf.too_large",
          "The drawing has more than " + std::to_string(settings.max_loops) +
              " pieces, the limit, or too many points.",
          "", ErrorKind::kTooLarge};
}

/// The piece with clean outlines, or why it cannot be cut.
std::optional<Error> clean(DxfFound& found, const std::string& where, DxfNotes& notes) {
  DxfPiece& piece = found.piece;
  const RepairedOutline onwards = without_backtracks(piece.outline);
  if (!onwards.cut_at.empty())
    notes.warn(piece.line,
               "the outline turned back on itself in " + std::to_string(onwards.cut_at.size()) +
                   (onwards.cut_at.size() == 1 ? " place" : " places") + " and was smoothed, first at " +
                   pattern::place_text(onwards.cut_at[0]),
               found.id, onwards.cut_at[0]);
  const RepairedOutline repaired = without_small_loops(onwards.points);
  for (const Vec2 at : repaired.cut_at)
    notes.warn(piece.line, "a loop of less than 5 mm was cut off the outline at " + pattern::place_text(at),
               found.id, at);
  auto outline = pattern::clean_outline(repaired.points);
  if (const auto* bad = std::get_if<pattern::BadOutline>(&outline)) return error_of(*bad, where);
  piece.outline = std::get<std::vector<Vec2>>(std::move(outline));
  for (std::vector<Vec2>& hole : piece.holes) {
    auto cleaned = pattern::clean_outline(without_backtracks(hole).points);
    if (const auto* bad = std::get_if<pattern::BadOutline>(&cleaned)) return error_of(*bad, where + ", hole");
    hole = std::get<std::vector<Vec2>>(std::move(cleaned));
  }
  return std::nullopt;
}

struct Checked {
  std::vector<DxfFound> pieces;
  DxfNotes notes;
};

/// The pieces that can be cut, their outlines cleaned.
Checked checked(std::vector<DxfFound> pieces) {
  Checked good;
  for (DxfFound& found : pieces) {
    const DxfPiece& piece = found.piece;
    const std::string where = line_text(piece.line) + ", piece " + piece.name;
    const std::optional<Error> error = clean(found, where, good.notes);
    if (!error) {
      good.pieces.push_back(std::move(found));
      continue;
    }
    good.notes.fail(*error);
    for (const std::size_t entity : found.entities)
      good.notes.mark(entity, DxfFate::kDropped, error->message, found.id);
    good.notes.warn(piece.line, "the piece is left out: " + error->message, found.id);
  }
  return good;
}

/// The pieces of all places, with what the places' own texts say of them.
Result<Attempt> pieces_in_places(const Drawing& drawing, const DxfReading& reading) {
  const DxfSettings& settings = reading.settings;
  Attempt attempt{{}, drawing.log, {}, drawing.fault, {}};
  std::size_t drawn = 0;
  int ids = 0;
  for (const DxfPlace& place : drawing.layout.places) {
    DxfPlacePieces made = TRY(pieces_of(place, reading, drawn + 1, ids));
    drawn = made.drawn;
    ids += static_cast<int>(made.pieces.size());
    attempt.log.take(made.notes);
    if (!attempt.fault) attempt.fault = made.notes.fault;
    if (!attempt.open) attempt.open = made.notes.open;
    DxfNamed named = named_by_place(std::move(made.pieces), place, reading.mm_per_unit, attempt.log);
    attempt.log.take(named.notes);
    for (DxfFound& found : named.pieces) attempt.pieces.push_back(std::move(found));
    if (attempt.pieces.size() > settings.max_loops || drawn > settings.max_drawn_points)
      return too_many_pieces(settings);
  }
  attempt.names.resize(std::size_t(ids));
  return attempt;
}

Result<Attempt> read_all(const Drawing& drawing, const DxfReading& reading) {
  Attempt attempt = TRY(pieces_in_places(drawing, reading));
  const DxfTransform to_mm = DxfTransform{}.scaled(reading.mm_per_unit);
  DxfNamed named = named_by_texts(std::move(attempt.pieces), drawing.file.entities.texts, to_mm, attempt.log);
  attempt.log.take(named.notes);
  named = named_by_what_differs(std::move(named.pieces));
  attempt.log.take(named.notes);
  named.pieces = named_apart(counted_by_names(std::move(named.pieces)));
  for (const DxfFound& found : named.pieces) attempt.names[std::size_t(found.id)] = found.piece.name;
  Checked good = checked(std::move(named.pieces));
  attempt.log.take(good.notes);
  if (!attempt.fault) attempt.fault = good.notes.fault;
  named = unfolded_where_told(std::move(good.pieces));
  attempt.log.take(named.notes);
  attempt.pieces = std::move(named.pieces);
  return attempt;
}

/// Width and height of each piece, in drawing units; of each place where nothing closes.
std::vector<Vec2> sizes_of(const Attempt& attempt, const DxfLayout& layout, double mm_per_unit) {
  std::vector<Vec2> sizes;
  for (const DxfFound& found : attempt.pieces)
    sizes.push_back(bounding_box(found.piece.outline).size() * (1 / mm_per_unit));
  if (sizes.empty())
    for (const DxfPlace& place : layout.places) sizes.push_back(size_of(place));
  return sizes;
}

struct InUnit {
  DxfUnit unit;
  Attempt attempt;
};

/// The unit depends on how large the pieces are: they are read in a likely one first.
Result<InUnit> read_in_its_unit(const Drawing& drawing, const DxfSettings& settings) {
  const std::vector<DxfUnitText>& texts = drawing.layout.style.units;
  DxfUnit first =
      settings.mm_per_unit ? given_unit(*settings.mm_per_unit) : decide_unit(drawing.file, texts, {});
  const bool sew_layer = has_sew_layer(drawing.file, settings.layers);
  Attempt attempt = TRY(read_all(drawing, {settings, first.mm, sew_layer}));
  const std::vector<Vec2> sizes = sizes_of(attempt, drawing.layout, first.mm);
  DxfUnit unit = decide_unit(drawing.file, texts, sizes);
  if (settings.mm_per_unit) {
    first.doubt = doubt_of_given(first, unit, sizes);
    if (first.doubt) attempt.log.warn(0, doubt_text(first));
    return InUnit{std::move(first), std::move(attempt)};
  }
  if (unit.mm != first.mm) attempt = TRY(read_all(drawing, {settings, unit.mm, sew_layer}));
  return InUnit{std::move(unit), std::move(attempt)};
}

/// Tells of what no place has used.
void tell_the_rest(const DxfFile& file, DxfLog& log) {
  for (const DxfBlock& block : file.blocks)
    mark_the_rest(block, log, "stands in a block that is not part of the drawing");
  mark_the_rest(file.entities, log, "belongs to no piece");
}

DxfDrawing finished(InUnit read, const Drawing& from, const DxfLayerMap& given) {
  constexpr double kSure = 0.8;  // confidence below which a person should look at the unit
  Attempt& attempt = read.attempt;
  tell_the_rest(from.file, attempt.log);
  if (read.unit.confidence < kSure)
    attempt.log.warn(0, "the unit is not sure: " + read.unit.name +
                            " is the likeliest; compare the sizes of the "
                            "pieces, and give the unit if they are wrong");
  DxfDrawing drawing;
  for (DxfFound& found : attempt.pieces) drawing.pieces.push_back(std::move(found.piece));
  drawing.mm_per_unit = read.unit.mm;
  drawing.unit = std::move(read.unit);
  drawing.style = from.layout.style.name;
  drawing.sample_size = from.layout.style.sample_size;
  drawing.sizes = from.layout.sizes;
  drawing.size = from.layout.size;
  drawing.report = attempt.log.report(attempt.names);
  drawing.layers = layer_uses(drawing.report, from.layout.places, given);
  for (const DxfWarning& w : drawing.report.warnings) drawing.notes.push_back(warning_text(w));
  return drawing;
}

/// "Layers are read as told: 3 as sew, 8 as ignore."
std::string as_told(const DxfLayerMap& given) {
  std::string list;
  for (const auto& [layer, role] : given)
    list += (list.empty() ? "" : ", ") + clipped(layer) + " as " + std::string(role_word(role));
  return list.empty() ? "" : " Layers are read as told: " + list + ".";
}

Error nothing_found(const Attempt& attempt, const DxfLayerMap& given) {
  if (attempt.fault) return *attempt.fault;
  if (attempt.open) return *attempt.open;
  return {
      "dxf.no_outline",
      std::string(
          "The drawing holds no closed outline: neither POLYLINE, LWPOLYLINE, LINE, ARC, CIRCLE, ELLIPSE nor "
          "SPLINE makes one.") +
          as_told(given),
      ""};
}

/// A text in memory as a stream.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // the interface wants it so; nothing is written
    setg(begin, begin, begin + text.size());
  }
};

/// The file's content, but for what is to be ignored. Errors: those of parse_dxf, dxf.unknown_layer.
Result<DxfFile> file_as_told(std::istream& in, const DxfSettings& settings) {
  DxfFile file = TRY(parse_dxf(in, settings));
  TRY(check_layers(file, settings.layers));
  return without_ignored(std::move(file), settings.layers);
}

}  // namespace

Result<DxfDrawing> read_dxf(std::string_view text, const DxfSettings& settings) {
  TextBuffer buffer(text);
  std::istream in(&buffer);
  return read_dxf(in, settings);
}

Result<DxfDrawing> read_dxf(std::istream& in, const DxfSettings& settings) {
  const DxfFile file = TRY(file_as_told(in, settings));
  DxfPlaces places = TRY(places_of(file));
  DxfLayout layout = TRY(in_one_size(std::move(places), settings));
  Drawing drawing{file, std::move(layout), file.log, file.fault};
  drawing.log.take(drawing.layout.notes);
  if (!drawing.fault) drawing.fault = drawing.layout.notes.fault;
  InUnit read = TRY(read_in_its_unit(drawing, settings));
  if (read.attempt.pieces.empty()) return nothing_found(read.attempt, settings.layers);
  return finished(std::move(read), drawing, settings.layers);
}

Result<std::vector<DxfLayerUse>> read_dxf_layers(std::string_view text, const DxfSettings& settings) {
  TextBuffer buffer(text);
  std::istream in(&buffer);
  const DxfFile file = TRY(file_as_told(in, settings));
  DxfPlaces places = TRY(places_of(file));
  const DxfLayout layout = TRY(in_one_size(std::move(places), settings));
  return layer_uses(file.log.report({}), layout.places, settings.layers);
}

bool layers_may_help(std::string_view text, const Error& error) {
  constexpr std::array<std::string_view, 4> kOfOutlines{"dxf.no_outline", "dxf.open_outline", "dxf.zero_area",
                                                        "dxf.self_crossing"};
  if (std::find(kOfOutlines.begin(), kOfOutlines.end(), error.code) == kOfOutlines.end()) return false;
  const Result<std::vector<DxfLayerUse>> layers = read_dxf_layers(text);
  return layers && std::count_if(layers->begin(), layers->end(),
                                 [](const DxfLayerUse& layer) { return layer.drawn; }) > 1;
}

}  // namespace toile::dxf
