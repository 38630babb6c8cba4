// A drape that is broken off and goes on from a checkpoint ends as one that is not.

#include "core/drape/checkpoint.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "core/base/hash.h"
#include "core/drape/pipeline.h"
#include "tests/core/drape/garments.h"
#include "tests/core/drape/runs.h"

namespace toile {
namespace {

std::unique_ptr<drape::DrapeRun> resumed(const drape::DrapeInput& input, const std::string& checkpoint) {
  Result<std::unique_ptr<drape::DrapeRun>> run = drape::DrapeRun::resume(input, checkpoint, {}, nullptr);
  EXPECT_TRUE(run.ok()) << to_string(run.error());
  return std::move(run).value();
}

/// A checkpoint without what belongs to the run and not to the drape: times, and how often it was broken off.
std::string state_in(const drape::DrapeRun& run) {
  const std::string hash = run.start_hash();
  drape::RunState state = drape::decode_checkpoint(run.checkpoint(), hash).value();
  state.cpu_s = state.wall_s = 0;
  state.resumed = 0;
  return drape::encode_checkpoint(hash, state);
}

struct Walked {
  std::map<int, std::string> states;       ///< by step
  std::map<int, std::string> checkpoints;  ///< the same moments
  drape::DrapeResult result;
};

/// The whole drape, looked at after these numbers of steps.
Walked walk(const drape::DrapeInput& input, const std::vector<int>& moments) {
  Walked walked;
  const auto run = begun(input);
  for (const int moment : moments) {
    run->advance(moment - run->session().steps(), {});
    walked.states[moment] = state_in(*run);
    walked.checkpoints[moment] = run->checkpoint();
  }
  run->advance(kToTheEnd, {});
  walked.result = run->conclude();
  return walked;
}

/// The step after which the seams are welded.
int step_of_weld(const drape::DrapeInput& input) {
  const auto run = begun(input);
  while (run->session().progress().phase == "sew") run->advance(1, {});
  return run->session().steps();
}

void expect_same(const drape::DrapeResult& a, const drape::DrapeResult& b) {
  EXPECT_EQ(hash_of(a.positions), hash_of(b.positions));
  EXPECT_EQ(drape::to_string(a.stop_reason), drape::to_string(b.stop_reason));
  EXPECT_EQ(a.stop_reason.gap, b.stop_reason.gap) << "which no checkpoint keeps";
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.simulated_time, b.simulated_time);
  EXPECT_EQ(a.frames_checked, b.frames_checked);
  EXPECT_EQ(a.worst_frame_step, b.worst_frame_step);
  EXPECT_EQ(a.rms_speed, b.rms_speed);
  EXPECT_EQ(a.max_speed, b.max_speed);
  EXPECT_EQ(a.seam_gap_max, b.seam_gap_max);
}

/// A tube whose waist is let go, so that every kind of state comes up.
drape::DrapeInput released_tube() {
  drape::DrapeInput input = test::tube();
  input.attachments[0].release_after = 0.3;
  input.settings.max_time = 3;
  return input;
}

TEST(Checkpoint, FromEveryKindOfMomentTheDrapeGoesOnAsIfNothingHadHappened) {
  const drape::DrapeInput input = released_tube();
  const int weld = step_of_weld(input);
  const int hz = static_cast<int>(1 / input.settings.time_step + 0.5);
  const std::vector<int> moments = {0,
                                    1,
                                    2,
                                    weld / 2,
                                    weld - 1,
                                    weld,
                                    weld + 1,
                                    weld + 2,
                                    weld + hz / 4,           // gravity comes in
                                    weld + hz / 2 + hz / 8,  // it is full, and the waist held
                                    weld + hz / 2 + 3 * hz / 10 - 1,
                                    weld + hz / 2 + 3 * hz / 10 + 2,  // it was let go
                                    weld + hz + hz / 2 + 7};
  const Walked whole = walk(input, moments);
  ASSERT_GT(whole.result.steps, moments.back());
  for (std::size_t k = 0; k + 1 < moments.size(); ++k) {
    const auto run = resumed(input, whole.checkpoints.at(moments[k]));
    EXPECT_EQ(state_in(*run), whole.states.at(moments[k])) << "resumed at step " << moments[k];
    run->advance(moments[k + 1] - moments[k], {});
    EXPECT_EQ(state_in(*run), whole.states.at(moments[k + 1])) << "resumed at step " << moments[k];
  }
  const auto last = resumed(input, whole.checkpoints.at(moments.back()));
  last->advance(kToTheEnd, {});
  expect_same(last->conclude(), whole.result);
}

TEST(Checkpoint, OfADrapeBrokenOffAgainAndAgainChangesNothingButItsTimes) {
  const drape::DrapeInput input = released_tube();
  const drape::DrapeResult whole = drape::drape(input, {}, nullptr).value();
  std::string checkpoint = begun(input)->checkpoint();
  int breaks = 0;
  for (std::uint32_t random = 12345;;) {
    const auto run = resumed(input, checkpoint);
    random = random * 1664525u + 1013904223u;
    run->advance(1 + static_cast<int>(random >> 22), {});
    checkpoint = run->checkpoint();
    ++breaks;
    if (run->done()) break;
  }
  ASSERT_GT(breaks, 5);
  const auto run = resumed(input, checkpoint);
  EXPECT_TRUE(run->done()) << "also the end of a drape can be kept";
  const drape::DrapeResult broken = run->conclude();
  expect_same(broken, whole);
  EXPECT_EQ(broken.resumed, breaks + 1);
  EXPECT_GT(broken.cpu_s, 0.5 * whole.cpu_s) << "the times of all parts";
}

/// Three sheets that fall on a column and lie on each other, so that cloth meets cloth everywhere.
drape::DrapeInput layers() {
  drape::DrapeInput input = test::tablecloth();
  for (int k = 1; k < 3; ++k) {
    input.pattern.panels.push_back(test::rectangle("sheet" + std::to_string(k), 240 - 30 * k, 240 - 20 * k));
    auto above = std::get<sewing::RigidPlacement>(input.placements[0]);
    above.translation.y += 0.004 * k;
    above.rotation.y = 0.2 * k;
    input.placements.push_back(above);
    input.fabric_of_panel.push_back(0);
  }
  input.settings.max_time = 0.8;
  return input;
}

TEST(Checkpoint, OfLayersThatLieOnEachOtherEndsTheSame) {
  const drape::DrapeInput input = layers();
  const Walked whole = walk(input, {0, 700, 1300});
  for (const auto& [step, checkpoint] : whole.checkpoints) {
    const auto run = resumed(input, checkpoint);
    run->advance(kToTheEnd, {});
    expect_same(run->conclude(), whole.result);
  }
}

collision::Contacts contacts_of(const drape::DrapeRun& run) { return run.session().state().solver.contacts; }

/// A cloth that lies on a table and falls over its rim, and comes to lie on itself.
std::unique_ptr<drape::DrapeRun> cloth_in_contact(const drape::DrapeInput& input) {
  auto run = begun(input);
  while (contacts_of(*run).rims.empty() && run->session().steps() < 20'000) run->advance(100, {});
  return run;
}

/// Bytes of all that lists of contacts hold.
std::size_t bytes_of_lists(const collision::Contacts& contacts) {
  std::size_t planes = 0, near = 0;
  for (const auto& of_vertex : contacts.planes) planes += of_vertex.size();
  for (const auto& of_vertex : contacts.vertex_contacts) near += of_vertex.size();
  return 17 * contacts.pairs.size() + 36 * planes + 145 * near + 136 * contacts.rims.size();
}

TEST(Checkpoint, TakesTenVectorsAParticleTheContactsAndLittleElse) {
  const drape::DrapeInput input = test::tablecloth();
  const auto run = cloth_in_contact(input);
  const auto particles = static_cast<std::size_t>(run->session().garment().vertex_count());
  const std::size_t lists = bytes_of_lists(contacts_of(*run));
  EXPECT_GT(lists, 0u);
  // Positions, velocities, where each was measured and its bounds, places to tell rest by; then the ways of
  // three windows, in floats; and what each of two triangles a particle has learnt.
  EXPECT_LT(run->checkpoint().size(), 235 * particles + lists + 512);
}

TEST(Checkpoint, InTheMidstOfContactsOfDifferentTimesKeepsThemAll) {
  const drape::DrapeInput input = test::tablecloth();
  const auto run = cloth_in_contact(input);
  ASSERT_FALSE(contacts_of(*run).rims.empty());
  for (int k = 0; k < 20; ++k) {
    const auto on = resumed(input, run->checkpoint());
    run->advance(37, {});
    on->advance(37, {});
    ASSERT_EQ(state_in(*on), state_in(*run)) << "after " << run->session().steps() << " steps";
  }
}

TEST(Checkpoint, InTheMidstOfLettingGoEndsTheSame) {
  const drape::DrapeInput input = test::tube();
  const auto run = begun(input);
  while (!run->done() && run->session().state().probe.from.empty()) run->advance(1, {});
  ASSERT_FALSE(run->done()) << "nothing is at rest that was not let go";
  run->advance(333, {});
  ASSERT_FALSE(run->session().state().probe.from.empty());
  const auto on = resumed(input, run->checkpoint());
  EXPECT_EQ(state_in(*on), state_in(*run));
  run->advance(kToTheEnd, {});
  on->advance(kToTheEnd, {});
  const drape::DrapeResult end = run->conclude();
  EXPECT_TRUE(end.settled());
  expect_same(on->conclude(), end);
}

TEST(Checkpoint, OfAnotherInputIsRefused) {
  const drape::DrapeInput input = test::tube();
  const std::string checkpoint = begun(input)->checkpoint();
  const auto code = [&](const std::function<void(drape::DrapeInput&)>& change) {
    drape::DrapeInput other = input;
    change(other);
    const auto run = drape::DrapeRun::resume(other, checkpoint, {}, nullptr);
    return run ? "" : run.error().code;
  };
  EXPECT_EQ(code([](drape::DrapeInput&) {}), "");
  const std::string other = "checkpoint.other_input";
  EXPECT_EQ(code([](drape::DrapeInput& i) { i.settings.gravity = 9.8; }), other);
  EXPECT_EQ(code([](drape::DrapeInput& i) { i.settings.max_time += 1; }), other);
  EXPECT_EQ(code([](drape::DrapeInput& i) { i.settings.particle_distance = 0.03; }), other);
  EXPECT_EQ(code([](drape::DrapeInput& i) { i.fabrics[0].bend_bias *= 2; }), other);
  EXPECT_EQ(code([](drape::DrapeInput& i) { i.bodies[0].mesh.vertices[5].y += 1e-9; }), other);
  EXPECT_EQ(code([](drape::DrapeInput& i) { i.bodies[0].friction = 0.1; }), other);
  EXPECT_EQ(code([](drape::DrapeInput& i) { i.attachments[0].release_after = 1; }), other);
  EXPECT_EQ(code([](drape::DrapeInput& i) { i.attachments.clear(); }), other);
  EXPECT_EQ(code([](drape::DrapeInput& i) { i.pattern.seams.pop_back(); }), other);
  EXPECT_EQ(code([](drape::DrapeInput& i) {
              std::get<sewing::RigidPlacement>(i.placements[0]).translation.z += 0.01;
            }),
            other);
}

TEST(Checkpoint, CutOffOrChangedAnywhereIsRefusedAndNothingBreaks) {
  drape::DrapeInput input = test::tube();
  input.settings.particle_distance = 0.06;  // little to look through
  const auto run = begun(input);
  run->advance(100, {});
  const std::string good = run->checkpoint(), hash = run->start_hash();
  ASSERT_TRUE(drape::decode_checkpoint(good, hash).ok());
  for (std::size_t n = 0; n < good.size(); ++n) {
    ASSERT_EQ(drape::decode_checkpoint(std::string_view(good).substr(0, n), hash).error().code,
              "checkpoint.damaged")
        << n << " bytes";
  }
  for (std::size_t n = 0; n < good.size(); ++n) {
    std::string bad = good;
    bad[n] = static_cast<char>(bad[n] ^ (1 << n % 8));
    ASSERT_EQ(drape::decode_checkpoint(bad, hash).error().code, "checkpoint.damaged") << "byte " << n;
  }
  EXPECT_EQ(drape::decode_checkpoint(good + "x", hash).error().code, "checkpoint.damaged");
  EXPECT_EQ(drape::decode_checkpoint("", hash).error().code, "checkpoint.damaged");
}

/// A seal that fits whatever stands before it, as only somebody who knows the format could put.
std::string sealed(std::string bytes) {
  bytes.resize(bytes.size() - 32);
  return bytes + hash_of(std::string_view(bytes));
}

TEST(Checkpoint, WithAForgedSealIsStillReadWithCare) {
  drape::DrapeInput input = test::tube();
  input.settings.particle_distance = 0.06;
  const auto run = begun(input);
  run->advance(100, {});
  const std::string good = run->checkpoint(), hash = run->start_hash();
  ASSERT_EQ(sealed(good), good);
  int refused = 0;
  for (std::size_t n = 0; n + 32 < good.size(); ++n) {
    std::string bad = good;
    bad[n] = static_cast<char>(bad[n] ^ 0xff);
    refused += !drape::decode_checkpoint(sealed(bad), hash).ok();
    if (n % 16 != 0) continue;
    EXPECT_FALSE(drape::decode_checkpoint(sealed(good.substr(0, n + 32)), hash).ok()) << n << " bytes";
  }
  EXPECT_GT(refused, 80) << "the header and all counts at least";

  std::string newer = good;
  newer[8] = static_cast<char>(drape::kCheckpointVersion + 1);
  EXPECT_EQ(drape::decode_checkpoint(sealed(newer), hash).error().code, "checkpoint.version");
}

TEST(Checkpoint, ThatDoesNotFitTheGarmentIsRefused) {
  const drape::DrapeInput input = test::tube();
  const auto run = begun(input);
  run->advance(50, {});
  const std::string hash = run->start_hash();
  const auto code = [&](const std::function<void(drape::RunState&)>& change) {
    drape::RunState state = drape::decode_checkpoint(run->checkpoint(), hash).value();
    change(state);
    const auto on = drape::DrapeRun::resume(input, drape::encode_checkpoint(hash, state), {}, nullptr);
    return on ? "" : on.error().code;
  };
  EXPECT_EQ(code([](drape::RunState&) {}), "");
  const std::string damaged = "checkpoint.damaged";
  EXPECT_EQ(code([](drape::RunState& s) { s.session.joined.pop_back(); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.joined.flip(); }), damaged)
      << "other numbers of vertices";
  EXPECT_EQ(code([](drape::RunState& s) { s.session.released.clear(); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.solver.velocities.pop_back(); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.solver.contacts.centre.pop_back(); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.solver.stopped.clear(); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.solver.steps_near.at(0) = -1; }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.solver.positions[3].y = std::nan(""); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.solver.velocities[0].x = 1e300; }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.watch.window_start.clear(); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.watch.rms.assign(5, 0.0); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.phase = drape::DrapePhase::kDone; }), damaged)
      << "without a reason";
  EXPECT_EQ(code([](drape::RunState& s) { s.session.phase = static_cast<drape::DrapePhase>(7); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.session.steps = -1; }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.recorded = -2; }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.recorded = std::numeric_limits<int>::max(); }), damaged);
  EXPECT_EQ(code([](drape::RunState& s) { s.cpu_s = std::numeric_limits<double>::infinity(); }), damaged);
}

TEST(Checkpoint, WithContactsThatCannotBeIsRefused) {
  const drape::DrapeInput input = test::tablecloth();
  const auto run = cloth_in_contact(input);
  const std::string hash = run->start_hash();
  const auto code = [&](const std::function<void(collision::Contacts&)>& change) {
    drape::RunState state = drape::decode_checkpoint(run->checkpoint(), hash).value();
    change(state.session.solver.contacts);
    const auto on = drape::decode_checkpoint(drape::encode_checkpoint(hash, state), hash);
    return on ? "" : on.error().code;
  };
  EXPECT_EQ(code([](collision::Contacts&) {}), "");
  const std::string damaged = "checkpoint.damaged";
  EXPECT_EQ(code([](collision::Contacts& c) { c.pairs.clear(); }), damaged) << "contacts of no pair";
  EXPECT_EQ(code([](collision::Contacts& c) { c.pairs.at(0).v[0] = 1 << 20; }), damaged);
  EXPECT_EQ(code([](collision::Contacts& c) { c.pairs.at(0).v[0] = kNone; }), damaged);
  EXPECT_EQ(code([](collision::Contacts& c) { c.rims.at(0).contact.v[0] = -5; }), damaged);
  EXPECT_EQ(code([](collision::Contacts& c) { c.rims.at(0).contact.count = 5; }), damaged);
  EXPECT_EQ(code([](collision::Contacts& c) { c.rims.at(0).contact.n.x = std::nan(""); }), damaged);
  EXPECT_EQ(code([](collision::Contacts& c) { c.trust_radius.at(0) = -1; }), damaged);
  EXPECT_EQ(code([](collision::Contacts& c) { c.free_squared.pop_back(); }), damaged);
}

}  // namespace
}  // namespace toile
