#include "server/store/rows.h"

#include <utility>
#include <vector>

#include "proto/cpp/json_codec.h"

namespace toile {
namespace {

/// The object's members; `thing` says whose row it is.
Result<std::vector<JsonMember>> members_of(const std::string& text, const std::string& thing) {
  Result<JsonValue> value = parse_json(text);
  if (value && value->object() != nullptr) return *value->object();
  return Error{"store.corrupt", "a row of the database is damaged", thing};
}

Result<std::map<std::string, std::string>> files_from(const std::string& text, const std::string& thing) {
  const Result<std::vector<JsonMember>> members = members_of(text, thing);
  if (!members) return members.error();
  std::map<std::string, std::string> files;
  for (const JsonMember& member : *members) {
    if (const std::string* id = member.value.text()) files[member.key] = *id;
  }
  return files;
}

Result<std::map<std::string, std::int64_t>> results_from(const std::string& text, const std::string& thing) {
  const Result<std::vector<JsonMember>> members = members_of(text, thing);
  if (!members) return members.error();
  std::map<std::string, std::int64_t> results;
  for (const JsonMember& member : *members) {
    if (const double* bytes = member.value.number()) results[member.key] = static_cast<std::int64_t>(*bytes);
  }
  return results;
}

}  // namespace

Result<AssetRow> asset_from(const SqlStatement& row) {
  AssetRow asset;
  asset.id = row.text(0);
  asset.kind = row.text(1);
  asset.name = row.text(2);
  asset.size = row.integer(3);
  asset.created_ms = row.integer(4);
  asset.info = row.text(5);
  return asset;
}

Result<ProjectRow> project_from(const SqlStatement& row) {
  ProjectRow project;
  project.id = row.text(0);
  project.name = row.text(1);
  project.revision = static_cast<int>(row.integer(2));
  project.created_ms = row.integer(3);
  project.updated_ms = row.integer(4);
  Result<std::map<std::string, std::string>> files = files_from(row.text(5), project.id);
  if (!files) return files.error();
  project.files = std::move(*files);
  project.document = row.text(6);
  return project;
}

Result<JobRow> job_from(const SqlStatement& row) {
  JobRow job;
  job.id = row.text(0);
  job.project_id = row.text(1);
  job.project_revision = static_cast<int>(row.integer(2));
  job.name = row.text(3);
  job.state = row.text(4);
  job.reason_code = row.text(5);
  job.reason = row.text(6);
  job.reason_where = row.text(7);
  job.attempt = static_cast<int>(row.integer(8));
  job.created_ms = row.integer(9);
  job.started_ms = row.integer(10);
  job.ended_ms = row.integer(11);
  Result<std::map<std::string, std::int64_t>> results = results_from(row.text(12), job.id);
  if (!results) return results.error();
  job.results = std::move(*results);
  Result<std::map<std::string, std::string>> files = files_from(row.text(13), job.id);
  if (!files) return files.error();
  job.files = std::move(*files);
  job.report = row.text(14);
  job.document = row.text(15);
  return job;
}

std::string column_text(const std::map<std::string, std::string>& files) {
  std::vector<JsonMember> members;
  for (const auto& [name, id] : files) members.push_back({name, JsonValue(id)});
  return write_json_line(JsonValue(std::move(members)));
}

std::string column_text(const std::map<std::string, std::int64_t>& results) {
  std::vector<JsonMember> members;
  for (const auto& [name, bytes] : results) members.push_back({name, JsonValue(static_cast<double>(bytes))});
  return write_json_line(JsonValue(std::move(members)));
}

}  // namespace toile
