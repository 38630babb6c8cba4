// Checkpoints of drapes (core/drape/checkpoint.h).

#include "core/drape/checkpoint.h"

#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/sealed.h"

namespace toile::fuzz {
namespace {

const std::string kInput(kSealDigits, '0');

/// Of so many vertices in mid-air.
drape::RunState hanging(std::size_t count) {
  drape::RunState state;
  drape::SessionState& session = state.session;
  session.solver.positions.resize(count);
  session.solver.velocities.resize(count);
  session.solver.stopped.resize(count);
  session.solver.stuck.resize(count);
  session.solver.steps_near.resize(count);
  session.watch.window_start.resize(count);
  session.watch.mark.resize(count);
  session.joined.resize(count);
  return state;
}

}  // namespace

std::vector<std::string> seeds() {
  return {unsealed(drape::encode_checkpoint(kInput, hanging(0))),
          unsealed(drape::encode_checkpoint(kInput, hanging(3)))};
}

void try_input(std::string_view bytes) {
  const Result<drape::RunState> state = drape::decode_checkpoint(sealed(bytes), kInput);
  if (!state) return;
  const solver::SolverState& s = state->session.solver;
  expect(s.velocities.size() == s.positions.size(), "every vertex has its velocity");
  expect(drape::decode_checkpoint(drape::encode_checkpoint(kInput, *state), kInput).ok(),
         "what is written is read again");
}

}  // namespace toile::fuzz
