#include "server/http/handlers/job_tags.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/check.h"
#include "core/base/text.h"

namespace toile::handlers {
namespace {

constexpr std::size_t kMostTags = 16, kLongestTag = 64;  // bytes of one

/// Error: request.state.
Result<std::vector<store::JobState>> read_states(const std::string& words) {
  std::vector<store::JobState> states;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find(',', at), words.size());
    const Result<store::JobState> state = store::job_state_from(words.substr(at, end - at));
    if (!state) return Error{"request.state", state.error().message, "state", ErrorKind::kMalformed};
    states.push_back(*state);
    at = end + 1;
  }
  return states;
}

Result<std::int64_t> read_time(const http::HttpRequest& request, const char* name) {
  const std::string given = request.parameter(name);
  if (given.empty()) return std::int64_t{0};
  const std::optional<std::int64_t> time = number_in<std::int64_t>(given);
  if (time && *time >= 0) return *time;
  return Error{std::string("request.") + name, std::string(name) + " is a time in Unix milliseconds", name,
               ErrorKind::kMalformed};
}

/// Something to read, without control characters.
bool is_tag(const std::string& text) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  return !text.empty() && text.size() <= kLongestTag && trimmed(text) == text &&
         std::none_of(text.begin(), text.end(), is_control);
}

}  // namespace

Result<store::JobQuery> read_query(const http::HttpRequest& request) {
  store::JobQuery query;
  query.states = TRY(read_states(request.parameter("state")));
  query.project_id = request.parameter("project");
  query.tag = request.parameter("tag");
  query.sweep = request.parameter("sweep");
  query.since_ms = TRY(read_time(request, "since"));
  query.until_ms = TRY(read_time(request, "until"));
  return query;
}

Result<store::Tags> read_tags(const json::JsonValue& given) {
  const json::JsonValue* list = given.find("tags");
  if (!list) return store::Tags{};
  const Error wrong{
      "request.tags",
      "\"tags\" is a list of at most 16 different texts of 1 to 64 bytes, without blanks around", "/tags"};
  if (!list->array() || list->array()->size() > kMostTags) return wrong;
  store::Tags tags;
  for (const json::JsonValue& tag : *list->array()) {
    const std::string* text = tag.text();
    if (!text || !is_tag(*text) || std::find(tags.begin(), tags.end(), *text) != tags.end()) return wrong;
    tags.push_back(*text);
  }
  return tags;
}

store::JobSearch& search_in(const Api& api) {
  store::JobSearch* const search = store::job_search_of(api.store);
  TOILE_CHECK(search != nullptr);
  return *search;
}

json::JsonValue tag_list(const store::Tags& tags) {
  std::vector<json::JsonValue> words;
  for (const std::string& tag : tags) words.emplace_back(tag);
  return json::JsonValue(std::move(words));
}

json::JsonValue tags_of(const Api& api, const store::RequestContext& context, const std::string& job) {
  const Result<store::Tags> tags = store::tags_of_job(api.store, context, job);
  if (!tags) context.log.warn("tags are not told", tags.error());
  return tag_list(tags ? *tags : store::Tags{});
}

}  // namespace toile::handlers
