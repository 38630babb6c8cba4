#pragma once
// What a sweep has come to: for each body and fabric how the drape stands and what its report says.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/tree.h"

namespace toile::sweep {

/// A girth of the report (core/analysis/fit.h): how the garment fits there, and garment less body, mm.
struct Ease {
  std::string fit;  ///< "fits", "stretched", "too_tight"
  double ease_mm = 0;
  friend bool operator==(const Ease&, const Ease&) = default;
};

/// A drape's figures, of its report.
struct Figures {
  bool settled = false;
  std::string stop_reason;
  std::string worn;                      ///< "yes", "partly", "no"; empty: nobody stands there
  std::optional<Ease> bust, waist, hip;  ///< where the garment goes around
  double warp_p99 = 0, weft_p99 = 0;     ///< tension, as a ratio; 99 % of the triangles have less
  double shear_p99 = 0;                  ///< rad
  int cloth_body = 0, cloth_cloth = 0;   ///< crossings at the end
  int worst_body = 0, worst_cloth = 0;   ///< in the worst of the frames that were looked at
  int open_seams = 0;
  double cpu_s = 0, simulated_s = 0;
  int particles = 0;
  std::string hash;  ///< of the final positions
  friend bool operator==(const Figures&, const Figures&) = default;
};

/// Nothing: it is no report.
std::optional<Figures> figures_of(const json::JsonValue& report);

struct Cell {
  std::string job;    ///< id; empty: it is not there any more, or was draped without a service
  std::string state;  ///< a job's word, or "removed"
  std::string reason_code, reason;
  double fraction = 0;  ///< of the drape; 1 when it has ended
  std::optional<Figures> figures;
  bool pictured = false;  ///< its still from the front can be had
};

/// Cells by body, then by fabric.
struct Table {
  std::string name;
  std::vector<std::string> bodies, fabrics;
  std::vector<Cell> cells;  ///< bodies.size() × fabrics.size()
  const Cell& at(std::size_t body, std::size_t fabric) const { return cells[body * fabrics.size() + fabric]; }
};

/// {"body", "fabric", "job", "state", "reason_code", "reason", "fraction", "pictured", "figures"} of one.
json::JsonValue cell_json(const Table& table, std::size_t body, std::size_t fabric);

/// And back, without its labels; what is not there is as in a Cell.
Cell cell_from(const json::JsonValue& cell);

/// One line for each cell under a line of names (RFC 4180, UTF-8); a cell without figures has empty fields.
/// Lengths in mm, stretch in percent, shear in degrees.
std::string table_csv(const Table& table);

/// How many cells stand at each word.
struct Counts {
  int queued = 0, running = 0, paused = 0, succeeded = 0, failed = 0, cancelled = 0, removed = 0;
  int unfinished() const { return queued + running + paused; }
  double fraction = 0;  ///< of all its work, cells counting alike
};
Counts counts_of(const Table& table);

}  // namespace toile::sweep
