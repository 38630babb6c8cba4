#include "core/pattern/dxf/mend.h"

#include "core/pattern/dxf/group_codes.h"

namespace toile::dxf {
namespace {

constexpr int kToY = 10;  // from the code of an x to that of its y
constexpr int kName = 2, kLayer = 8, kFlags = 70, kComment = 999;

bool is_x(int code) { return code == 10 || code == 11; }

bool has_name(const DxfDraft& draft) {
  return draft.type == DxfType::kBlock || draft.type == DxfType::kInsert;
}

bool is_words(DxfType type) {
  return type == DxfType::kText || type == DxfType::kMtext || type == DxfType::kAttribute;
}

/// Whether this entity may hold a word of its own under this code.
bool may_hold_word(int code, const DxfDraft& draft) {
  switch (code) {
    case 1:
    case 3:
      return is_words(draft.type) || draft.type == DxfType::kBlock;
    case kName:
      return is_words(draft.type) || has_name(draft) || draft.type == DxfType::kSkipped;
    case kLayer:
      return !draft.has_layer;
    case 6:  // line type
    case 7:  // style
      return true;
    default:
      return false;
  }
}

/// Names that nobody gives to layers, blocks or styles.
bool is_border(std::string_view value) {
  return value == "SECTION" || value == "ENDSEC" || value == "ENDBLK" || value == "SEQEND" ||
         value == "VERTEX";
}

/// Whether the entity still lacks the x whose y the code is.
bool lacks_x_of(const DxfDraft& draft, int code) {
  if (!is_x(code - kToY) || !wants(draft.type, code)) return false;
  if (lists_points(draft)) return code == 20 && !draft.awaits_y;
  return !draft.numbers.contains(code - kToY);
}

std::string told(const DxfGroup& group, int code) {
  const std::string found = group.code == kLostCode ? "a group code that cannot be read"
                                                    : "the group code " + std::to_string(group.code);
  return found + " is taken for " + std::to_string(code) + ", by what stands around it";
}

/// Whether the name of a record stands behind a code that it is no value of.
bool hides_a_record(const DxfGroup& group, const DxfDraft* draft) {
  if (group.code == 0 || group.code == kComment || !is_record_name(group.value)) return false;
  const bool words = draft && is_words(draft->type) && (group.code == 1 || group.code == 3);
  return !words && (!draft || is_border(group.value) || !may_hold_word(group.code, *draft));
}

}  // namespace

/// The code of a coordinate behind another one.
std::optional<int> DxfMender::true_coordinate(const DxfGroup& group, const DxfDraft& draft) const {
  const int next = last_code_ + kToY;
  if (group.code == next || !is_one_off(group.code, next)) return std::nullopt;
  if (is_x(last_code_) && wants(draft.type, next)) return next;
  const bool again = draft.numbers.contains(group.code) && wants(draft.type, group.code);
  if (is_x(last_code_ - kToY) && again && !lists_points(draft)) return next;  // z
  return std::nullopt;
}

std::optional<int> DxfMender::true_code(const DxfGroup& group, const DxfDraft* draft) const {
  if (hides_a_record(group, draft)) return 0;
  if (!draft) return std::nullopt;
  const bool lost = group.code == kLostCode, figure = number_of(group.value).has_value();
  if (figure && !lost)
    if (const std::optional<int> code = true_coordinate(group, *draft)) return code;
  // No record is called by a figure.
  if (group.code == 0 && figure) return draft->has_layer ? kComment : kLayer;
  if (lost && last_code_ == 0 && !draft->has_layer) return kLayer;
  const bool names = lost || group.code == 0 || group.code == 1 || group.code == 4 || group.code == 9;
  if (names && !figure && has_name(*draft) && draft->has_layer && draft->reference.empty()) return kName;
  const bool may_close = draft->type == DxfType::kPolyline || draft->type == DxfType::kLwPolyline;
  const bool flags = lost || (group.code != kFlags && is_one_off(group.code, kFlags));
  if (may_close && flags && !wants(draft->type, group.code) && !draft->numbers.contains(kFlags) &&
      group.value == "1")
    return kFlags;
  return std::nullopt;
}

DxfGroup DxfMender::mended(const DxfGroup& group, const DxfDraft* draft) {
  const std::optional<int> code = mends_ < kMostMends ? true_code(group, draft) : std::nullopt;
  if (!code) return group;
  ++mends_;
  damages_.push_back({group.line - 1, told(group, *code)});
  return {*code, group.value, group.line};
}

std::optional<DxfGroup> DxfMender::lost_x(const DxfGroup& group, const DxfDraft* draft) {
  const int x = group.code - kToY;
  if (!draft || !lacks_x_of(*draft, group.code) || last_code_ == x || !is_one_off(last_code_, x) ||
      !number_of(last_value_))
    return std::nullopt;
  const DxfGroup found{last_code_, last_value_, last_line_};
  damages_.push_back({last_line_ - 1, told(found, x)});
  return DxfGroup{x, last_value_, last_line_};
}

void DxfMender::taken(const DxfGroup& group) {
  last_code_ = group.code;
  last_line_ = group.line;
  last_value_ = std::string(group.value.substr(0, 64));
}

}  // namespace toile::dxf
