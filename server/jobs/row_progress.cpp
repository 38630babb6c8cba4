#include "server/jobs/row_progress.h"

#include "core/json/tree.h"

namespace toile::jobs {
namespace {

double number_in(const json::JsonValue& object, std::string_view key) {
  const json::JsonValue* found = object.find(key);
  const double* number = found ? found->number() : nullptr;
  return number ? *number : 0;
}

}  // namespace

JobProgress progress_of_row(const store::JobRow& row) {
  JobProgress progress;
  progress.state = row.state;
  progress.phase = row.state == store::JobState::kQueued ? "queued" : "";
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
