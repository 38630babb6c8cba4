#include "server/http/url.h"

#include <boost/url/encode.hpp>
#include <boost/url/parse_path.hpp>
#include <boost/url/parse_query.hpp>
#include <boost/url/pct_string_view.hpp>
#include <boost/url/rfc/pchars.hpp>

#include <algorithm>

#include "core/base/text.h"

namespace toile::http {
namespace {

namespace urls = boost::urls;

// Boost.URL reads what RFC 3986 allows and nothing else. Clients send more, and have always been understood:
// a blank, a quote, a bracket, bytes of UTF-8 as they are. Those are escaped before it reads them.
constexpr auto kPathSigns = urls::pchars + '/';
constexpr auto kQuerySigns = urls::pchars + '/' + '?';

/// Escapes that are there already stay, so that a broken one is told as broken.
template <typename Signs>
std::string escaped(std::string_view text, const Signs& signs) {
  std::string out;
  for (const char& sign : text) {
    if (sign == '%' || signs(sign)) {
      out += sign;
    } else {
      out += urls::encode(urls::string_view(&sign, 1), signs);
    }
  }
  return out;
}

/// Nothing when it holds NUL: no name of ours does, and C ends at it.
std::optional<std::string> decoded(urls::pct_string_view text) {
  std::string out = text.decode();
  if (out.find('\0') != std::string::npos) return std::nullopt;
  return out;
}

bool is_route_segment(const std::string& segment) {
  return segment != "." && segment != ".." && segment.find_first_of("/\\") == std::string::npos;
}

std::optional<std::vector<std::string>> parse_segments(std::string_view path) {
  // Boost.URL takes "/." at the start for a mark that an empty segment follows, not for a segment.
  if (path.starts_with("/./")) return std::nullopt;
  const std::string text = escaped(path, kPathSigns);
  const auto parsed = urls::parse_path(text);
  if (!parsed) return std::nullopt;
  std::vector<std::string> segments;
  for (const urls::pct_string_view part : *parsed) {
    std::optional<std::string> segment = decoded(part);
    if (!segment || !is_route_segment(*segment)) return std::nullopt;
    segments.push_back(std::move(*segment));
  }
  return segments;
}

std::optional<std::map<std::string, std::string>> parse_parameters(std::string_view query) {
  const std::string text = escaped(query, kQuerySigns);
  const auto parsed = urls::parse_query(text);
  if (!parsed) return std::nullopt;
  std::map<std::string, std::string> parameters;
  for (const urls::param_pct_view& pair : *parsed) {
    const std::optional<std::string> name = decoded(pair.key), value = decoded(pair.value);
    if (!name || !value) return std::nullopt;
    if (!name->empty()) parameters[*name] = *value;
  }
  return parameters;
}

bool is_port(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// a.b.c.d with each of 0 to 255, beginning with 127.
bool is_loopback_v4(std::string_view name) {
  int parts = 0;
  for (std::size_t at = 0; at <= name.size(); ++parts) {
    const std::size_t end = std::min(name.find('.', at), name.size());
    const auto value = number_in<unsigned>(name.substr(at, end - at));
    if (!value || *value > 255 || (parts == 0 && *value != 127)) return false;
    at = end + 1;
  }
  return parts == 4;
}

}  // namespace

std::optional<Target> parse_target(std::string_view target) {
  if (!target.starts_with('/')) return std::nullopt;
  const std::size_t question = std::min(target.find('?'), target.size());
  auto segments = parse_segments(target.substr(0, question));
  auto query = parse_parameters(target.substr(std::min(question + 1, target.size())));
  if (!segments || !query) return std::nullopt;
  return Target{std::move(*segments), std::move(*query)};
}

std::optional<std::string> host_name(std::string_view host) {
  std::string_view name = host, port;
  bool has_port = false;
  if (host.starts_with('[')) {
    const std::size_t close = host.find(']');
    if (close == std::string_view::npos) return std::nullopt;
    name = host.substr(1, close - 1);
    const std::string_view rest = host.substr(close + 1);
    has_port = !rest.empty();
    if (has_port && rest.front() != ':') return std::nullopt;
    port = has_port ? rest.substr(1) : rest;
  } else if (const std::size_t colon = host.find(':'); colon != std::string_view::npos) {
    name = host.substr(0, colon);
    port = host.substr(colon + 1);
    has_port = true;
  }
  if (name.empty() || (has_port && !is_port(port))) return std::nullopt;
  return lower_case(name);
}

bool is_loopback_name(std::string_view name) {
  return name == "localhost" || name.ends_with(".localhost") || name == "::1" || is_loopback_v4(name);
}

bool names_tag(std::string_view list, std::string_view tag) {
  while (!list.empty()) {
    if (list.front() == ' ' || list.front() == ',' || list.front() == '\t') {
      list.remove_prefix(1);
      continue;
    }
    if (list.front() == '*') return true;
    if (list.starts_with("W/")) list.remove_prefix(2);
    const std::size_t close = list.starts_with('"') ? list.find('"', 1) : std::string_view::npos;
    if (close == std::string_view::npos) return false;
    if (list.substr(0, close + 1) == tag) return true;
    list.remove_prefix(close + 1);
  }
  return false;
}

}  // namespace toile::http
