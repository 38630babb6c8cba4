// The history of projects: what was done to them, to be undone and done again.

#include "server/store/now.h"
#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {
namespace {

constexpr std::int64_t kMostSteps = 500;
constexpr std::int64_t kMostBytes = std::int64_t{64} << 20;

Result<store::EditRow> edit_from(const SqlStatement& row) {
  store::EditRow edit;
  edit.number = row.integer(0);
  edit.undone = row.integer(1) != 0;
  edit.created_ms = row.integer(2);
  edit.edits = row.text(3);
  edit.inverse = row.text(4);
  edit.original = row.text(5);
  return edit;
}

struct StepSize {
  std::int64_t number, bytes;
};

Result<StepSize> step_size_from(const SqlStatement& row) { return StepSize{row.integer(0), row.integer(1)}; }

}  // namespace

Status SqliteStore::forget_edits(const store::OwnerId& owner, const std::string& project_id) {
  TRY(database_.run("DELETE FROM project_edits WHERE owner = ? AND project_id = ?", {owner, project_id}));
  return {};
}

/// Keeps the newest steps, within the bounds; the newest one always.
Status SqliteStore::trim_edits(const store::OwnerId& owner, const std::string& project_id) {
  const std::vector<StepSize> steps = TRY(
      rows_of(database_.prepare("SELECT number, bytes FROM project_edits WHERE owner = ? AND project_id = ?"
                                " ORDER BY number DESC",
                                {owner, project_id}),
              step_size_from));
  std::int64_t count = 0, bytes = 0;
  for (const StepSize& step : steps) {
    bytes += step.bytes;
    if (++count == 1 || (count <= kMostSteps && bytes <= kMostBytes)) continue;
    TRY(database_.run("DELETE FROM project_edits WHERE owner = ? AND project_id = ? AND number <= ?",
                      {owner, project_id, step.number}));
    return {};
  }
  return {};
}

Status SqliteStore::append_edit(const store::OwnerId& owner, const std::string& project_id,
                                const store::EditRow& edit) {
  TRY(database_.run("DELETE FROM project_edits WHERE owner = ? AND project_id = ? AND undone = 1",
                    {owner, project_id}));
  const auto bytes =
      static_cast<std::int64_t>(edit.edits.size() + edit.inverse.size() + edit.original.size());
  TRY(database_.run(
      "INSERT INTO project_edits (owner, project_id, number, undone, created_ms, bytes, edits, inverse,"
      " original) SELECT ?1, ?2, coalesce(max(number), 0) + 1, 0, ?3, ?4, ?5, ?6, ?7 FROM project_edits"
      " WHERE owner = ?1 AND project_id = ?2",
      {owner, project_id, store::now_ms(), bytes, edit.edits, edit.inverse, edit.original}));
  return trim_edits(owner, project_id);
}

Status SqliteStore::turn_edit(const store::OwnerId& owner, const std::string& project_id, std::int64_t number,
                              bool undone) {
  const int turned = TRY(database_.run(
      "UPDATE project_edits SET undone = ? WHERE owner = ? AND project_id = ? AND number = ? AND undone = ?",
      {std::int64_t{undone}, owner, project_id, number, std::int64_t{!undone}}));
  if (turned == 1) return {};
  return not_found("step", std::to_string(number));
}

Result<store::ProjectRow> SqliteStore::edit_project(const store::RequestContext& context,
                                                    const store::ProjectRow& row, int expected,
                                                    store::EditStep step, const store::EditRow& edit) {
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  const store::ProjectRow now = TRY(find_project(context.owner, row.id));
  TRY(check_revision(now, expected));
  store::ProjectRow changed = now;
  changed.name = row.name;
  changed.document = row.document;
  changed.files = row.files;
  const store::ProjectRow kept = TRY(update_project(context.owner, now, changed));
  TRY(step == store::EditStep::kDo
          ? append_edit(context.owner, row.id, edit)
          : turn_edit(context.owner, row.id, edit.number, step == store::EditStep::kUndo));
  TRY(transaction.commit());
  return kept;
}

Result<std::vector<store::EditRow>> SqliteStore::edits(const store::RequestContext& context,
                                                       const std::string& project_id, std::int64_t before,
                                                       int limit) {
  const std::lock_guard hold(mutex_);
  return rows_of(database_.prepare("SELECT number, undone, created_ms, edits, '', '' FROM project_edits"
                                   " WHERE owner = ?1 AND project_id = ?2 AND (?3 = 0 OR number < ?3)"
                                   " ORDER BY number DESC LIMIT ?4",
                                   {context.owner, project_id, before, page_limit(limit)}),
                 edit_from);
}

Result<std::optional<store::EditRow>> SqliteStore::next_edit(const store::RequestContext& context,
                                                             const std::string& project_id,
                                                             store::EditStep step) {
  const std::lock_guard hold(mutex_);
  const char* const sql =
      step == store::EditStep::kUndo
          ? "SELECT number, undone, created_ms, edits, inverse, original FROM project_edits"
            " WHERE owner = ? AND project_id = ? AND undone = 0 ORDER BY number DESC LIMIT 1"
          : "SELECT number, undone, created_ms, edits, inverse, original FROM project_edits"
            " WHERE owner = ? AND project_id = ? AND undone = 1 ORDER BY number LIMIT 1";
  std::vector<store::EditRow> rows =
      TRY(rows_of(database_.prepare(sql, {context.owner, project_id}), edit_from));
  if (rows.empty()) return std::optional<store::EditRow>();
  return std::optional(std::move(rows.front()));
}

}  // namespace toile::sqlite
