// What became of jobs, as the database's own triggers write it down (migrations.cpp).

#include "server/store/events.h"

#include <cstdint>

#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {
namespace {

Result<store::EventRow> event_from(const SqlStatement& row) {
  return store::EventRow{row.integer(0), row.integer(1), row.text(2), row.text(3),
                         row.text(4),    row.text(5),    row.text(6), row.text(7)};
}

Result<std::int64_t> number_from(const SqlStatement& row) { return row.integer(0); }

}  // namespace

Result<std::vector<store::EventRow>> SqliteStore::events_after(const store::OwnerId& owner,
                                                               std::int64_t number, int limit) {
  const std::lock_guard hold(mutex_);
  return rows_of(database_.prepare("SELECT number, at_ms, job, project_id, name, state, reason_code, sweep"
                                   " FROM events WHERE owner = ? AND number > ? ORDER BY number LIMIT ?",
                                   {owner, number, std::int64_t{limit}}),
                 event_from);
}

Result<std::int64_t> SqliteStore::newest_event(const store::OwnerId& owner) {
  const std::lock_guard hold(mutex_);
  return row_of(database_.prepare("SELECT coalesce(max(number), 0) FROM events WHERE owner = ?", {owner}),
                number_from, "event", "");
}

}  // namespace toile::sqlite
