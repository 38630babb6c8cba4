#pragma once
// A drape under way as bytes: the state from which it goes on as if it had never been broken off.
//
// Kept is what only the steps themselves can give: where things are, how fast, since when. Whatever follows
// from the input and the weld state (masses, rest shapes, neighbours, holds, threads, contacts) is made again
// by the code that makes it at a start. All of it is plain data behind one function, fields(): who gives the
// drape a memory of another kind adds it there and raises kCheckpointVersion.
//
//   "TOILECP\n" | version u32 | input hash, 32 hex digits | fields | hash of all before, 32 hex digits
//
// Little endian; doubles as they are. 235 bytes a particle, 24 more while it is let go, and some 300 a
// contact: 1 to 3 MB for 3,000 particles.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/drape/body_motion.h"
#include "core/drape/drape_result.h"
#include "core/drape/rest_probe.h"
#include "core/drape/settle.h"
#include "core/drape/stop_reason.h"
#include "core/drape/touch.h"
#include "core/paper/paper_cloth.h"
#include "core/solver/cloth_solver.h"

namespace toile::drape {

/// Rises when the fields change, and whenever a change of the engine gives a drape other bytes: a drape begun
/// by one engine and ended by another would be neither's.
inline constexpr std::uint32_t kCheckpointVersion = 35;

enum class DrapePhase : std::uint8_t { kSew, kDrape, kDone };

/// Where the cloth of a drape was at its start.
enum class Began : std::uint8_t {
  kPlaced,   ///< flat pieces where they are placed
  kDressed,  ///< on the body (core/dressing)
  kWarm,     ///< as it hung at the end of another drape (core/warm)
};

/// What a Session remembers.
struct SessionState {
  DrapePhase phase = DrapePhase::kSew;
  Began began = Began::kPlaced;
  std::vector<bool> lost;                 ///< seams whose threads have let go
  std::optional<StopReason> stop_reason;  ///< while phase is kDone
  int steps = 0;
  double time = 0, begun = 0, phase_start = 0, last_weld = 0;  ///< s
  int slackened = 0;                                           ///< how often threads were let out again
  std::vector<bool> joined;            ///< garment vertices welded to the least of their class
  std::vector<bool> released;          ///< attachments
  std::vector<double> off_at_release;  ///< m, of each
  SettleState watch;
  solver::SolverState solver;
  ProbeState probe;
  MotionState motion;
  HandsState hands;
  paper::PaperState paper;  ///< in place of the solver's, of a drape by that method
};

/// What a DrapeRun remembers.
struct RunState {
  SessionState session;
  CrossingCount at_end, worst;
  int worst_frame_step = 0, frames_checked = 0, resumed = 0;
  int recorded = -1;            ///< step of the newest recorded frame
  int start = 0;                ///< number of the start it goes on from (core/drape/drape_start.h)
  bool last_start = false;      ///< no other leads on
  std::string begun_anew;       ///< why it does not go on from its first start; empty when it does
  std::string from_the_pieces;  ///< why it does not go on from another's end; empty where it need not or does
  std::vector<double> tops;     ///< m, of each panel where it began (core/drape/worn_verdict.h)
  std::vector<bool> left_out;   ///< panels that could not be put on (core/drape/fit_start.h); may be empty
  double cpu_s = 0, wall_s = 0;  ///< so far
};

/// `input_hash` as input_hash() gives it.
std::string encode_checkpoint(const std::string& input_hash, RunState state);

/// Errors: checkpoint.damaged (cut off, changed, or no checkpoint at all), checkpoint.version (of another
/// engine), checkpoint.other_input. Takes no more memory than a few times the bytes. Whether the numbers of
/// vertices fit the garment is for the Session to say.
Result<RunState> decode_checkpoint(std::string_view bytes, const std::string& input_hash);

/// A checkpoint that cannot be what it says it is.
Error damaged_checkpoint();

}  // namespace toile::drape
