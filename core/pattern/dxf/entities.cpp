#include "core/pattern/dxf/entities.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/pattern/dxf/collect.h"
#include "core/pattern/dxf/draft.h"
#include "core/pattern/dxf/groups.h"

namespace toile {
namespace {

constexpr double kMostBulge = 1e3;  // beyond, an arc is a full circle but for a thousandth

class Parser {
 public:
  Parser(std::istream& in, const DxfSettings& settings)
      : reader_(in, settings.max_bytes), settings_(settings), collector_(file_, settings) {}

  Result<DxfFile> run() {
    if (auto error = foreign(reader_.beginning())) return *error;
    while (!done_) {
      const std::optional<DxfGroup> group = reader_.next();
      if (!group) {
        if (auto error = stopped()) return *error;
        break;
      }
      if (group->code == 999) continue;  // comment
      if (!started_ && !(group->code == 0 && (group->value == "SECTION" || group->value == "EOF")))
        return not_dxf(group->line);
      started_ = true;
      if (auto error = group->code == 0 ? start(*group) : take(*group)) return *error;
    }
    return std::move(file_);
  }

 private:
  using Failure = std::optional<Error>;

  static Error not_dxf(int line) {
    return {"dxf.not_dxf",
            "This is not a DXF file: it does not begin with a section. Export the pattern as ASCII DXF.",
            line_text(line)};
  }

  /// What the first bytes tell of files that are no text at all.
  Failure foreign(std::string_view text) {
    const std::string way_out = " Export the pattern as ASCII DXF.";
    if (text.starts_with("AutoCAD Binary DXF"))
      return Error{"dxf.binary", "This is a binary DXF file; only the ASCII form is read." + way_out,
                   line_text(1)};
    if (text.starts_with("AC10")) return Error{"dxf.not_dxf", "This is a DWG file." + way_out, line_text(1)};
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
      return Error{"dxf.not_dxf", "The text is UTF-16; DXF is ASCII or UTF-8." + way_out, line_text(1)};
    if (text.find('\0') != std::string_view::npos || text.starts_with("\x89PNG"))
      return Error{"dxf.not_dxf", "This is a binary file of another kind." + way_out, line_text(1)};
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos && reader_.only_blanks_left() &&
        !reader_.error())
      return Error{"dxf.empty", "The file is empty.", line_text(1)};
    return std::nullopt;
  }

  /// The text is at its end without EOF: what stands before is kept, but for an entity that is not whole.
  Failure stopped() {
    const auto& error = reader_.error();
    const bool cut = error && error->code == "dxf.truncated";
    if (error && !cut && (started_ || error->code != "dxf.bad_group_code")) return *error;
    if (!started_) return not_dxf(std::max(1, reader_.line()));
    if (section_.empty() && had_entities_ && !cut) {
      file_.log.warn(reader_.line(), "the file ends without EOF, though behind a whole section ENTITIES");
      return std::nullopt;
    }
    if (draft_ && (cut || !reader_.ended_a_line() || !is_whole(*draft_))) {
      collector_.cut_off(*draft_);
      draft_.reset();
    }
    if (auto failure = finish_entity()) return failure;
    const bool polyline_cut = collector_.cut_polyline();
    file_.log.warn(reader_.line(), cut_text() + "; what stands before is read");
    const int last = reader_.line() - (cut ? 1 : 0);
    Error fault{"dxf.truncated", cut_text() + ": it is cut off. Get a whole copy.",
                "last good " + line_text(last)};
    if (!file_.fault || polyline_cut) file_.fault = std::move(fault);
    return std::nullopt;
  }

  std::string cut_text() const {
    const std::string inside =
        section_.empty() ? "" : ", within section " + section_ + " that began in " + line_text(section_line_);
    return "the file ends without EOF" + inside;
  }

  /// Whether nothing can be missing of an entity behind which the file ends.
  static bool is_whole(const DxfDraft& d) {
    const auto counted = [&](int code, std::size_t there) {
      return d.numbers.contains(code) && d.number(code) == double(there);
    };
    switch (d.type) {
      case DxfType::lwpolyline:
        return counted(90, d.vertices.size()) && !d.awaits_y;
      case DxfType::spline:
        return counted(73, d.vertices.size()) && counted(72, d.knots.size()) && !d.awaits_y;
      case DxfType::polyline:
      case DxfType::vertex:
        return false;  // SEQEND is missing
      default:
        return true;  // what a group is missing of is found out as ever
    }
  }

  Failure start(const DxfGroup& group) {
    if (group.value == "SECTION" || group.value == "ENDSEC" || group.value == "EOF") return boundary(group);
    if (!collecting()) return file_.log.elsewhere(), std::nullopt;
    if (auto error = finish_entity()) return error;
    draft_ = DxfDraft{};
    draft_->type = dxf_type_of(group.value);
    draft_->name = clean_text(group.value);
    draft_->line = group.line;
    if (draft_->type == DxfType::vertex || draft_->type == DxfType::seqend ||
        draft_->type == DxfType::attribute)
      return std::nullopt;
    if (!reader_.ended_a_line() && group.value != "ENDBLK")
      return std::nullopt;  // half a word, perhaps VERTEX
    collector_.end_polyline(group.line);
    if (group.value != "ENDBLK") return std::nullopt;
    file_.log.structure();
    collector_.end_block();
    draft_.reset();
    return std::nullopt;
  }

  Failure boundary(const DxfGroup& group) {
    if (auto error = finish_entity()) return error;
    collector_.end_polyline(group.line);
    collector_.end_block();
    file_.log.structure();
    if (group.value == "ENDSEC") {
      had_entities_ = had_entities_ || section_ == "ENTITIES";
      section_.clear();
      return std::nullopt;
    }
    if (!section_.empty()) {
      file_.log.warn(group.line, "ENDSEC is missing before " + std::string(group.value) + ": section " +
                                     section_ + ", that began in " + line_text(section_line_) +
                                     ", ends here");
      had_entities_ = had_entities_ || section_ == "ENTITIES";
      section_.clear();
    }
    if (group.value == "EOF") done_ = true;
    if (group.value == "SECTION") {
      section_ = "?";
      section_line_ = group.line;
    }
    return std::nullopt;
  }

  bool collecting() const { return section_ == "ENTITIES" || section_ == "BLOCKS"; }

  Failure take(const DxfGroup& group) {
    if (section_ == "?") {
      section_ = group.code == 2 && !group.value.empty() ? clean_text(group.value) : "without a name";
      return std::nullopt;
    }
    if (section_ == "HEADER") return header_value(group), std::nullopt;
    if (!draft_) return std::nullopt;
    DxfDraft& d = *draft_;
    switch (group.code) {
      case 8:
        d.layer = clean_text(group.value, encoding_);
        return std::nullopt;
      case 1:
      case 3:
        return words(group), std::nullopt;
      case 2:
        d.reference = clean_text(group.value, encoding_);
        return std::nullopt;
      default:
        return wants(d.type, group.code) ? number(group) : std::nullopt;
    }
  }

  /// Long MTEXTs come in several groups 3 and a last group 1.
  void words(const DxfGroup& group) {
    DxfDraft& d = *draft_;
    if (d.type == DxfType::mtext) {
      d.text = clean_text(d.text + clean_text(plain_text(group.value), encoding_), DxfEncoding::latin);
    } else if (group.code == 1) {
      d.text = clean_text(group.value, encoding_);
    }
  }

  void header_value(const DxfGroup& group) {
    if (group.code == 9) variable_ = std::string(group.value);
    if (variable_ == "$ACADVER" && group.code == 1) file_.version = clean_text(group.value);
    if (variable_ == "$DWGCODEPAGE" && group.code == 3) encoding_ = encoding_of(group.value);
    if (group.code != 70 || (variable_ != "$INSUNITS" && variable_ != "$MEASUREMENT")) return;
    const std::optional<double> value = number_of(group.value);
    if (!value) return file_.log.warn(group.line, variable_ + " is no number and says nothing");
    (variable_ == "$INSUNITS" ? file_.insunits : file_.measurement) = DxfVariable{*value, group.line};
  }

  Failure number(const DxfGroup& group) {
    DxfDraft& d = *draft_;
    std::optional<double> v = number_of(group.value);
    const std::string held = "Group " + std::to_string(group.code) + " of " + d.name + " holds ";
    const auto fault = [&](const char* code, const std::string& message) {
      if (!d.fault) d.fault = Error{code, message, line_text(group.line)};
      v = 0;
    };
    if (!v) {
      fault("dxf.bad_number",
            held + "'" + clean_text(group.value.substr(0, 40)) + "' where a finite number belongs.");
    } else if (out_of_range(d, group.code, *v)) {
      fault("dxf.coordinate_range",
            held + clean_text(group.value.substr(0, 40)) + ", which is beyond any pattern.");
    }
    if (d.type == DxfType::lwpolyline || d.type == DxfType::spline) return listed(group, *v);
    d.numbers[group.code] = *v;
    return std::nullopt;
  }

  bool out_of_range(const DxfDraft& d, int code, double v) const {
    if (code == 42 && d.type != DxfType::insert && d.type != DxfType::ellipse)
      return std::abs(v) > kMostBulge;
    const bool length = code == 10 || code == 20 || code == 11 || code == 21 ||
                        (code == 40 && d.type != DxfType::spline && d.type != DxfType::ellipse);
    return length && std::abs(v) > settings_.max_coordinate_mm;
  }

  /// Groups that repeat within one entity.
  Failure listed(const DxfGroup& group, double v) {
    DxfDraft& d = *draft_;
    const auto point = [&](std::vector<DxfVertex>& list, bool& awaits_y, bool is_x) {
      if (is_x && awaits_y && !d.fault)
        d.fault = Error{"dxf.missing_coordinate",
                        "The " + d.name + " has no group " + std::to_string(group.code + 10) + ".",
                        line_text(d.line)};
      if (is_x) list.push_back({{v, 0}, 0});
      if (!is_x && awaits_y) list.back().at.y = v;
      awaits_y = is_x;
    };
    const bool spline = d.type == DxfType::spline;
    const bool counts = group.code == 10 || (spline && (group.code == 11 || group.code == 40));
    if (counts)
      if (auto error = collector_.count_vertex(group.line)) return error;
    if (group.code == 10 || group.code == 20) {
      point(d.vertices, d.awaits_y, group.code == 10);
    } else if (spline && (group.code == 11 || group.code == 21)) {
      point(d.through, d.through_awaits_y, group.code == 11);
    } else if (group.code == 42 && !d.vertices.empty()) {
      d.vertices.back().bulge = v;
    } else if (group.code == 40) {
      d.knots.push_back(v);
    } else if (group.code == 41) {
      d.weights.push_back(v);
    } else {
      d.numbers[group.code] = v;
    }
    return std::nullopt;
  }

  Failure finish_entity() {
    if (!draft_) return std::nullopt;
    DxfDraft draft = std::move(*draft_);
    draft_.reset();
    // Between two blocks there is nothing but what a careless program left there.
    if (section_ == "BLOCKS" && !collector_.in_block() && draft.type != DxfType::block)
      return file_.log.elsewhere(), std::nullopt;
    return collector_.store(draft);
  }

  DxfGroupReader reader_;
  const DxfSettings& settings_;
  DxfFile file_;
  DxfCollector collector_;
  bool started_ = false, done_ = false, had_entities_ = false;
  std::string section_, variable_;  // section_: empty outside sections, "?" until its name is read
  int section_line_ = 0;
  std::optional<DxfDraft> draft_;
  DxfEncoding encoding_ = DxfEncoding::unknown;
};

}  // namespace

Result<DxfFile> parse_dxf(std::istream& in, const DxfSettings& settings) {
  return Parser(in, settings).run();
}

}  // namespace toile
