#pragma once
// A drape under way, by whichever method the settings ask for. Advances by steps, so that whoever runs it may
// watch, pause or stop between any two.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/crew.h"
#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/drape/checkpoint.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/drape/stop_reason.h"
#include "core/drape/touch.h"
#include "core/sewing/assembly.h"

namespace toile::drape {

class Session {
 public:
  Session() = default;
  virtual ~Session() = default;
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// One step, with the help of a crew that changes no byte of it. REQUIRES !done().
  virtual void step(Crew& crew) = 0;
  /// Begins once more, on the body, as with `dressed` and `ground` at its start: steps and time count on.
  virtual void begin_anew(const std::vector<Vec3>& dressed, std::optional<double> ground) = 0;
  /// Whether another start is tried where this one leads to open seams or to a garment that is not worn.
  virtual bool may_begin_anew() const = 0;

  /// A hand on the cloth, before the next step; its own step does not count. Errors: those of Hands::take;
  /// live.over where the drape is done, live.method where its method takes no hands. REQUIRES no step under
  /// way.
  virtual Status touch(const Touch& touch);
  virtual const HandsState& hands() const;

  /// All that the session must remember, for restore().
  virtual SessionState state() const = 0;
  /// Goes on where another session stood that was started from the same input. Error: checkpoint.damaged when
  /// the state does not fit this garment.
  virtual Status restore(SessionState state) = 0;

  virtual Began began() const = 0;
  virtual bool lost_seams() const = 0;  ///< the threads of a seam have let go
  bool done() const { return stop_reason().has_value(); }
  /// Why it ended; nothing until done(). Never Stop::kCancelled: that is for whoever runs the session to say.
  virtual const std::optional<StopReason>& stop_reason() const = 0;

  virtual int steps() const = 0;
  virtual double time() const = 0;       ///< s, simulated
  virtual bool just_welded() const = 0;  ///< in the last step
  virtual Progress progress() const = 0;
  virtual const sewing::GarmentMesh& garment() const = 0;
  virtual double rms_speed() const = 0;
  virtual double max_speed() const = 0;
  virtual double seam_gap() const = 0;  ///< m, the largest
  virtual std::vector<OpenSeam> open_seams() const = 0;
  /// m, of each body as it is now; empty lists of those that do not move.
  virtual std::vector<std::vector<Vec3>> moved_bodies() const = 0;
  virtual MotionFigures motion() const = 0;
  virtual std::vector<HoldFigures> holds() const = 0;  ///< one for each attachment
  /// Left, right: whether the garment stays on the wearer's shoulder only since it is held there.
  virtual std::array<bool, 2> held_on_shoulders() const = 0;

  virtual std::vector<Vec3> positions() const = 0;  ///< m, of the garment's vertices
  virtual const std::vector<Vec3>& start_positions() const = 0;
  virtual CrossingCount count_crossings(Crew& crew) = 0;  ///< exact, now
};

}  // namespace toile::drape
