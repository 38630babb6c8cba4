#include "server/ws/job_message.h"

#include <utility>

namespace toile::ws {
namespace {

double number(std::int64_t value) { return static_cast<double>(value); }

std::string word_of(store::JobState state) { return std::string(store::name_of(state)); }

std::string line_of(std::vector<json::JsonMember> members) {
  return json::write_json_line(std::move(members));
}

std::vector<json::JsonMember> message(const char* type, std::vector<json::JsonMember> members) {
  members.insert(members.begin(), {"type", std::string(type)});
  return members;
}

}  // namespace

std::vector<json::JsonMember> job_members(const store::JobRow& job) {
  std::vector<json::JsonMember> results;
  if (store::is_final(job.state)) {  // a drape whose pictures are still to come has some, but not all
    for (const auto& [name, file] : job.results) results.push_back({name, number(file.bytes)});
  }
  std::vector<json::JsonValue> notes;
  for (const store::JobNote& note : job.notes) {
    notes.push_back(std::vector<json::JsonMember>{{"code", note.code}, {"message", note.message}});
  }
  return {{"id", job.id},
          {"project_id", job.project_id},
          {"project_revision", number(job.project_revision)},
          {"name", job.name},
          {"priority", std::string(store::name_of(job.priority))},
          {"pictures", job.pictures},
          {"state", word_of(job.state)},
          {"reason_code", job.reason_code},
          {"reason", job.reason},
          {"reason_where", job.reason_where},
          {"notes", std::move(notes)},
          {"attempt", number(job.attempt)},
          {"created_ms", number(job.created_ms)},
          {"started_ms", number(job.started_ms)},
          {"ended_ms", number(job.ended_ms)},
          {"worked_s", number(job.worked_ms) / 1000},
          {"results", std::move(results)}};
}

std::vector<json::JsonMember> progress_members(const jobs::JobProgress& progress) {
  std::vector<json::JsonValue> pins;
  for (const jobs::LivePin& pin : progress.pins) {
    const auto& [x, y, z] = pin.place;
    pins.push_back(std::vector<json::JsonMember>{{"pin", number(pin.number)},
                                                 {"place", std::vector<json::JsonValue>{x, y, z}}});
  }
  return {{"state", word_of(progress.state)},
          {"phase", progress.phase},
          {"fraction", progress.fraction},
          {"step", number(progress.step)},
          {"simulated_s", progress.simulated_s},
          {"rms_speed", progress.rms_speed},
          {"seam_gap_mm", progress.seam_gap_mm},
          {"cloth_body", number(progress.cloth_body)},
          {"cloth_cloth", number(progress.cloth_cloth)},
          {"step_ms", progress.step_ms},
          {"pulls", number(progress.pulls)},
          {"pins", std::move(pins)}};
}

std::string job_message(const store::JobRow& job, const jobs::JobProgress& progress) {
  std::vector<json::JsonMember> members = message("job", job_members(job));
  members.push_back({"progress", progress_members(progress)});
  return line_of(std::move(members));
}

std::string progress_message(const jobs::JobProgress& progress) {
  return line_of(message("progress", progress_members(progress)));
}

std::string ended_message(const store::JobRow& job, const jobs::JobProgress& last) {
  std::vector<json::JsonMember> members = message("ended", progress_members(last));
  members.push_back({"job", job_members(job)});
  return line_of(std::move(members));
}

std::string error_message(const Error& error) {
  return line_of(message("error", {{"code", error.code}, {"detail", error.message}, {"where", error.where}}));
}

}  // namespace toile::ws
