#pragma once

namespace toile::sqlite {

/// A version has the whole state, not a revision's number: a history is bounded and goes when a project is
/// replaced, and a state that somebody named must not. Which drapes were made of it is told by their
/// documents, so that those after a return to it count as well.
inline constexpr const char* kVersionSchema = R"sql(
CREATE TABLE versions (
  owner TEXT NOT NULL,
  project_id TEXT NOT NULL,
  id TEXT NOT NULL,
  name TEXT NOT NULL,
  revision INTEGER NOT NULL,
  created_ms INTEGER NOT NULL,
  document TEXT NOT NULL,
  line TEXT NOT NULL,
  files TEXT NOT NULL,
  document_bytes INTEGER NOT NULL,
  PRIMARY KEY (owner, project_id, id)
) STRICT;
CREATE UNIQUE INDEX versions_by_name ON versions (owner, project_id, name);
CREATE TRIGGER versions_go_with_their_project AFTER DELETE ON projects BEGIN
  DELETE FROM versions WHERE owner = OLD.owner AND project_id = OLD.id;
END;
)sql";

}  // namespace toile::sqlite
