#pragma once
// The manifest's keys, for its reader, its writer and its schema.

#include "core/json/fields/range.h"
#include "core/manifest/manifest.h"
#include "core/project/fields.h"

namespace toile::fields {

inline constexpr Range kCounted{0};

template <typename Visitor>
void describe(Visitor& v, manifest::FileMark& file) {
  v.object("file", "A file by its content.");
  v.field("name", file.name, "Its name, as the document or the folder has it.", Need::kRequired);
  v.field("bytes", file.bytes, "How long it is.", Need::kRequired, kCounted);
  v.field("hash", file.hash, "128-bit XXH3 of its bytes, 32 hex digits.", Need::kRequired);
}

template <typename Visitor>
void describe(Visitor& v, manifest::Maker& maker) {
  v.object("maker", "Which program draped.");
  v.field("version", maker.version, "As toile --version tells it.", Need::kRequired);
  v.field("engine", maker.engine, "Rises when the engine's bytes change.", Need::kRequired, kCounted);
  v.field("program", maker.program, "Hash of the program; absent where it could not be read.");
}

template <typename Visitor>
void describe(Visitor& v, manifest::Manifest& m) {
  v.object("", "What a drape was made of and what came out. toile verify drapes again and compares.");
  v.field("toile_manifest", m.toile_manifest, "Version of this format.", Need::kRequired, Range{1, 1});
  v.field("made_by", m.made_by, "Which program draped.", Need::kRequired);
  v.field("project_path", m.project_path,
          "Where the document stood, relative to this file; absent where it came from a store.");
  v.field("from_path", m.from_path, "Likewise the final.hung that the drape went on from, if it did.");
  v.field("document", m.document,
          "The document as the program writes it, in one line: blanks and the order of keys do not count.",
          Need::kRequired);
  v.field("inputs", m.inputs,
          "Files that the document names, and final.hung where the drape went on from one; by name.");
  v.field("settings", m.settings,
          "How it was draped; what the document left out stands here as it was taken.", Need::kRequired);
  v.field("positions", m.positions, "Hash of the final positions, as in report.json.", Need::kRequired);
  v.field("steps", m.steps, "Substeps until the end.", Need::kRequired, kCounted);
  v.field("results", m.results,
          "Files whose bytes follow from the input alone, by name. Pictures and the report, which has times "
          "by the clock, are not among them.",
          Need::kRequired);
}

}  // namespace toile::fields
