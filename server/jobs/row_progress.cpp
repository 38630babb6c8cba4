#include "server/jobs/row_progress.h"

#include <utility>
#include <vector>

#include "core/json/tree.h"

namespace toile::jobs {
namespace {

double number_in(const json::JsonValue& object, std::string_view key) {
  const json::JsonValue* found = object.find(key);
  const double* number = found ? found->number() : nullptr;
  return number ? *number : 0;
}

/// The figures of a job that another process works on.
void read_told(const std::string& told, JobProgress& progress) {
  const Result<json::JsonValue> read = json::parse_json(told);
  if (!read) return;
  const json::JsonValue* phase = read->find("phase");
  if (phase && phase->text()) progress.phase = *phase->text();
  progress.fraction = number_in(*read, "fraction");
  progress.step = static_cast<int>(number_in(*read, "step"));
  progress.simulated_s = number_in(*read, "simulated_s");
  progress.rms_speed = number_in(*read, "rms_speed");
  progress.seam_gap_mm = number_in(*read, "seam_gap_mm");
  progress.cloth_body = static_cast<int>(number_in(*read, "cloth_body"));
  progress.cloth_cloth = static_cast<int>(number_in(*read, "cloth_cloth"));
  progress.step_ms = number_in(*read, "step_ms");
}

}  // namespace

std::string text_of(const JobProgress& progress) {
  std::vector<json::JsonMember> members = {{"phase", progress.phase},
                                           {"fraction", progress.fraction},
                                           {"step", static_cast<double>(progress.step)},
                                           {"simulated_s", progress.simulated_s},
                                           {"rms_speed", progress.rms_speed},
                                           {"seam_gap_mm", progress.seam_gap_mm},
                                           {"cloth_body", static_cast<double>(progress.cloth_body)},
                                           {"cloth_cloth", static_cast<double>(progress.cloth_cloth)},
                                           {"step_ms", progress.step_ms}};
  return json::write_json_line(std::move(members));
}

JobProgress progress_of_row(const store::JobRow& row) {
  JobProgress progress;
  progress.state = row.state;
  progress.phase = row.state == store::JobState::kQueued ? "queued" : "";
  if (!row.progress.empty() && row.state != store::JobState::kQueued) read_told(row.progress, progress);
  if (row.report.empty()) return progress;
  const Result<json::JsonValue> report = json::parse_json(row.report);
  if (!report) return progress;
  progress.phase = "stills";
  progress.fraction = 1;
  progress.step = static_cast<int>(number_in(*report, "steps"));
  progress.simulated_s = number_in(*report, "simulated_s");
  progress.rms_speed = number_in(*report, "rms_speed");
  progress.seam_gap_mm = number_in(*report, "seam_gap_max_mm");
  if (const json::JsonValue* crossings = report->find("intersections")) {
    progress.cloth_body = static_cast<int>(number_in(*crossings, "cloth_body"));
    progress.cloth_cloth = static_cast<int>(number_in(*crossings, "cloth_cloth"));
  }
  return progress;
}

}  // namespace toile::jobs
