#pragma once

namespace toile::sqlite {

/// A sweep is no more than what its cells are called: which drape stands in which cell its jobs say, so that
/// a drape that was tried again takes the place of the one before. It goes with the last of them. Events say
/// of which sweep a job is; one of the sweep itself (without a job) follows the end of its last drape, and
/// says how the newest drapes of its cells have come out.
inline constexpr const char* kSweepSchema = R"sql(
CREATE TABLE sweeps (
  owner TEXT NOT NULL,
  id TEXT NOT NULL,
  project_id TEXT NOT NULL,
  project_revision INTEGER NOT NULL,
  name TEXT NOT NULL,
  created_ms INTEGER NOT NULL,
  idempotency_key TEXT,
  bodies TEXT NOT NULL,
  fabrics TEXT NOT NULL,
  PRIMARY KEY (owner, id)
) STRICT;
CREATE UNIQUE INDEX sweeps_by_key ON sweeps (owner, idempotency_key) WHERE idempotency_key IS NOT NULL;
ALTER TABLE jobs ADD COLUMN sweep TEXT NOT NULL DEFAULT '';
ALTER TABLE jobs ADD COLUMN sweep_body INTEGER NOT NULL DEFAULT 0;
ALTER TABLE jobs ADD COLUMN sweep_fabric INTEGER NOT NULL DEFAULT 0;
CREATE INDEX jobs_by_sweep ON jobs (owner, sweep, id) WHERE sweep <> '';
ALTER TABLE events ADD COLUMN sweep TEXT NOT NULL DEFAULT '';
ALTER TABLE deliveries ADD COLUMN sweep TEXT NOT NULL DEFAULT '';
DROP TRIGGER job_is_made;
DROP TRIGGER job_is_changed;
DROP TRIGGER job_is_removed;
DROP TRIGGER ends_are_told;
CREATE TRIGGER job_is_made AFTER INSERT ON jobs BEGIN
  INSERT INTO events (owner, number, at_ms, job, project_id, state, name, reason_code, sweep)
  SELECT NEW.owner, 1 + coalesce((SELECT max(number) FROM events WHERE owner = NEW.owner), 0),
    CAST(1000 * 86400 * (julianday('now') - 2440587.5) AS INTEGER), NEW.id, NEW.project_id, NEW.state, NEW.name,
    NEW.reason_code, NEW.sweep;
END;
CREATE TRIGGER job_is_changed AFTER UPDATE OF state ON jobs WHEN NEW.state <> OLD.state BEGIN
  INSERT INTO events (owner, number, at_ms, job, project_id, state, name, reason_code, sweep)
  SELECT NEW.owner, 1 + coalesce((SELECT max(number) FROM events WHERE owner = NEW.owner), 0),
    CAST(1000 * 86400 * (julianday('now') - 2440587.5) AS INTEGER), NEW.id, NEW.project_id, NEW.state, NEW.name,
    NEW.reason_code, NEW.sweep;
  INSERT INTO events (owner, number, at_ms, job, project_id, state, name, reason_code, sweep)
  SELECT NEW.owner, 1 + coalesce((SELECT max(number) FROM events WHERE owner = NEW.owner), 0),
    CAST(1000 * 86400 * (julianday('now') - 2440587.5) AS INTEGER), '', s.project_id,
    CASE WHEN EXISTS (SELECT 1 FROM jobs j WHERE j.owner = NEW.owner AND j.sweep = NEW.sweep AND j.state = 'failed'
           AND NOT EXISTS (SELECT 1 FROM jobs k WHERE k.owner = j.owner AND k.sweep = j.sweep
             AND k.sweep_body = j.sweep_body AND k.sweep_fabric = j.sweep_fabric AND k.id > j.id)) THEN 'failed'
         WHEN EXISTS (SELECT 1 FROM jobs j WHERE j.owner = NEW.owner AND j.sweep = NEW.sweep AND j.state = 'cancelled'
           AND NOT EXISTS (SELECT 1 FROM jobs k WHERE k.owner = j.owner AND k.sweep = j.sweep
             AND k.sweep_body = j.sweep_body AND k.sweep_fabric = j.sweep_fabric AND k.id > j.id)) THEN 'cancelled' ELSE 'succeeded' END,
    s.name, '', s.id
  FROM sweeps s WHERE s.owner = NEW.owner AND s.id = NEW.sweep AND NEW.sweep <> ''
    AND NEW.state IN ('succeeded', 'failed', 'cancelled')
    AND NOT EXISTS (SELECT 1 FROM jobs WHERE owner = NEW.owner AND sweep = NEW.sweep
                    AND state IN ('queued', 'running', 'paused'));
END;
CREATE TRIGGER job_is_removed AFTER DELETE ON jobs BEGIN
  INSERT INTO events (owner, number, at_ms, job, project_id, state, name, reason_code, sweep)
  SELECT OLD.owner, 1 + coalesce((SELECT max(number) FROM events WHERE owner = OLD.owner), 0),
    CAST(1000 * 86400 * (julianday('now') - 2440587.5) AS INTEGER), OLD.id, OLD.project_id, 'removed', OLD.name,
    OLD.reason_code, OLD.sweep;
  INSERT INTO events (owner, number, at_ms, job, project_id, state, name, reason_code, sweep)
  SELECT OLD.owner, 1 + coalesce((SELECT max(number) FROM events WHERE owner = OLD.owner), 0),
    CAST(1000 * 86400 * (julianday('now') - 2440587.5) AS INTEGER), '', s.project_id, 'removed', s.name, '', s.id
  FROM sweeps s WHERE s.owner = OLD.owner AND s.id = OLD.sweep AND OLD.sweep <> ''
    AND NOT EXISTS (SELECT 1 FROM jobs WHERE owner = OLD.owner AND sweep = OLD.sweep);
  DELETE FROM sweeps WHERE owner = OLD.owner AND id = OLD.sweep AND OLD.sweep <> ''
    AND NOT EXISTS (SELECT 1 FROM jobs WHERE owner = OLD.owner AND sweep = OLD.sweep);
END;
CREATE TRIGGER ends_are_told AFTER INSERT ON events WHEN NEW.state IN ('succeeded', 'failed', 'cancelled') BEGIN
  INSERT INTO deliveries (owner, webhook, event, at_ms, job, project_id, name, state, reason_code, sweep)
  SELECT NEW.owner, w.id, NEW.number, NEW.at_ms, NEW.job, NEW.project_id, NEW.name, NEW.state, NEW.reason_code, NEW.sweep
  FROM webhooks w WHERE w.owner = NEW.owner AND instr(',' || w.states || ',', ',' || NEW.state || ',') > 0;
END;
)sql";

}  // namespace toile::sqlite
