#include "server/store/sqlite/migrations.h"

#include <cstdint>
#include <string>

#include "server/store/sqlite/sweep_schema.h"
#include "server/store/sqlite/version_schema.h"

namespace toile::sqlite {
namespace {

// Times are Unix milliseconds. `files` and `results` are JSON objects. Everything belongs to an owner, and
// each key begins with them. Ids rise with time, so that an index over (owner, id) is the order of the lists.
// Long columns stand last: to read one, SQLite walks through those before it.
constexpr Migration kMigrations[] = {
    {1, "projects, assets, jobs and settings", R"sql(
CREATE TABLE assets (
  owner TEXT NOT NULL,
  id TEXT NOT NULL,
  kind TEXT NOT NULL,
  name TEXT NOT NULL,
  size INTEGER NOT NULL,
  blob TEXT NOT NULL,
  created_ms INTEGER NOT NULL,
  info TEXT NOT NULL,
  PRIMARY KEY (owner, id)
) STRICT;

CREATE TABLE projects (
  owner TEXT NOT NULL,
  id TEXT NOT NULL,
  name TEXT NOT NULL,
  revision INTEGER NOT NULL,
  created_ms INTEGER NOT NULL,
  updated_ms INTEGER NOT NULL,
  files TEXT NOT NULL,
  document TEXT NOT NULL,
  PRIMARY KEY (owner, id)
) STRICT;

CREATE TABLE jobs (
  owner TEXT NOT NULL,
  id TEXT NOT NULL,
  project_id TEXT NOT NULL,
  project_revision INTEGER NOT NULL,
  name TEXT NOT NULL,
  state TEXT NOT NULL,
  reason_code TEXT NOT NULL,
  reason TEXT NOT NULL,
  reason_where TEXT NOT NULL,
  attempt INTEGER NOT NULL,
  created_ms INTEGER NOT NULL,
  started_ms INTEGER NOT NULL,
  ended_ms INTEGER NOT NULL,
  idempotency_key TEXT,
  results TEXT NOT NULL,
  files TEXT NOT NULL,
  report TEXT NOT NULL,
  document TEXT NOT NULL,
  PRIMARY KEY (owner, id)
) STRICT;
CREATE UNIQUE INDEX jobs_by_key ON jobs (owner, idempotency_key) WHERE idempotency_key IS NOT NULL;
CREATE INDEX jobs_unfinished ON jobs (id) WHERE state IN ('queued', 'running', 'paused');

CREATE TABLE settings (
  owner TEXT NOT NULL,
  key TEXT NOT NULL,
  value TEXT NOT NULL,
  PRIMARY KEY (owner, key)
) STRICT;
)sql"},
    {2, "keys that make a project only once", R"sql(
CREATE TABLE project_keys (
  owner TEXT NOT NULL,
  key TEXT NOT NULL,
  project_id TEXT NOT NULL,
  request TEXT NOT NULL,
  PRIMARY KEY (owner, key)
) STRICT;
CREATE INDEX project_keys_by_project ON project_keys (owner, project_id);
)sql"},
    {3, "what was done to projects, to be undone", R"sql(
CREATE TABLE project_edits (
  owner TEXT NOT NULL,
  project_id TEXT NOT NULL,
  number INTEGER NOT NULL,
  undone INTEGER NOT NULL,
  created_ms INTEGER NOT NULL,
  bytes INTEGER NOT NULL,
  edits TEXT NOT NULL,
  inverse TEXT NOT NULL,
  original TEXT NOT NULL,
  PRIMARY KEY (owner, project_id, number)
) STRICT;
)sql"},
    {4, "what a drape came to before its pictures, and what it fell short of", R"sql(
ALTER TABLE jobs ADD COLUMN notes TEXT NOT NULL DEFAULT '[]';
ALTER TABLE jobs ADD COLUMN verdict TEXT NOT NULL DEFAULT '';
)sql"},
    // An index of its own, so that summing up somebody's jobs reads no documents.
    {5, "how many bytes projects and jobs keep, how long jobs worked, and when they ended", R"sql(
ALTER TABLE projects ADD COLUMN document_bytes INTEGER NOT NULL DEFAULT 0;
ALTER TABLE jobs ADD COLUMN document_bytes INTEGER NOT NULL DEFAULT 0;
ALTER TABLE jobs ADD COLUMN result_bytes INTEGER NOT NULL DEFAULT 0;
ALTER TABLE jobs ADD COLUMN worked_ms INTEGER NOT NULL DEFAULT 0;
CREATE INDEX projects_kept ON projects (owner, document_bytes);
CREATE INDEX jobs_kept ON jobs (owner, document_bytes, result_bytes);
CREATE INDEX jobs_ended ON jobs (ended_ms, owner, id) WHERE ended_ms > 0;
UPDATE projects SET document_bytes = length(CAST(document AS BLOB));
UPDATE jobs SET document_bytes = length(CAST(document AS BLOB)), result_bytes =
  coalesce((SELECT sum(value) FROM json_each(CASE WHEN json_valid(results) THEN results ELSE '{}' END)), 0);
)sql"},
    {6, "how urgent jobs are", R"sql(
ALTER TABLE jobs ADD COLUMN priority TEXT NOT NULL DEFAULT 'batch';
)sql"},
    {7, "what the results of jobs follow from", R"sql(
ALTER TABLE jobs ADD COLUMN input TEXT NOT NULL DEFAULT '';
CREATE INDEX jobs_by_input ON jobs (owner, input, id) WHERE input <> '' AND state = 'succeeded';
)sql"},
    {8, "who works on a job", R"sql(
ALTER TABLE jobs ADD COLUMN suspect INTEGER NOT NULL DEFAULT 0;
ALTER TABLE jobs ADD COLUMN holder TEXT NOT NULL DEFAULT '';
ALTER TABLE jobs ADD COLUMN lease INTEGER NOT NULL DEFAULT 0;
ALTER TABLE jobs ADD COLUMN lease_until_ms INTEGER NOT NULL DEFAULT 0;
ALTER TABLE jobs ADD COLUMN progress TEXT NOT NULL DEFAULT '';
)sql"},
    // A key is found by the hash of its secret, which is kept nowhere.
    {9, "who may come in", R"sql(
CREATE TABLE accounts (
  id TEXT NOT NULL PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  admin INTEGER NOT NULL,
  locked INTEGER NOT NULL,
  password TEXT NOT NULL,
  created_ms INTEGER NOT NULL
) STRICT;

CREATE TABLE keys (
  hash TEXT NOT NULL PRIMARY KEY,
  id TEXT NOT NULL,
  owner TEXT NOT NULL,
  kind TEXT NOT NULL,
  label TEXT NOT NULL,
  scopes TEXT NOT NULL,
  job TEXT NOT NULL DEFAULT '',
  created_ms INTEGER NOT NULL,
  expires_ms INTEGER NOT NULL
) STRICT;
CREATE INDEX keys_by_owner ON keys (owner, id);
)sql"},
    {10, "links by which a job is shown to others", R"sql(
ALTER TABLE keys DROP COLUMN job;
CREATE TABLE links (
  hash TEXT NOT NULL PRIMARY KEY,
  id TEXT NOT NULL,
  owner TEXT NOT NULL,
  job TEXT NOT NULL,
  label TEXT NOT NULL,
  takes TEXT NOT NULL,
  created_ms INTEGER NOT NULL,
  expires_ms INTEGER NOT NULL,
  revoked_ms INTEGER NOT NULL
) STRICT;
CREATE INDEX links_by_owner ON links (owner, id);
)sql"},
    // Written by triggers: whoever changes a job, in whichever process, writes its event in the same
    // transaction, and nobody can forget to. Numbers are an owner's own, so that they tell nothing of others.
    {11, "what becomes of jobs", R"sql(
CREATE TABLE events (
  owner TEXT NOT NULL,
  number INTEGER NOT NULL,
  at_ms INTEGER NOT NULL,
  job TEXT NOT NULL,
  project_id TEXT NOT NULL,
  state TEXT NOT NULL,
  name TEXT NOT NULL,
  reason_code TEXT NOT NULL,
  PRIMARY KEY (owner, number)
) STRICT, WITHOUT ROWID;
CREATE TRIGGER job_is_made AFTER INSERT ON jobs BEGIN
  INSERT INTO events (owner, number, at_ms, job, project_id, state, name, reason_code)
  SELECT NEW.owner, 1 + coalesce((SELECT max(number) FROM events WHERE owner = NEW.owner), 0),
    CAST(1000 * 86400 * (julianday('now') - 2440587.5) AS INTEGER), NEW.id, NEW.project_id, NEW.state, NEW.name,
    NEW.reason_code;
END;
CREATE TRIGGER job_is_changed AFTER UPDATE OF state ON jobs WHEN NEW.state <> OLD.state BEGIN
  INSERT INTO events (owner, number, at_ms, job, project_id, state, name, reason_code)
  SELECT NEW.owner, 1 + coalesce((SELECT max(number) FROM events WHERE owner = NEW.owner), 0),
    CAST(1000 * 86400 * (julianday('now') - 2440587.5) AS INTEGER), NEW.id, NEW.project_id, NEW.state, NEW.name,
    NEW.reason_code;
END;
CREATE TRIGGER job_is_removed AFTER DELETE ON jobs BEGIN
  INSERT INTO events (owner, number, at_ms, job, project_id, state, name, reason_code)
  SELECT OLD.owner, 1 + coalesce((SELECT max(number) FROM events WHERE owner = OLD.owner), 0),
    CAST(1000 * 86400 * (julianday('now') - 2440587.5) AS INTEGER), OLD.id, OLD.project_id, 'removed', OLD.name,
    OLD.reason_code;
END;
CREATE TRIGGER old_events_go AFTER INSERT ON events WHEN NEW.number % 100 = 0 BEGIN
  DELETE FROM events WHERE owner = NEW.owner AND number <= NEW.number - 1000;
END;
)sql"},
    // What is to be told is written where the event is. A secret is needed to sign, so it is kept itself.
    {12, "who is told of jobs that have ended", R"sql(
CREATE TABLE webhooks (
  owner TEXT NOT NULL,
  id TEXT NOT NULL,
  url TEXT NOT NULL,
  secret TEXT NOT NULL,
  states TEXT NOT NULL,
  label TEXT NOT NULL,
  created_ms INTEGER NOT NULL,
  PRIMARY KEY (owner, id)
) STRICT;
CREATE TABLE deliveries (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  owner TEXT NOT NULL,
  webhook TEXT NOT NULL,
  event INTEGER NOT NULL,
  at_ms INTEGER NOT NULL,
  job TEXT NOT NULL,
  project_id TEXT NOT NULL,
  name TEXT NOT NULL,
  state TEXT NOT NULL,
  reason_code TEXT NOT NULL,
  outcome TEXT NOT NULL DEFAULT 'waiting',
  attempts INTEGER NOT NULL DEFAULT 0,
  next_ms INTEGER NOT NULL DEFAULT 0,
  status INTEGER NOT NULL DEFAULT 0,
  error TEXT NOT NULL DEFAULT ''
) STRICT;
CREATE INDEX deliveries_by_webhook ON deliveries (owner, webhook, number);
CREATE INDEX deliveries_that_wait ON deliveries (owner, next_ms) WHERE outcome = 'waiting';
CREATE TRIGGER ends_are_told AFTER INSERT ON events WHEN NEW.state IN ('succeeded', 'failed', 'cancelled') BEGIN
  INSERT INTO deliveries (owner, webhook, event, at_ms, job, project_id, name, state, reason_code)
  SELECT NEW.owner, w.id, NEW.number, NEW.at_ms, NEW.job, NEW.project_id, NEW.name, NEW.state, NEW.reason_code
  FROM webhooks w WHERE w.owner = NEW.owner AND instr(',' || w.states || ',', ',' || NEW.state || ',') > 0;
END;
CREATE TRIGGER old_deliveries_go AFTER INSERT ON deliveries BEGIN
  DELETE FROM deliveries WHERE owner = NEW.owner AND webhook = NEW.webhook AND number <=
    (SELECT number FROM deliveries WHERE owner = NEW.owner AND webhook = NEW.webhook ORDER BY number DESC LIMIT 1 OFFSET 500);
END;
)sql"},
    {13, "words that owners put on jobs", R"sql(
CREATE TABLE tags (
  owner TEXT NOT NULL,
  job TEXT NOT NULL,
  tag TEXT NOT NULL,
  PRIMARY KEY (owner, job, tag)
) STRICT, WITHOUT ROWID;
CREATE TRIGGER tags_go_with_their_job AFTER DELETE ON jobs BEGIN
  DELETE FROM tags WHERE owner = OLD.owner AND job = OLD.id;
END;
)sql"},
    {14, "drapes that were asked for together", kSweepSchema},
    {15, "drapes without pictures", "ALTER TABLE jobs ADD COLUMN pictures INTEGER NOT NULL DEFAULT 1;"},
    {16, "named states of projects", kVersionSchema},
};

constexpr const char* kRemembered = R"sql(
CREATE TABLE IF NOT EXISTS schema_migrations (
  number INTEGER PRIMARY KEY,
  name TEXT NOT NULL
) STRICT;
)sql";

/// The number of the newest step that the database has been through, 0 for none.
Result<int> newest_of(SqlDatabase& database) {
  SqlStatement newest = TRY(database.prepare("SELECT max(number) FROM schema_migrations"));
  TRY(newest.step());
  return static_cast<int>(newest.integer(0));
}

Status apply(SqlDatabase& database, const Migration& step) {
  SqlTransaction transaction = TRY(SqlTransaction::begin(database));
  TRY(database.run_script(step.sql));
  TRY(database.run("INSERT INTO schema_migrations (number, name) VALUES (?, ?)",
                   {std::int64_t{step.number}, std::string_view(step.name)}));
  return transaction.commit();
}

}  // namespace

std::span<const Migration> migrations() { return kMigrations; }

Status check_schema(SqlDatabase& database, std::span<const Migration> steps) {
  TRY(database.run_script(kRemembered));
  const int newest = TRY(newest_of(database));
  const int known = steps.empty() ? 0 : steps.back().number;
  if (newest == known) return {};
  return Error{"store.other_schema",
               "a toile of another version works on this folder (schema " + std::to_string(newest) +
                   ", and this one knows " + std::to_string(known) + "); stop it first",
               "", ErrorKind::kConflict};
}

Status migrate(SqlDatabase& database, std::span<const Migration> steps) {
  TRY(database.run_script(kRemembered));
  const int newest = TRY(newest_of(database));
  const int known = steps.empty() ? 0 : steps.back().number;
  if (newest > known) {
    return Error{"store.newer_schema",
                 "a newer toile has written this database (schema " + std::to_string(newest) +
                     ", and this one knows up to " + std::to_string(known) +
                     "); start that version, or give this one a folder of its own",
                 "", ErrorKind::kConflict};
  }
  for (const Migration& step : steps) {
    if (step.number <= newest) continue;
    TRY(apply(database, step));
  }
  return {};
}

}  // namespace toile::sqlite
