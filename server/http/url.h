#pragma once
// Request targets and Host values taken apart. Pure.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toile::http {

struct Target {
  std::vector<std::string> segments;         ///< decoded; a slash at the end gives an empty last one
  std::map<std::string, std::string> query;  ///< of a name that stands twice the last
};

/// Splits "/a/b%20c?x=1". Nothing when it does not begin with a slash, an escape is broken, or a segment is
/// "." or
/// ".." or holds a slash or backslash once decoded: no route of ours has such names.
std::optional<Target> parse_target(std::string_view target);

/// "name:port", "[::1]:port" → the name in lower case without port and brackets. Nothing when it is none.
std::optional<std::string> host_name(std::string_view host);

/// localhost, names below it, 127.0.0.0/8 and ::1.
bool is_loopback_name(std::string_view name);

/// Whether a list of entity tags (If-None-Match) has the tag, compared weakly, or is "*".
bool names_tag(std::string_view list, std::string_view tag);

}  // namespace toile::http
