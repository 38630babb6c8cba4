#include "core/pattern/seams/part_codes.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/text.h"

namespace toile::seams {
namespace {

/// Letters of two words or more, which no rule for shortened words finds (abbreviations.h).
constexpr std::string_view kCodes =
    ";fp=front panel;bp=back panel;fpn=front panel;bpn=back panel;spn=side panel;sp=side panel;"
    "fb=front bodice;bb=back bodice;fs=front skirt;bs=back skirt;cf=center front;cb=center back;"
    "sf=side front;sb=side back;fl=front leg;bl=back leg;yk=yoke;fy=front yoke;by=back yoke;ts=topsleeve;"
    "us=undersleeve;fsl=front sleeve;bsl=back sleeve;tc=collar;uc=undercollar;cs=collar stand;nb=neckband;"
    "nkb=neckband;hb=hem band;hmb=hem band;cfb=cuff;wb=waistband;fc=facing;ffc=front facing;"
    "bfc=back facing;nfc=neck facing;afc=armhole facing;fnf=front neck facing;bnf=back neck facing;"
    "pkb=pocket bag;pbg=pocket bag;pfc=pocket facing;bpk=back pocket;fpk=front pocket;cpk=coin pocket;"
    "fls=fly shield;flf=fly facing;blp=belt loop;zgd=zip guard;zfc=zip facing;tpe=tape;ntp=neck tape;";

std::optional<std::string> spelled_alone(std::string_view code) {
  const std::string key = ";" + std::string(code) + "=";
  const std::size_t at = kCodes.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  const std::size_t begin = at + key.size();
  return std::string(kCodes.substr(begin, kCodes.find(';', begin) - begin));
}

/// "ffci" is the interlining of a "ffc".
std::optional<std::string> spelled(std::string_view code) {
  if (auto alone = spelled_alone(code)) return alone;
  if (code.size() < 3 || code.back() != 'i') return std::nullopt;
  auto of = spelled_alone(code.substr(0, code.size() - 1));
  if (of) *of += " interlining";
  return of;
}

/// What stands beside a code: that it is a copy, and of which side.
bool stands_beside(const std::string& word) {
  return word == "mirrored" || word == "l" || word == "r" || word == "lh" || word == "rh";
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where the name goes on behind its style's number, which is longer than that of a part or a copy; the
/// name's end where it has none.
std::size_t after_style_number(std::string_view name) {
  constexpr std::size_t kDigits = 3;
  std::size_t digits = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_digit(name[i]) && digits >= kDigits) return i;
    digits = is_digit(name[i]) ? digits + 1 : 0;
  }
  return name.size();
}

}  // namespace

std::string with_code_spelled_out(std::string name) {
  const std::size_t behind = after_style_number(name);
  const std::vector<std::string> words = words_of_name(std::string_view(name).substr(behind));
  if (words.empty() || !std::all_of(words.begin() + 1, words.end(), stands_beside)) return name;
  const std::optional<std::string> told = spelled(words.front());
  if (!told) return name;
  std::string out = *told;
  for (auto word = words.begin() + 1; word != words.end(); ++word) out += " " + *word;
  return out;
}

}  // namespace toile::seams
