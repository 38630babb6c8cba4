#include "server/jobs/render_worker.h"

#include <gtest/gtest.h>

#include <latch>
#include <stdexcept>

namespace toile {
namespace {

bool never() { return false; }

TEST(RenderWorker, RunsAllDrawingsOnOneThreadThatIsNotTheCallers) {
  jobs::RenderWorker worker;
  std::thread::id seen[2];
  for (std::thread::id& id : seen) {
    EXPECT_TRUE(worker
                    .draw([&id](render::Stills&,
                                const RunContext&) { return id = std::this_thread::get_id(), Status(); },
                          never)
                    .ok());
  }
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_NE(seen[0], std::this_thread::get_id());
}

TEST(RenderWorker, GivesBackWhatTheDrawingGives) {
  jobs::RenderWorker worker;
  const Status status = worker.draw(
      [](render::Stills&, const RunContext&) {
        return Status(Error{"render.failed", "no paint", ""});
      },
      never);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "render.failed");
}

TEST(RenderWorker, ThrowsAtTheCallerWhatTheDrawingThrowsAndDrawsOn) {
  jobs::RenderWorker worker;
  EXPECT_THROW(
      static_cast<void>(
          worker
              .draw([](render::Stills&, const RunContext&) -> Status { throw std::runtime_error("torn"); },
                    never)
              .ok()),
      std::runtime_error);
  EXPECT_TRUE(worker.draw([](render::Stills&, const RunContext&) { return Status(); }, never).ok());
}

TEST(RenderWorker, DoesNotWaitForADrawingThatIsGivenUp) {
  std::latch go(1);
  jobs::RenderWorker worker;
  const Status status = worker.draw(
      [&](render::Stills&, const RunContext&) {
        go.wait();
        return Status();
      },
      [] { return true; });
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "render.given_up");
  go.count_down();
}

TEST(RenderWorker, TellsADrawingThatItIsGivenUp) {
  std::latch begun(1), seen(1);
  jobs::RenderWorker worker;
  const Status status = worker.draw(
      [&](render::Stills&, const RunContext& context) {
        begun.count_down();
        while (!context.cancelled()) std::this_thread::yield();
        seen.count_down();
        return Status();
      },
      [&] { return begun.try_wait(); });
  EXPECT_EQ(status.error().code, "render.given_up");
  seen.wait();
}

/// Keeps the last line, and says that there is one.
class KeptLine final : public LogSink {
 public:
  void write(LogLevel, std::string_view event, std::span<const LogField> bound,
             std::span<const LogField> more) noexcept override {
    line = std::string(event);
    for (const auto fields : {bound, more})
      for (const LogField& field : fields) line += " " + field.key + "=" + field.value;
    written.count_down();
  }
  std::string line;
  std::latch written{1};
};

TEST(RenderWorker, TellsTheLogWhatADrawingThrowsThatWasGivenUp) {
  KeptLine kept;
  std::latch begun(1);
  jobs::RenderWorker worker;
  const Status status = worker.draw(
      [&](render::Stills&, const RunContext& context) -> Status {
        begun.count_down();
        while (!context.cancelled()) std::this_thread::yield();
        throw std::runtime_error("torn");
      },
      [&] { return begun.try_wait(); }, Log(kept).with("job", "j_1"));
  kept.written.wait();
  EXPECT_EQ(status.error().code, "render.given_up");
  EXPECT_EQ(kept.line, "a drawing that was given up threw job=j_1 what=torn");
}

TEST(RenderWorker, RefusesMoreThanItsQueueHolds) {
  std::latch go(1), begun(1);
  jobs::RenderWorker worker(1);
  std::jthread first([&] {
    EXPECT_TRUE(
        worker
            .draw([&](render::Stills&, const RunContext&) { return begun.count_down(), go.wait(), Status(); },
                  never)
            .ok());
  });
  begun.wait();
  EXPECT_EQ(worker.draw([](render::Stills&, const RunContext&) { return Status(); }, [] { return true; })
                .error()
                .code,
            "render.given_up")
      << "it stands in the queue still";
  const Status refused = worker.draw([](render::Stills&, const RunContext&) { return Status(); }, never);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "render.busy");
  go.count_down();
}

}  // namespace
}  // namespace toile
