#include "core/pattern/dxf/read.h"

#include <algorithm>
#include <streambuf>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/entities.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/names.h"
#include "core/pattern/dxf/pieces.h"
#include "core/pattern/dxf/places.h"
#include "core/pattern/dxf/repair.h"
#include "core/pattern/dxf/units.h"

namespace toile {
namespace {

/// One reading of all places in one unit.
struct Attempt {
  std::vector<DxfFound> pieces;
  DxfLog log;
  std::optional<Error> fault;
  int ids = 0;
};

/// Width or height of all that stands in a place, drawing units: a guess where nothing closes.
double extent_of(const DxfPlace& place) {
  std::vector<Vec2> points;
  for (const DxfPart& part : place.parts)
    for (const DxfCurve& c : part.block->curves)
      for (const DxfVertex& v : c.vertices) points.push_back(part.transform(v.at));
  const Vec2 size = bounding_box(points).size();
  return std::max(size.x, size.y);
}

/// Tells of what no place has used.
void mark_the_rest(const DxfBlock& block, DxfLog& log, const char* reason) {
  const auto mark = [&](std::size_t entity) {
    if (!log.is_marked(entity)) log.mark(entity, DxfFate::dropped, reason);
  };
  for (const DxfCurve& c : block.curves) mark(c.entity);
  for (const DxfText& t : block.texts) mark(t.entity);
  for (const DxfMark& m : block.marks) mark(m.entity);
  for (const DxfInsert& i : block.inserts) mark(i.entity);
}

/// The fault of an outline under a code of this format.
Error as_dxf(const Error& error, const std::string& where) {
  const std::string fault = error.code.substr(error.code.find('.') + 1);
  return {"dxf." + (fault == "too_few_points" ? "zero_area" : fault), error.message,
          where + (error.where.empty() ? "" : ", " + error.where)};
}

/// Reads all places into pieces.
class Reader {
 public:
  Reader(DxfFile file, const DxfSettings& settings) : file_(std::move(file)), settings_(settings) {}

  Result<DxfDrawing> run() {
    DxfLayout layout = TRY(layout_of(file_, settings_));
    layout_ = std::move(layout);
    Attempt attempt = TRY(read_in_its_unit());
    if (attempt.pieces.empty()) return nothing_found(attempt);
    return finished(attempt);
  }

 private:
  /// The unit depends on how large the pieces are: they are read in a likely one first.
  Result<Attempt> read_in_its_unit() {
    unit_ = settings_.mm_per_unit ? given_unit(*settings_.mm_per_unit)
                                  : decide_unit(file_, layout_.style.units, {});
    Result<Attempt> attempt = read_all(unit_.mm);
    if (!attempt || settings_.mm_per_unit) return attempt;
    std::vector<double> extents;
    for (const DxfFound& found : attempt->pieces) {
      const Vec2 size = bounding_box(found.piece.outline).size();
      extents.push_back(std::max(size.x, size.y) / unit_.mm);
    }
    if (extents.empty())
      for (const DxfPlace& place : layout_.places) extents.push_back(extent_of(place));
    const double first = unit_.mm;
    unit_ = decide_unit(file_, layout_.style.units, extents);
    return unit_.mm == first ? std::move(attempt) : read_all(unit_.mm);
  }

  Result<Attempt> read_all(double mm_per_unit) {
    Attempt attempt;
    attempt.log = file_.log;
    DxfContext context{settings_, mm_per_unit, attempt.log, 0, file_.fault, {}};
    for (const DxfPlace& place : layout_.places) {
      context.drawn += 1;
      std::vector<DxfFound> pieces = TRY(pieces_of(place.parts, context, attempt.ids));
      name_pieces(pieces, place, context);
      for (DxfFound& found : pieces) attempt.pieces.push_back(std::move(found));
      if (attempt.pieces.size() > settings_.max_loops || context.drawn > settings_.max_drawn_points)
        return Error{"dxf.too_large",
                     "The drawing has more than " + std::to_string(settings_.max_loops) +
                         " pieces, the limit, or too many points.",
                     ""};
    }
    DxfTransform to_mm;
    to_mm.x = {mm_per_unit, 0};
    to_mm.y = {0, mm_per_unit};
    name_by_texts(attempt.pieces, file_.entities.texts, to_mm, context);
    finish_names(attempt.pieces);
    names_.assign(std::size_t(attempt.ids), {});
    for (const DxfFound& found : attempt.pieces) names_[std::size_t(found.id)] = found.piece.name;
    check(attempt.pieces, context);
    attempt.fault = context.fault ? context.fault : context.open;
    return attempt;
  }

  /// Cleans the outlines; leaves out the pieces that cannot be cut.
  static void check(std::vector<DxfFound>& pieces, DxfContext& context) {
    std::vector<DxfFound> good;
    for (DxfFound& found : pieces) {
      const DxfPiece& piece = found.piece;
      const std::string where = line_text(piece.line) + ", piece " + piece.name;
      const std::optional<Error> error = clean(found, context, where);
      if (!error) {
        good.push_back(std::move(found));
        continue;
      }
      context.fail(*error);
      for (const std::size_t entity : found.entities)
        context.log.mark(entity, DxfFate::dropped, error->message, found.id);
      context.log.warn(piece.line, "the piece is left out: " + error->message, found.id);
    }
    pieces = std::move(good);
  }

  static std::optional<Error> clean(DxfFound& found, DxfContext& context, const std::string& where) {
    DxfPiece& piece = found.piece;
    const RepairedOutline repaired = without_small_loops(piece.outline);
    for (const Vec2 at : repaired.cut_at)
      context.log.warn(piece.line, "a loop of less than 5 mm was cut off the outline at " + place_text(at),
                       found.id, at);
    Result<std::vector<Vec2>> outline = clean_outline(repaired.points);
    if (!outline) return as_dxf(outline.error(), where);
    piece.outline = std::move(*outline);
    for (std::vector<Vec2>& hole : piece.holes) {
      Result<std::vector<Vec2>> cleaned = clean_outline(hole);
      if (!cleaned) return as_dxf(cleaned.error(), where + ", hole");
      hole = std::move(*cleaned);
    }
    return std::nullopt;
  }

  Result<DxfDrawing> finished(Attempt& attempt) {
    DxfDrawing drawing;
    for (const DxfBlock& block : file_.blocks)
      mark_the_rest(block, attempt.log, "stands in a block that is not part of the drawing");
    mark_the_rest(file_.entities, attempt.log, "belongs to no piece");
    if (unit_.confidence < 0.8)
      attempt.log.warn(0, "the unit is not sure: " + unit_.name +
                              " is the likeliest; compare the sizes of the "
                              "pieces, and give the unit if they are wrong");
    for (DxfFound& found : attempt.pieces) drawing.pieces.push_back(std::move(found.piece));
    drawing.mm_per_unit = unit_.mm;
    drawing.unit = unit_;
    drawing.style = layout_.style.name;
    drawing.sample_size = layout_.style.sample_size;
    drawing.sizes = layout_.sizes;
    drawing.size = layout_.size;
    drawing.report = attempt.log.report(names_);
    for (const DxfWarning& w : drawing.report.warnings) drawing.notes.push_back(warning_text(w));
    return drawing;
  }

  static Error nothing_found(const Attempt& attempt) {
    if (attempt.fault) return *attempt.fault;
    return {
        "dxf.no_outline",
        "The drawing holds no closed outline: neither POLYLINE, LWPOLYLINE, LINE, ARC, CIRCLE, ELLIPSE nor "
        "SPLINE makes one.",
        ""};
  }

  DxfFile file_;
  const DxfSettings& settings_;
  DxfLayout layout_;
  DxfUnit unit_;
  std::vector<std::string> names_;  // by the pieces' numbers in the log
};

/// A text in memory as a stream.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // the interface wants it so; nothing is written
    setg(begin, begin, begin + text.size());
  }
};

}  // namespace

Result<DxfDrawing> read_dxf(std::string_view text, const DxfSettings& settings) {
  TextBuffer buffer(text);
  std::istream in(&buffer);
  return read_dxf(in, settings);
}

Result<DxfDrawing> read_dxf(std::istream& in, const DxfSettings& settings) {
  DxfFile file = TRY(parse_dxf(in, settings));
  return Reader(std::move(file), settings).run();
}

}  // namespace toile
