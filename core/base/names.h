#pragma once
// Names as they stand in messages: quoted, clipped, and with the names that would have been right.

#include <span>
#include <string>
#include <string_view>

namespace toile {

/// At most `limit` bytes of `text`, control characters replaced by '?': what strangers write must neither
/// flood nor steer a terminal.
std::string clipped(std::string_view text, std::size_t limit = 60);

/// clipped in double quotes.
std::string in_quotes(std::string_view text);

/// The element of `names` with the fewest letter changes to `name`, when they are few enough for a slip of
/// the pen (a third of the letters); empty otherwise.
std::string_view nearest_name(std::string_view name, std::span<const std::string> names);

/// "did you mean "FRONT"?" or "there are "FRONT", "BACK"", ready to stand behind a semicolon.
std::string advice(std::string_view name, std::span<const std::string> names);

}  // namespace toile
