#include <gtest/gtest.h>

#include "server/movie/film_codec.h"
#include "tests/server/movie/napkin_film.h"

namespace toile {
namespace {

constexpr movie::MotionLimits kTwenty{.frames = 20};

movie::FilmRecorder recorded(int frames, movie::MotionLimits limits = kTwenty) {
  movie::FilmRecorder recorder(limits);
  recorder.begin(test::square());
  for (int i = 0; i < frames; ++i) recorder.frame(test::sunk(50 * i));
  return recorder;
}

TEST(FilmRecorder, KeepsTheFirstAndTheLastFrameOfADrapeOfAnyLengthWithinItsLimits) {
  for (const int frames : {1, 2, 19, 20, 21, 22, 137, 1000}) {
    const movie::Motion motion = recorded(frames).motion();
    EXPECT_LE(motion.frames.size(), 20u) << frames;
    EXPECT_GE(motion.frames.size(), static_cast<std::size_t>(std::min(frames, 10))) << frames;
    EXPECT_EQ(motion.frames.front().step, 0);
    EXPECT_EQ(motion.frames.back().step, 50 * (frames - 1));
  }
}

TEST(FilmRecorder, TakesNoMoreMemoryThanItMay) {
  const std::size_t frame = 4 * 3 * sizeof(std::int16_t);
  const movie::Motion motion =
      recorded(500, {.frames = 400, .bytes = 30 * frame, .least_frames = 4}).motion();
  EXPECT_LE(motion.frames.size(), 30u);
  EXPECT_GE(motion.frames.size(), 15u);
}

TEST(FilmRecorder, OfADrapeThatWasBrokenOffLeavesTheFilmThatItWouldHaveLeft) {
  const std::string whole = movie::encode_motion(recorded(333).motion());
  for (const int broken_off : {1, 20, 21, 150, 332}) {
    const std::string kept = movie::encode_motion(recorded(broken_off).motion());
    movie::FilmRecorder second(kTwenty, movie::decode_motion(kept).value());
    second.begin(test::square());
    for (int i = broken_off; i < 333; ++i) second.frame(test::sunk(50 * i));
    EXPECT_EQ(movie::encode_motion(second.motion()), whole) << broken_off;
  }
}

TEST(FilmRecorder, ForgetsWhatADrapeThatBeginsAnewDoesAnotherTime) {
  movie::FilmRecorder recorder = recorded(15);
  for (int i = 0; i < 5; ++i) recorder.frame(test::sunk(50 * i));
  EXPECT_EQ(recorder.motion().frames.size(), 5u);
}

}  // namespace
}  // namespace toile
