#pragma once
// Would cloth stay if it were let go? Slow cloth in a thick medium may creep far yet, and what is about to
// tip over hardly moves before it does. So what seems to be at rest is let go: from a standstill, in true
// motion without damping, for a moment. Cloth that is off its balance by δ and swings at ω is δ (1 − cos ω t)
// away by then, and what leaves a balance that does not hold goes faster and faster: no damping hides either.
// What has gone is stopped and looked at again, or goes on in its thick medium, nearer to rest for it
// (kinetic damping: Cundall, "Explicit finite-difference methods in geomechanics", 1976).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::drape {

/// How much sooner than otherwise cloth seems to be at rest (SettleWatch::settled) that is let go then: share
/// of the speed.
inline constexpr double kSeemingCalm = 2;

/// What a RestProbe remembers.
struct ProbeState {
  int step = 0;            ///< steps since the cloth was let go
  int failed = 0;          ///< how often it went away
  std::vector<Vec3> from;  ///< m, where it was let go; empty while it is not
};

class RestProbe {
 public:
  enum class Answer : std::uint8_t {
    kNotYet,
    kStays,
    kGoes,   ///< on its way as a whole: back to the thick medium
    kAgain,  ///< only a patch went: let all go again where it is now
  };

  /// `speed`: RMS speed (m/s) under which cloth counts as at rest.
  RestProbe(double time_step, double speed) : time_step_(time_step), speed_(speed) {}

  /// Whether cloth that seems to be at rest is let go: not for ever, since some never stays.
  bool asks() const;
  bool on() const { return !seen_.from.empty(); }  ///< the cloth is let go
  /// Lets the cloth go from a standstill at x (m).
  void begin(std::span<const Vec3> x);
  /// After a step without damping that ended at x. Any answer but kNotYet ends the probe. REQUIRES on().
  Answer observe(std::span<const Vec3> x, std::span<const std::array<Index, 3>> triangles);
  /// As if nothing had ever been asked.
  void restart() { seen_ = {}; }

  const ProbeState& state() const { return seen_; }
  void restore(ProbeState state) { seen_ = std::move(state); }

 private:
  double time_step_, speed_;
  ProbeState seen_;
};

}  // namespace toile::drape
