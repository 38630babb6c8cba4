#include "core/pattern/dxf_entities.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/pattern/dxf_draft.h"
#include "core/pattern/dxf_groups.h"

namespace toile {
namespace {

constexpr double kMostBulge = 1e3;  // beyond, an arc is a full circle but for a thousandth
constexpr std::string_view kBinarySentinel = "AutoCAD Binary DXF";

std::string lower(std::string_view s) {
  std::string out(s);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return out;
}

class Parser {
 public:
  Parser(std::string_view text, const DxfSettings& settings) : reader_(text), settings_(settings) {}

  Result<DxfFile> run() {
    while (!done_) {
      const std::optional<DxfGroup> group = reader_.next();
      if (!group) return stopped();
      if (group->code == 999) continue;  // comment
      if (!started_ && !(group->code == 0 && (group->value == "SECTION" || group->value == "EOF")))
        return not_dxf(group->line);
      started_ = true;
      if (auto error = group->code == 0 ? start(*group) : take(*group)) return *error;
    }
    return finished();
  }

 private:
  using Failure = std::optional<Error>;

  static Error not_dxf(int line) {
    return {"dxf.not_dxf",
            "This is not a DXF file: it does not begin with a section. Export the pattern as ASCII DXF.",
            line_text(line)};
  }

  Error stopped() const {
    if (reader_.error() && (started_ || reader_.error()->code == "dxf.truncated")) return *reader_.error();
    if (!started_) return not_dxf(std::max(1, reader_.line()));
    return truncated("The file ends without EOF");
  }

  Error truncated(const std::string& what) const {
    const std::string inside =
        section_.empty() ? "" : ", within section " + section_ + " that began in " + line_text(section_line_);
    return {"dxf.truncated", what + inside + ": it is cut off. Get a whole copy.",
            "last good line " + std::to_string(reader_.line())};
  }

  Failure start(const DxfGroup& group) {
    if (group.value == "SECTION" || group.value == "ENDSEC" || group.value == "EOF") return boundary(group);
    if (!collecting()) return std::nullopt;
    if (auto error = finish_entity()) return error;
    draft_ = DxfDraft{};
    draft_->type = dxf_type_of(group.value);
    draft_->name = clean_text(group.value);
    draft_->line = group.line;
    if (group.value == "ENDBLK") {
      end_polyline(group.line);
      in_block_ = false;
      draft_.reset();
      return std::nullopt;
    }
    if (draft_->type == DxfType::vertex || draft_->type == DxfType::seqend) return std::nullopt;
    end_polyline(group.line);
    return ++entities_ > settings_.max_entities
               ? Failure(too_large("entities", settings_.max_entities, group.line))
               : std::nullopt;
  }

  Failure boundary(const DxfGroup& group) {
    if (auto error = finish_entity()) return error;
    end_polyline(group.line);
    if (group.value == "ENDSEC") {
      in_block_ = false;
      section_.clear();
      return std::nullopt;
    }
    if (!section_.empty()) return truncated("ENDSEC is missing before " + std::string(group.value));
    if (group.value == "EOF") done_ = true;
    if (group.value == "SECTION") section_ = "?", section_line_ = group.line;
    return std::nullopt;
  }

  bool collecting() const { return section_ == "ENTITIES" || section_ == "BLOCKS"; }

  Failure take(const DxfGroup& group) {
    if (section_ == "?") {
      section_ = group.code == 2 && !group.value.empty() ? clean_text(group.value) : "without a name";
      return std::nullopt;
    }
    if (section_ == "HEADER") return header_value(group);
    if (!draft_) return std::nullopt;
    DxfDraft& d = *draft_;
    switch (group.code) {
      case 8:
        d.layer = clean_text(group.value);
        return std::nullopt;
      case 1:
        d.text = clean_text(group.value);
        return std::nullopt;
      case 2:
        d.reference = clean_text(group.value);
        return std::nullopt;
      default:
        return wants(d.type, group.code) ? number(group) : std::nullopt;
    }
  }

  Failure header_value(const DxfGroup& group) {
    if (group.code == 9) variable_ = std::string(group.value);
    if (group.code != 70 || variable_ != "$INSUNITS") return std::nullopt;
    const std::optional<double> units = number_of(group.value);
    if (!units) return bad_number(group, "$INSUNITS");
    static const std::map<double, double> kMillimetres{{1, 25.4}, {2, 304.8}, {4, 1}, {5, 10}, {6, 1000}};
    const auto it = kMillimetres.find(*units);
    if (it == kMillimetres.end())
      file_.notes.add(group.line, "$INSUNITS " + clean_text(group.value) +
                                      " names no unit known here; coordinates are read as mm");
    file_.mm_per_unit = it == kMillimetres.end() ? 1 : it->second;
    return std::nullopt;
  }

  static Error bad_number(const DxfGroup& group, const std::string& of) {
    return {"dxf.bad_number",
            "Group " + std::to_string(group.code) + " of " + of + " holds '" +
                clean_text(group.value.substr(0, 40)) + "' where a finite number belongs.",
            line_text(group.line)};
  }

  static Error too_large(const std::string& what, std::size_t limit, int line) {
    return {"dxf.too_large",
            "The drawing has more than " + std::to_string(limit) + " " + what + ", the limit.",
            line_text(line)};
  }

  Failure number(const DxfGroup& group) {
    DxfDraft& d = *draft_;
    const std::optional<double> v = number_of(group.value);
    if (!v) return bad_number(group, d.name);
    const bool length = group.code == 10 || group.code == 20 || group.code == 11 || group.code == 21 ||
                        (group.code == 40 && d.type != DxfType::spline);
    const double scale = settings_.mm_per_unit.value_or(file_.mm_per_unit);
    if ((length && std::abs(*v) * scale > settings_.max_coordinate_mm) ||
        (group.code == 42 && std::abs(*v) > kMostBulge && d.type != DxfType::insert))
      return Error{"dxf.coordinate_range",
                   "Group " + std::to_string(group.code) + " of " + d.name + " holds " +
                       clean_text(group.value.substr(0, 40)) + ", which is beyond any pattern.",
                   line_text(group.line)};
    if (d.type == DxfType::lwpolyline || d.type == DxfType::spline) return listed(group, *v);
    d.numbers[group.code] = *v;
    return std::nullopt;
  }

  /// Groups that repeat within one entity.
  Failure listed(const DxfGroup& group, double v) {
    DxfDraft& d = *draft_;
    if (group.code == 10 || (d.type == DxfType::spline && (group.code == 40 || group.code == 41)))
      if (++vertices_ > settings_.max_vertices * (group.code == 10 ? 1 : 3))
        return too_large("vertices", settings_.max_vertices, group.line);
    if (group.code == 10) {
      if (d.awaits_y) return missing(d, 20);
      d.vertices.push_back({{v, 0}, 0});
      d.awaits_y = true;
    } else if (group.code == 20 && d.awaits_y) {
      d.vertices.back().at.y = v;
      d.awaits_y = false;
    } else if (group.code == 42 && !d.vertices.empty()) {
      d.vertices.back().bulge = v;
    } else if (group.code == 40) {
      d.knots.push_back(v);
    } else if (group.code == 41) {
      d.weights.push_back(v);
    } else if (group.code != 20) {
      d.numbers[group.code] = v;
    }
    return std::nullopt;
  }

  static Error missing(const DxfDraft& d, int code) {
    return {"dxf.missing_coordinate", "The " + d.name + " has no group " + std::to_string(code) + ".",
            line_text(d.line)};
  }

  Failure need(std::initializer_list<int> codes) const {
    for (int code : codes)
      if (!draft_->numbers.contains(code)) return missing(*draft_, code);
    return std::nullopt;
  }

  Failure finish_entity() {
    if (!draft_) return std::nullopt;
    Failure error = store();
    draft_.reset();
    return error;
  }

  Failure store() {
    DxfDraft& d = *draft_;
    if (d.type == DxfType::block) return begin_block();
    if (section_ == "BLOCKS" && !in_block_) return std::nullopt;
    if (d.flags(kPaperSpace) == 1) {
      file_.notes.add(d.line, d.name + " lies in paper space and is passed over");
      return std::nullopt;
    }
    switch (d.type) {
      case DxfType::polyline:
        return begin_polyline();
      case DxfType::vertex:
        return add_vertex();
      case DxfType::seqend:
        end_polyline(0);
        return std::nullopt;
      case DxfType::lwpolyline:
        return add_lwpolyline();
      case DxfType::line:
        return add_line();
      case DxfType::arc:
        return add_arc(need({10, 20, 40, 50, 51}));
      case DxfType::circle:
        return add_arc(need({10, 20, 40}));
      case DxfType::spline:
        return add_spline();
      case DxfType::text:
        add_text();
        return std::nullopt;
      case DxfType::insert:
        add_insert();
        return std::nullopt;
      default:
        skip(d);
        return std::nullopt;
    }
  }

  DxfBlock& target() { return in_block_ ? file_.blocks.back() : file_.entities; }

  Failure begin_block() {
    in_block_ = true;
    file_.blocks.push_back({draft_->reference, draft_->at(), {}, {}});
    return std::nullopt;
  }

  DxfCurve curve_of(const DxfDraft& d) const {
    DxfCurve c;
    c.layer = d.layer, c.line = d.line, c.mirrored = d.mirrored();
    return c;
  }

  Failure begin_polyline() {
    const DxfDraft& d = *draft_;
    polyline_ = curve_of(d);
    polyline_->closed = (d.flags() & 1) != 0;
    polyline_skipped_ = (d.flags() & (16 | 64)) != 0;  // meshes
    if (polyline_skipped_) skip(d);
    return std::nullopt;
  }

  Failure add_vertex() {
    const DxfDraft& d = *draft_;
    if (!polyline_) {
      file_.notes.add(d.line, "VERTEX outside a POLYLINE is passed over");
      return std::nullopt;
    }
    if (polyline_skipped_ || (d.flags() & 16) != 0)
      return std::nullopt;  // 16: control point of a drawn spline
    if (auto error = need({10, 20})) return error;
    if (++vertices_ > settings_.max_vertices) return too_large("vertices", settings_.max_vertices, d.line);
    polyline_->vertices.push_back({d.at(), d.number(42)});
    return std::nullopt;
  }

  /// `line` is where something else begins although SEQEND is missing, 0 at a SEQEND.
  void end_polyline(int line) {
    if (!polyline_) return;
    if (line > 0)
      file_.notes.add(polyline_->line, "POLYLINE without SEQEND; it ends before " + line_text(line));
    if (!polyline_skipped_) target().curves.push_back(std::move(*polyline_));
    polyline_.reset();
  }

  Failure add_lwpolyline() {
    DxfDraft& d = *draft_;
    if (d.awaits_y) return missing(d, 20);
    DxfCurve c = curve_of(d);
    c.closed = (d.flags() & 1) != 0;
    c.vertices = std::move(d.vertices);
    target().curves.push_back(std::move(c));
    return std::nullopt;
  }

  Failure add_line() {
    if (auto error = need({10, 20, 11, 21})) return error;
    DxfCurve c = curve_of(*draft_);
    c.vertices = {{draft_->at(), 0}, {{draft_->number(11), draft_->number(21)}, 0}};
    target().curves.push_back(std::move(c));
    return std::nullopt;
  }

  Failure add_arc(Failure lacking) {
    if (lacking) return lacking;
    const DxfDraft& d = *draft_;
    DxfCurve c = curve_of(d);
    c.kind = DxfCurve::Kind::arc;
    c.vertices = {{d.at(), 0}};
    c.radius = std::abs(d.number(40)), c.start = d.number(50), c.end = d.number(51);
    c.closed = d.type == DxfType::circle;
    target().curves.push_back(std::move(c));
    return std::nullopt;
  }

  Failure add_spline() {
    DxfDraft& d = *draft_;
    if (d.awaits_y) return missing(d, 20);
    const std::size_t n = d.vertices.size(), degree = std::size_t(d.flags(71));
    const bool sound = degree >= 1 && degree <= 11 && n > degree && d.knots.size() == n + degree + 1 &&
                       (d.weights.empty() || d.weights.size() == n) &&
                       std::is_sorted(d.knots.begin(), d.knots.end()) &&
                       std::all_of(d.weights.begin(), d.weights.end(), [](double w) { return w > 0; });
    if (!sound) {
      file_.notes.add(d.line, "SPLINE on layer " + d.layer +
                                  " has no usable knots and control points and is passed over");
      return std::nullopt;
    }
    DxfCurve c = curve_of(d);
    c.kind = DxfCurve::Kind::spline;
    c.degree = int(degree), c.closed = false;
    c.vertices = std::move(d.vertices), c.knots = std::move(d.knots), c.weights = std::move(d.weights);
    target().curves.push_back(std::move(c));
    return std::nullopt;
  }

  void add_text() {
    const DxfDraft& d = *draft_;
    const std::string key = lower(d.text);
    if (key.starts_with("units:"))
      file_.notes.add(d.line,
                      "text says '" + d.text + "'; it does not change the units, the reader's settings do");
    if (!d.text.empty()) target().texts.push_back({d.text, d.at(), d.line});
  }

  void add_insert() {
    const DxfDraft& d = *draft_;
    if (in_block_)
      return file_.notes.add(d.line, "INSERT of " + d.reference + " within a block is passed over");
    if (d.number(70, 1) > 1 || d.number(71, 1) > 1)
      file_.notes.add(d.line, "INSERT of " + d.reference + " as an array: its first copy is read");
    file_.inserts.push_back(
        {d.reference, d.at(), {d.number(41, 1), d.number(42, 1)}, d.number(50), d.mirrored(), d.line});
  }

  void skip(const DxfDraft& d) {
    file_.notes.count(d.line, d.name + " on layer " + d.layer + " passed over: makes no outline");
  }

  Result<DxfFile> finished() {
    if (settings_.mm_per_unit) file_.mm_per_unit = *settings_.mm_per_unit;
    return std::move(file_);
  }

  DxfGroupReader reader_;
  const DxfSettings& settings_;
  DxfFile file_;
  bool started_ = false, done_ = false, in_block_ = false;
  std::string section_, variable_;  // section_: empty outside sections, "?" until its name is read
  int section_line_ = 0;
  std::optional<DxfDraft> draft_;
  std::optional<DxfCurve> polyline_;
  bool polyline_skipped_ = false;
  std::size_t entities_ = 0, vertices_ = 0;
};

/// What the first bytes tell of files that are no text at all.
std::optional<Error> foreign(std::string_view text) {
  const std::string way_out = " Export the pattern as ASCII DXF.";
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return Error{"dxf.empty", "The file is empty.", line_text(1)};
  if (text.starts_with(kBinarySentinel))
    return Error{"dxf.binary", "This is a binary DXF file; only the ASCII form is read." + way_out,
                 line_text(1)};
  if (text.starts_with("AC10")) return Error{"dxf.not_dxf", "This is a DWG file." + way_out, line_text(1)};
  if (text.substr(0, 1024).find('\0') != std::string_view::npos || text.starts_with("\x89PNG"))
    return Error{"dxf.not_dxf", "This is a binary file of another kind." + way_out, line_text(1)};
  return std::nullopt;
}

}  // namespace

Result<DxfFile> parse_dxf(std::string_view text, const DxfSettings& settings) {
  if (text.size() > settings.max_bytes)
    return Error{"dxf.too_large",
                 "The file has more than " + std::to_string(settings.max_bytes) + " bytes, the limit.", ""};
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  if (auto error = foreign(text)) return *error;
  return Parser(text, settings).run();
}

}  // namespace toile
