#include "core/pattern/dxf/entities.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/pattern/dxf/collect.h"
#include "core/pattern/dxf/draft.h"
#include "core/pattern/dxf/group_codes.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/mend.h"

namespace toile::dxf {
namespace {

/// What the HEADER says, one variable after the other.
struct Header {
  std::string variable;  // whose groups come now
  DxfEncoding encoding;

  void hear(const DxfGroup& group, DxfFile& file) {
    if (group.code == 9) variable = std::string(group.value);
    if (variable == "$ACADVER" && group.code == 1) file.version = clean_text(group.value);
    if (variable == "$DWGCODEPAGE" && group.code == 3) encoding = encoding_of(group.value);
    if (group.code != 70 || (variable != "$INSUNITS" && variable != "$MEASUREMENT")) return;
    const std::optional<double> value = number_of(group.value);
    if (!value) return file.log.warn(group.line, variable + " is no number and says nothing");
    (variable == "$INSUNITS" ? file.insunits : file.measurement) = DxfVariable{*value, group.line};
  }
};

/// Where in the file the groups stand.
struct Section {
  std::string name;           // empty outside sections, "?" until its name is read
  int line = 0;               // where it began
  bool had_entities = false;  // a section ENTITIES has ended

  bool holds_drawing() const { return name == "ENTITIES" || name == "BLOCKS"; }
  void end() {
    had_entities = had_entities || name == "ENTITIES";
    name.clear();
  }
};

using Failure = std::optional<Error>;

Error not_dxf(int line) {
  return {"dxf.not_dxf",
          "This is not a DXF file: it does not begin with a section. Export the pattern as ASCII DXF.",
          line_text(line)};
}

/// What the first bytes tell of files that are no text at all.
Failure foreign(DxfGroupReader& reader) {
  const std::string_view text = reader.beginning();
  const std::string way_out = " Export the pattern as ASCII DXF.";
  if (reader.is_binary()) return std::nullopt;
  if (text.starts_with("AC10")) return Error{"dxf.not_dxf", "This is a DWG file." + way_out, line_text(1)};
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return Error{"dxf.not_dxf", "The text is UTF-16; DXF is ASCII or UTF-8." + way_out, line_text(1)};
  const auto holds = [&](std::string_view part) { return text.find(part) != std::string_view::npos; };
  if (text.starts_with("%PDF"))
    return Error{"dxf.not_dxf", "This is a PDF, which is not read as a pattern." + way_out, line_text(1)};
  if (holds("<svg"))
    return Error{"dxf.not_dxf", "This is an SVG, which is not read as a pattern." + way_out, line_text(1)};
  constexpr int kMostZeros = 4;  // a text with a few is a damaged one
  if (std::count(text.begin(), text.end(), '\0') > kMostZeros || text.starts_with("\x89PNG"))
    return Error{"dxf.not_dxf", "This is a binary file of another kind." + way_out, line_text(1)};
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos && reader.only_blanks_left() &&
      !reader.error())
    return Error{"dxf.empty", "The file is empty.", line_text(1)};
  return std::nullopt;
}

/// Says that the file is cut off, and where.
std::string cut_text(const Section& section) {
  const std::string inside =
      section.name.empty() ? ""
                           : ", within section " + section.name + " that began in " + line_text(section.line);
  return "the file ends without EOF" + inside;
}

/// Whether nothing can be missing of an entity behind which the file ends.
bool is_whole(const DxfDraft& d) {
  const auto counted = [&](int code, std::size_t there) {
    return d.numbers.contains(code) && d.number(code) == double(there);
  };
  switch (d.type) {
    case DxfType::kLwPolyline:
      return counted(90, d.vertices.size()) && !d.awaits_y;
    case DxfType::kSpline:
      return counted(73, d.vertices.size()) && counted(72, d.knots.size()) && !d.awaits_y;
    case DxfType::kPolyline:
    case DxfType::kVertex:
      return false;  // SEQEND is missing
    default:
      return true;  // what a group is missing of is found out as ever
  }
}

/// One pass over the groups. It is one object because what a group means hangs on all before it: the section,
/// the entity that is under way, what was mended. What needs no more than its arguments stands above.
class Parser {
 public:
  Parser(std::istream& in, const DxfSettings& settings)
      : reader_(in, settings.max_bytes), settings_(settings), collector_(file_, settings) {}

  Result<DxfFile> run() {
    if (auto error = foreign(reader_)) return *error;
    while (!done_) {
      const std::optional<DxfGroup> group = reader_.next();
      tell(reader_.take_damages());
      if (!group) {
        if (auto error = stopped()) return *error;
        break;
      }
      if (group->code == 999) continue;  // comment
      if (auto error = hear(*group)) return *error;
    }
    return std::move(file_);
  }

 private:
  void tell(std::vector<DxfDamage> damages) {
    for (DxfDamage& damage : damages) {
      if (!file_.fault) file_.fault = Error{"dxf.bad_group_code", damage.text, line_text(damage.line)};
      file_.log.warn(damage.line, std::move(damage.text));
    }
  }

  /// One group, with the code that it must have had.
  Failure hear(const DxfGroup& heard) {
    const DxfDraft* draft = draft_ ? &*draft_ : nullptr;
    const bool at_border = heard.value == "SECTION" || heard.value == "ENDSEC";
    const DxfGroup group =
        section_.holds_drawing() || at_border || !started_ ? mender_.mended(heard, draft) : heard;
    const std::optional<DxfGroup> before = mender_.lost_x(group, draft);
    tell(mender_.take_damages());
    if (!started_ && group.code == kLostCode) return std::nullopt;
    if (!started_ && !(group.code == 0 && (group.value == "SECTION" || group.value == "EOF")))
      return not_dxf(group.line);
    started_ = true;
    if (before)
      if (auto error = take(*before)) return error;
    mender_.taken(group);
    return group.code == 0 ? start(group) : take(group);
  }

  /// The text is at its end without EOF: what stands before is kept, but for an entity that is not whole.
  Failure stopped() {
    const auto& error = reader_.error();
    const auto kind = reader_.fault();
    const bool cut = kind == DxfGroupReader::Fault::kCutOff;
    if (error && !cut && (started_ || kind != DxfGroupReader::Fault::kNoGroup)) return *error;
    if (!started_) return not_dxf(std::max(1, reader_.line()));
    if (section_.name.empty() && section_.had_entities && !cut) {
      file_.log.warn(reader_.line(), "the file ends without EOF, though behind a whole section ENTITIES");
      return std::nullopt;
    }
    if (draft_ && (cut || !reader_.ended_a_line() || !is_whole(*draft_))) {
      collector_.cut_off(*draft_);
      draft_.reset();
    }
    if (auto failure = finish_entity()) return failure;
    const bool polyline_cut = collector_.cut_polyline();
    file_.log.warn(reader_.line(), cut_text(section_) + "; what stands before is read");
    const int last = reader_.line() - (cut ? 1 : 0);
    Error fault{"dxf.truncated", cut_text(section_) + ": it is cut off. Get a whole copy.",
                "last good " + line_text(last)};
    if (!file_.fault || polyline_cut) file_.fault = std::move(fault);
    return std::nullopt;
  }

  Failure start(const DxfGroup& group) {
    if (group.value == "SECTION" || group.value == "ENDSEC" || group.value == "EOF") return boundary(group);
    if (!section_.holds_drawing()) {
      file_.log.elsewhere();
      return std::nullopt;
    }
    if (auto error = finish_entity()) return error;
    draft_ = DxfDraft{};
    draft_->type = dxf_type_of(group.value);
    draft_->name = clean_text(group.value);
    draft_->line = group.line;
    if (draft_->type == DxfType::kVertex || draft_->type == DxfType::kSeqend ||
        draft_->type == DxfType::kAttribute)
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
      section_.end();
      return std::nullopt;
    }
    if (!section_.name.empty()) {
      file_.log.warn(group.line, "ENDSEC is missing before " + std::string(group.value) + ": section " +
                                     section_.name + ", that began in " + line_text(section_.line) +
                                     ", ends here");
      section_.end();
    }
    if (group.value == "EOF") done_ = true;
    if (group.value == "SECTION") {
      section_.name = "?";
      section_.line = group.line;
    }
    return std::nullopt;
  }

  Failure take(const DxfGroup& group) {
    if (section_.name == "?") {
      const bool named = (group.code == 2 && !group.value.empty()) || is_section_name(group.value);
      section_.name = named ? clean_text(group.value) : "without a name";
      return std::nullopt;
    }
    if (section_.name == "HEADER") {
      header_.hear(group, file_);
      return std::nullopt;
    }
    if (!draft_ || take_words(*draft_, group, header_.encoding) || !wants(draft_->type, group.code))
      return std::nullopt;
    if (counts_as_vertex(*draft_, group.code))
      if (auto error = collector_.count_vertex(group.line)) return error;
    take_number(*draft_, group, settings_.max_coordinate_mm);
    return std::nullopt;
  }

  Failure finish_entity() {
    if (!draft_) return std::nullopt;
    DxfDraft draft = std::move(*draft_);
    draft_.reset();
    // Between two blocks there is nothing but what a careless program left there.
    if (section_.name == "BLOCKS" && !collector_.in_block() && draft.type != DxfType::kBlock) {
      file_.log.elsewhere();
      return std::nullopt;
    }
    return collector_.store(draft);
  }

  DxfGroupReader reader_;
  const DxfSettings& settings_;
  DxfFile file_;
  DxfCollector collector_;
  bool started_ = false, done_ = false;
  Section section_;
  DxfMender mender_;
  Header header_;
  std::optional<DxfDraft> draft_;  // the entity whose groups come now
};

}  // namespace

Result<DxfFile> parse_dxf(std::istream& in, const DxfSettings& settings) {
  return Parser(in, settings).run();
}

}  // namespace toile::dxf
