#include "core/pattern/dxf/group_codes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "core/base/text.h"
#include "core/pattern/dxf/draft.h"
#include "core/pattern/dxf/groups.h"

namespace toile::dxf {
namespace {

/// Codes from `first` on, to the next row.
struct Range {
  int first;
  DxfValueKind kind;
};
using enum DxfValueKind;
constexpr std::array<Range, 35> kRanges{
    {{-5, kText},     {10, kReal},     {60, kShort},    {80, kUnknown},   {90, kInteger},  {100, kText},
     {110, kReal},    {150, kUnknown}, {160, kLong},    {170, kShort},    {180, kUnknown}, {210, kReal},
     {240, kUnknown}, {270, kShort},   {290, kBoolean}, {300, kText},     {310, kChunk},   {320, kText},
     {370, kShort},   {390, kText},    {400, kShort},   {410, kText},     {420, kInteger}, {430, kText},
     {440, kInteger}, {460, kReal},    {470, kText},    {482, kUnknown},  {999, kText},    {1004, kChunk},
     {1005, kText},   {1010, kReal},   {1060, kShort},  {1071, kInteger}, {1072, kUnknown}}};

}  // namespace

DxfValueKind value_kind_of(int code) {
  const auto behind = std::upper_bound(kRanges.begin(), kRanges.end(), code,
                                       [](int c, const Range& range) { return c < range.first; });
  return behind == kRanges.begin() ? kUnknown : std::prev(behind)->kind;
}

bool is_plausible(int code, std::string_view value) {
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || c == '*' || c == '_' || c == '3'; };
  switch (value_kind_of(code)) {
    case kUnknown:
      return false;
    case kReal:
      return number_of(value).has_value();
    case kBoolean:
    case kShort:
    case kInteger:
    case kLong:
      return number_in<std::int64_t>(value).has_value();
    default:
      return code != 0 || (!value.empty() && is_letter(value.front()));
  }
}

bool is_one_off(int found, int expected) {
  const std::string a = std::to_string(found), b = std::to_string(expected);
  if (a.size() == b.size()) {
    int differ = 0;
    for (std::size_t i = 0; i < a.size(); ++i) differ += a[i] != b[i] ? 1 : 0;
    return differ == 1;
  }
  if (a.size() + 1 != b.size()) return false;
  for (std::size_t lost = 0; lost < b.size(); ++lost)
    if (b.substr(0, lost) + b.substr(lost + 1) == a) return true;
  return false;
}

bool is_section_name(std::string_view value) {
  return value == "HEADER" || value == "CLASSES" || value == "TABLES" || value == "BLOCKS" ||
         value == "ENTITIES" || value == "OBJECTS";
}

bool is_record_name(std::string_view value) {
  return value == "SECTION" || value == "ENDSEC" || value == "ENDBLK" || value == "EOF" ||
         dxf_type_of(value) != DxfType::kSkipped;
}

}  // namespace toile::dxf
