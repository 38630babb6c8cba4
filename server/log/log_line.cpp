#include "server/log/log_line.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <vector>

#include "core/json/tree.h"

namespace toile::log {
namespace {

bool is_plain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         std::string_view("-_.:/{}*,%?&+@#~").find(c) != std::string_view::npos;
}

/// Bytes beyond ASCII stay: names and messages are UTF-8.
void add_quoted(std::string& line, std::string_view value) {
  line += '"';
  for (const char c : value) {
    if (c == '"' || c == '\\') line += '\\';
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) {
      line += c;
      continue;
    }
    std::array<char, 8> escape;
    std::snprintf(escape.data(), escape.size(), "\\x%02x",
                  static_cast<unsigned>(static_cast<unsigned char>(c)));
    line += escape.data();
  }
  line += '"';
}

void add_fields(std::string& line, std::span<const LogField> fields) {
  for (const LogField& field : fields) {
    if (field.value.empty()) continue;
    line += ' ';
    line += field.key;
    line += '=';
    if (std::all_of(field.value.begin(), field.value.end(), is_plain)) {
      line += field.value;
    } else {
      add_quoted(line, field.value);
    }
  }
}

const char* name_of(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return "debug";
    case LogLevel::kInfo:
      return "info";
    case LogLevel::kWarning:
      return "warning";
    case LogLevel::kError:
      break;
  }
  return "error";
}

/// "2026-05-04T10:11:12.123Z"
std::string time_text(std::chrono::system_clock::time_point time) {
  using namespace std::chrono;
  const auto ms = duration_cast<milliseconds>(time.time_since_epoch()).count();
  const auto seconds = static_cast<std::time_t>(ms / 1000);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 24> day;
  std::strftime(day.data(), day.size(), "%Y-%m-%dT%H:%M:%S", &parts);
  std::array<char, 8> fraction;
  std::snprintf(fraction.data(), fraction.size(), ".%03dZ", static_cast<int>(ms % 1000));
  return std::string(day.data()) + fraction.data();
}

void add_member(std::vector<json::JsonMember>& members, const LogField& field) {
  if (field.value.empty()) return;
  const auto same = [&](const json::JsonMember& member) { return member.key == field.key; };
  const auto found = std::find_if(members.begin(), members.end(), same);
  if (found == members.end()) {
    members.push_back({field.key, field.value});
  } else {
    found->value = json::JsonValue(field.value);
  }
}

}  // namespace

std::string log_text(std::string_view event, std::span<const LogField> bound,
                     std::span<const LogField> more) {
  std::string line(event);
  add_fields(line, bound);
  add_fields(line, more);
  return line;
}

std::string log_json(std::chrono::system_clock::time_point time, LogLevel level, std::string_view event,
                     std::span<const LogField> bound, std::span<const LogField> more) {
  std::vector<json::JsonMember> members{
      {"time", time_text(time)}, {"level", std::string(name_of(level))}, {"event", std::string(event)}};
  for (const LogField& field : bound) add_member(members, field);
  for (const LogField& field : more) add_member(members, field);
  return json::write_json_line(std::move(members));
}

}  // namespace toile::log
