#include "server/store/sqlite/links.h"

#include <cstdint>
#include <utility>

#include "server/store/now.h"
#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {
namespace {

constexpr const char* kLinkColumns =
    "l.id, l.owner, l.job, l.label, l.takes, l.created_ms, l.expires_ms, l.revoked_ms";
constexpr int kLinkColumnCount = 8;
/// So long somebody who opens a link that was good once is told what became of it.
constexpr std::int64_t kRememberedMs = std::int64_t{30} * 24 * 3600 * 1000;
/// Of an owner: good at that time, and of a job that is there.
constexpr const char* kGood =
    "SELECT count(*) FROM links l WHERE l.owner = ? AND l.revoked_ms = 0 AND"
    " (l.expires_ms = 0 OR l.expires_ms > ?) AND"
    " EXISTS (SELECT 1 FROM jobs j WHERE j.owner = l.owner AND j.id = l.job)";

Result<store::LinkRow> link_from(const SqlStatement& row) {
  store::LinkRow link;
  link.id = row.text(0);
  link.owner = row.text(1);
  link.job = row.text(2);
  link.label = row.text(3);
  link.takes = TRY(store::takes_from(row.text(4)));
  link.created_ms = row.integer(5);
  link.expires_ms = row.integer(6);
  link.revoked_ms = row.integer(7);
  return link;
}

Result<store::KnownLink> known_link_from(const SqlStatement& row) {
  const store::LinkRow link = TRY(link_from(row));
  return store::KnownLink{link, row.integer(kLinkColumnCount) != 0, row.integer(kLinkColumnCount + 1) != 0};
}

}  // namespace

Result<store::LinkRow> SqliteLinks::add_link(store::LinkRow row, const std::string& secret_hash) {
  const std::lock_guard hold(mutex_);
  row.created_ms = store::now_ms();
  row.revoked_ms = 0;
  row.id = TRY(ids_.next('l', row.created_ms));
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  const std::int64_t forgotten = row.created_ms - kRememberedMs;
  TRY(
      database_.run("DELETE FROM links WHERE (revoked_ms > 0 AND revoked_ms < ?) OR"
                    " (expires_ms > 0 AND expires_ms < ?)",
                    {forgotten, forgotten}));
  const std::int64_t jobs = TRY(
      row_of(database_.prepare("SELECT count(*) FROM jobs WHERE owner = ? AND id = ?", {row.owner, row.job}),
             count_from, "job", row.job));
  if (jobs == 0) return not_found("job", row.job);
  const std::int64_t good =
      TRY(row_of(database_.prepare(kGood, {row.owner, row.created_ms}), count_from, "link", ""));
  if (good >= kMost) {
    return Error{"links.too_many",
                 "there are " + std::to_string(kMost) + " links already; take back some that are not needed",
                 "", ErrorKind::kConflict};
  }
  TRY(database_.run(
      "INSERT INTO links (hash, id, owner, job, label, takes, created_ms, expires_ms, revoked_ms)"
      " VALUES (?, ?, ?, ?, ?, ?, ?, ?, 0)",
      {secret_hash, row.id, row.owner, row.job, row.label, to_text(row.takes), row.created_ms,
       row.expires_ms}));
  TRY(transaction.commit());
  return row;
}

Result<store::KnownLink> SqliteLinks::link_of_secret(const std::string& secret_hash) {
  const std::lock_guard hold(mutex_);
  const std::string sql = std::string("SELECT ") + kLinkColumns +
                          ", a.id IS NOT NULL, coalesce(a.locked, 0)"
                          " FROM links l LEFT JOIN accounts a ON a.id = l.owner WHERE l.hash = ?";
  return row_of(database_.prepare(sql, {secret_hash}), known_link_from, "link", "");
}

Result<std::vector<store::LinkRow>> SqliteLinks::links(const store::OwnerId& owner, const std::string& job) {
  const std::lock_guard hold(mutex_);
  const char* const rest =
      "FROM links l JOIN jobs j ON j.owner = l.owner AND j.id = l.job"
      " WHERE l.owner = ? AND (? = '' OR l.job = ?) AND l.revoked_ms = 0 ORDER BY l.id DESC";
  return rows_of(database_.prepare(select(kLinkColumns, rest), {owner, job, job}), link_from);
}

Status SqliteLinks::revoke_link(const store::OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  const int gone =
      TRY(database_.run("UPDATE links SET revoked_ms = ? WHERE owner = ? AND id = ? AND revoked_ms = 0",
                        {store::now_ms(), owner, id}));
  return gone > 0 ? Status() : Status(not_found("link", id));
}

}  // namespace toile::sqlite
