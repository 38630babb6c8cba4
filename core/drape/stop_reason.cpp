#include "core/drape/stop_reason.h"

namespace toile::drape {
namespace {

struct Words {
  Stop kind;
  std::string_view words;
  bool named;  ///< a space and the id of a seam or button follow
};

// A row for every Stop, in the order of the enumerators.
constexpr std::array<Words, kStops.size()> kWords{{{Stop::kSettled, "settled", false},
                                                   {Stop::kTime, "time", false},
                                                   {Stop::kCancelled, "cancelled", false},
                                                   {Stop::kNotFinite, "not finite", false},
                                                   {Stop::kOpenSeam, "open seam", true},
                                                   {Stop::kOpenButton, "open button", true}}};

const Words& row_of(Stop kind) { return kWords.at(static_cast<std::size_t>(kind)); }

}  // namespace

bool has_name(Stop kind) { return row_of(kind).named; }

std::string to_string(const StopReason& reason) {
  const Words& row = row_of(reason.kind);
  std::string text(row.words);
  if (row.named) text += " " + reason.name;
  return text;
}

Result<StopReason> stop_reason_from(std::string_view words) {
  for (const Words& row : kWords) {
    if (!words.starts_with(row.words)) continue;
    const std::string_view rest = words.substr(row.words.size());
    if (!row.named && rest.empty()) return StopReason{row.kind, "", 0};
    // An id may be empty or hold spaces itself: all behind the first space is the id.
    if (row.named && rest.starts_with(' ')) return StopReason{row.kind, std::string(rest.substr(1)), 0};
  }
  return Error{"drape.unknown_stop", "a drape does not end for this reason", std::string(words)};
}

}  // namespace toile::drape
