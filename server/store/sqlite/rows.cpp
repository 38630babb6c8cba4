#include "server/store/sqlite/rows.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace toile::sqlite {
namespace {

using Json = nlohmann::json;

Error damaged(const std::string& thing) {
  return {"store.corrupt", "a row of the database is damaged", thing, ErrorKind::kSystem};
}

/// The members of the object in a column of `thing`'s row that `is_one` takes; others are passed over.
template <typename Value, typename IsOne>
Result<std::map<std::string, Value>> map_from(const std::string& text, const std::string& thing,
                                              IsOne is_one) {
  const Json object = Json::parse(text, nullptr, false);
  if (!object.is_object()) return damaged(thing);
  std::map<std::string, Value> map;
  for (const auto& [name, value] : object.items()) {
    if (is_one(value)) map[name] = value.template get<Value>();
  }
  return map;
}

/// The text under a key; empty where there is none.
std::string text_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Result<std::vector<store::JobNote>> notes_from(const std::string& text, const std::string& thing) {
  const Json list = Json::parse(text, nullptr, false);
  if (!list.is_array()) return damaged(thing);
  std::vector<store::JobNote> notes;
  for (const Json& note : list) {
    if (note.is_object()) notes.push_back({text_at(note, "code"), text_at(note, "message")});
  }
  return notes;
}

Result<std::vector<std::string>> labels_from(const std::string& text, const std::string& thing) {
  const Json list = Json::parse(text, nullptr, false);
  if (!list.is_array() || list.empty()) return damaged(thing);
  std::vector<std::string> labels;
  for (const Json& label : list) labels.push_back(label.is_string() ? label.get<std::string>() : "");
  return labels;
}

Result<std::optional<store::JobVerdict>> verdict_from(const std::string& text, const std::string& thing) {
  if (text.empty()) return std::optional<store::JobVerdict>();
  const Json object = Json::parse(text, nullptr, false);
  if (!object.is_object()) return damaged(thing);
  const auto succeeded = object.find("succeeded");
  const bool well = succeeded != object.end() && succeeded->is_boolean() && succeeded->get<bool>();
  return std::optional(
      store::JobVerdict{well, text_at(object, "code"), text_at(object, "reason"), text_at(object, "where")});
}

/// Bytes that are no UTF-8 would throw.
std::string dumped(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// One line, with blanks as the rows that are there already have them.
template <typename Map>
std::string text_of(const Map& map) {
  std::string text;
  for (const auto& [name, value] : map)
    text += (text.empty() ? "" : ", ") + dumped(name) + ": " + dumped(value);
  return "{" + text + "}";
}

}  // namespace

Result<FileIds> files_from(const std::string& text, const std::string& thing) {
  return map_from<std::string>(text, thing, [](const Json& value) { return value.is_string(); });
}

/// A number of bytes alone is a row of before results had hashes.
Result<store::ResultFiles> results_from(const std::string& text, const std::string& thing) {
  const Json object = Json::parse(text, nullptr, false);
  if (!object.is_object()) return damaged(thing);
  store::ResultFiles results;
  for (const auto& [name, value] : object.items()) {
    if (value.is_number()) results[name] = value.get<std::int64_t>();
    if (!value.is_object()) continue;
    const auto bytes = value.find("bytes");
    if (bytes != value.end() && bytes->is_number())
      results[name] = {bytes->get<std::int64_t>(), text_at(value, "xxh3")};
  }
  return results;
}

Result<store::AssetRow> asset_from(const SqlStatement& row) {
  store::AssetRow asset;
  asset.id = row.text(0);
  asset.kind = row.text(1);
  asset.name = row.text(2);
  asset.size = row.integer(3);
  asset.created_ms = row.integer(4);
  asset.info = row.text(5);
  return asset;
}

Result<store::ProjectRow> project_from(const SqlStatement& row) {
  store::ProjectRow project;
  project.id = row.text(0);
  project.name = row.text(1);
  project.revision = static_cast<int>(row.integer(2));
  project.created_ms = row.integer(3);
  project.updated_ms = row.integer(4);
  FileIds files = TRY(files_from(row.text(5), project.id));
  project.files = std::move(files);
  project.document = row.text(6);
  return project;
}

Result<store::JobRow> job_from(const SqlStatement& row) {
  store::JobRow job;
  job.id = row.text(0);
  job.project_id = row.text(1);
  job.project_revision = static_cast<int>(row.integer(2));
  job.name = row.text(3);
  const Result<store::JobState> state = store::job_state_from(row.text(4));
  if (!state) return damaged(job.id);
  job.state = *state;
  job.reason_code = row.text(5);
  job.reason = row.text(6);
  job.reason_where = row.text(7);
  job.attempt = static_cast<int>(row.integer(8));
  job.created_ms = row.integer(9);
  job.started_ms = row.integer(10);
  job.ended_ms = row.integer(11);
  store::ResultFiles results = TRY(results_from(row.text(12), job.id));
  job.results = std::move(results);
  FileIds files = TRY(files_from(row.text(13), job.id));
  job.files = std::move(files);
  job.report = row.text(14);
  job.document = row.text(15);
  std::vector<store::JobNote> notes = TRY(notes_from(row.text(16), job.id));
  job.notes = std::move(notes);
  std::optional<store::JobVerdict> verdict = TRY(verdict_from(row.text(17), job.id));
  job.verdict = std::move(verdict);
  job.worked_ms = row.integer(18);
  const Result<store::JobPriority> priority = store::job_priority_from(row.text(19));
  if (!priority) return damaged(job.id);
  job.priority = *priority;
  job.input = row.text(20);
  job.suspect = row.integer(21) != 0;
  job.lease = {row.text(22), row.integer(23), row.integer(24)};
  job.progress = row.text(25);
  job.cell = {row.text(26), static_cast<int>(row.integer(27)), static_cast<int>(row.integer(28))};
  job.pictures = row.integer(29) != 0;
  return job;
}

Result<store::SweepRow> sweep_from(const SqlStatement& row) {
  store::SweepRow sweep;
  sweep.id = row.text(0);
  sweep.project_id = row.text(1);
  sweep.project_revision = static_cast<int>(row.integer(2));
  sweep.name = row.text(3);
  sweep.created_ms = row.integer(4);
  sweep.bodies = TRY(labels_from(row.text(5), sweep.id));
  sweep.fabrics = TRY(labels_from(row.text(6), sweep.id));
  return sweep;
}

std::string column_text(const FileIds& files) { return text_of(files); }

std::string column_text(const store::ResultFiles& results) {
  Json object = Json::object();
  for (const auto& [name, file] : results) object[name] = {{"bytes", file.bytes}, {"xxh3", file.hash}};
  return dumped(object);
}

std::string column_text(const std::vector<std::string>& labels) { return dumped(Json(labels)); }

std::string column_text(const std::vector<store::JobNote>& notes) {
  Json list = Json::array();
  for (const store::JobNote& note : notes) list.push_back({{"code", note.code}, {"message", note.message}});
  return dumped(list);
}

std::string column_text(const std::optional<store::JobVerdict>& verdict) {
  if (!verdict) return "";
  return dumped({{"succeeded", verdict->succeeded},
                 {"code", verdict->code},
                 {"reason", verdict->reason},
                 {"where", verdict->where}});
}

}  // namespace toile::sqlite
