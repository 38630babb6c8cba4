#include "server/jobs/row_edits.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace toile::jobs {

std::int64_t unix_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

store::JobRow without_document(store::JobRow row) {
  row.document.clear();
  row.files.clear();
  return row;
}

RowEdit with_reason(std::string code, std::string reason, std::string where) {
  return [code = std::move(code), reason = std::move(reason), where = std::move(where)](store::JobRow& row) {
    row.reason_code = code;
    row.reason = reason;
    row.reason_where = where;
  };
}

RowEdit requeued() {
  return with_reason("requeued", "the server stopped before its end; it goes on from where it was kept last");
}

void uncount(store::JobRow& row) { row.attempt = std::max(0, row.attempt - 1); }

RowEdit cancelled() {
  return [](store::JobRow& row) {
    with_reason("cancelled", "cancelled on request")(row);
    row.verdict.reset();
    row.report.clear();
    row.results.clear();
  };
}

RowEdit superseded(std::string successor) {
  return [successor = std::move(successor)](store::JobRow& row) {
    cancelled()(row);
    with_reason("superseded", "it was edited while it draped, and goes on as another drape", successor)(row);
  };
}

RowEdit draped(const RunEnd& end) {
  return [&end](store::JobRow& row) {
    if (!row.verdict) row.attempt = 1;  // it has come as far as that: counted anew
    row.verdict = store::JobVerdict{end.succeeded, end.code, end.reason, end.where};
    if (end.touched) row.input.clear();  // it answers for no other drape
    row.notes = end.notes;
    row.report = end.report;
    row.results = end.results;
  };
}

RowEdit answered_by(const store::JobRow& equal) {
  return [&equal](store::JobRow& row) {
    with_reason(equal.reason_code, equal.reason, equal.reason_where)(row);
    row.state = store::JobState::kSucceeded;
    row.started_ms = row.ended_ms = unix_ms();
    row.report = equal.report;
    row.results = equal.results;
  };
}

RowEdit ended(const RunEnd& end) {
  return [&end](store::JobRow& row) {
    with_reason(end.code, end.reason, end.where)(row);
    row.verdict.reset();
    if (end.touched) row.input.clear();
    row.notes = end.notes;
    row.report = end.report;
    row.results = end.results;
  };
}

RunEnd without_pictures(const store::JobRow& row) {
  RunEnd end;
  end.succeeded = row.verdict->succeeded;
  end.code = row.verdict->code;
  end.reason = row.verdict->reason;
  end.where = row.verdict->where;
  end.notes = row.notes;
  end.report = row.report;
  end.results = row.results;
  fall_short(end, "stills.not_drawn",
             "there are no pictures of it: the server broke down " + std::to_string(row.attempt) +
                 " times while they were drawn");
  return end;
}

}  // namespace toile::jobs
