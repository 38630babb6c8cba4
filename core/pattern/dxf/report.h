#pragma once
// What a DXF reader did with each entity of the file.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"

namespace toile::dxf {

enum class DxfFate {
  kKept,       ///< as it stands in the file, but for the unit
  kConverted,  ///< something else stands for it: curves for arcs, names for texts, a mirrored half for a line
  kDropped,
};

/// Entities of one kind that fared alike.
struct DxfEntityGroup {
  std::string type, layer;
  std::string block;  ///< empty: in the section ENTITIES
  DxfFate fate = DxfFate::kDropped;
  std::string reason;
  std::string piece;       ///< of the result; empty when it has no part in any
  std::vector<int> lines;  ///< where each entity begins, from 1
};

struct DxfWarning {
  int line = 0;
  std::string piece;       ///< empty when it concerns none
  std::optional<Vec2> at;  ///< mm, in the drawing
  std::string text;
  std::size_t count = 1;  ///< how often the same came up
};

/// Everything in the file that begins with group 0:
/// records == structure + elsewhere + vertices + entities, and entities == kept + converted + dropped.
struct DxfReport {
  std::size_t records = 0;
  std::size_t structure = 0;  ///< SECTION, ENDSEC, BLOCK, ENDBLK, EOF
  std::size_t elsewhere = 0;  ///< tables, classes, objects: no drawing
  std::size_t vertices = 0;   ///< VERTEX and SEQEND, told of with their POLYLINE
  std::size_t entities = 0, kept = 0, converted = 0, dropped = 0;
  std::vector<DxfEntityGroup> groups;  ///< by their first line
  std::vector<DxfWarning> warnings;    ///< by line; at most 500 kinds
};

/// "line 12, piece front: …", as a person reads it.
std::string warning_text(const DxfWarning& warning);

/// What a pass over the drawing tells of the file. It gives this back with what it makes, so that a pass can
/// be read (and run again, in another unit) by itself; the log takes it in. Entities go by their numbers in
/// the log, pieces by the numbers that DxfLog::report() resolves.
struct DxfNotes {
  struct Mark {
    std::size_t entity = 0;
    DxfFate fate = DxfFate::kDropped;
    std::string reason;
    int piece = -1;
  };
  struct Warning {
    int line = 0;
    std::string text;
    int piece = -1;
    std::optional<Vec2> at;  ///< mm, in the drawing
  };
  std::vector<Mark> marks;  ///< in order: the last one on an entity counts
  std::vector<Warning> warnings;
  std::optional<Error> fault;  ///< the first thing that could not be read; an error when nothing else could
  std::optional<Error> open;   ///< the first line that does not close, where it may have been meant to

  void mark(std::size_t entity, DxfFate fate, std::string reason, int piece = -1);
  void warn(int line, std::string text, int piece = -1, std::optional<Vec2> at = {});
  void fail(const Error& error);
  /// What a later pass told.
  void add(DxfNotes later);
};

/// The report in the making.
class DxfLog {
 public:
  void structure() { ++report_.structure; }
  void elsewhere() { ++report_.elsewhere; }
  void vertex() { ++report_.vertices; }

  /// A new entity; the number names it from here on.
  std::size_t add(std::string_view type, std::string_view layer, std::string_view block, int line);
  /// What became of it; the last word counts. `piece` is an index that report() resolves.
  void mark(std::size_t entity, DxfFate fate, std::string_view reason, int piece = -1);
  bool is_marked(std::size_t entity) const { return entities_[entity].reason >= 0; }
  void warn(int line, std::string text, int piece = -1, std::optional<Vec2> at = {});
  /// Takes in what a pass has told; its faults are for the reader.
  void take(const DxfNotes& notes);

  DxfReport report(const std::vector<std::string>& piece_names) const;

 private:
  struct Entity {
    int type = 0, layer = 0, block = 0, line = 0, reason = -1, piece = -1;
    DxfFate fate = DxfFate::kDropped;
  };
  struct Warning {
    int line = 0, piece = -1;
    std::optional<Vec2> at;
    std::size_t count = 0;
  };
  int number_of_word(std::string_view word);

  DxfReport report_;
  std::vector<Entity> entities_;
  std::map<std::string, int, std::less<>> numbers_;
  std::vector<std::string> words_;
  std::map<std::pair<std::string, int>, Warning> warnings_;  // by text and piece
};

}  // namespace toile::dxf
