#include "server/movie/film_codec.h"

#include <gtest/gtest.h>

#include "core/base/hash.h"
#include "tests/server/movie/napkin_film.h"

namespace toile {
namespace {

TEST(FilmCodec, GivesBackTheFilm) {
  const movie::Film film = test::napkin_film();
  const movie::Film read = movie::decode_film(movie::encode_film(film)).value();
  EXPECT_EQ(read.garment.triangles, film.garment.triangles);
  EXPECT_EQ(read.garment.weld, film.garment.weld);
  EXPECT_EQ(read.garment.panel_of_triangle, film.garment.panel_of_triangle);
  EXPECT_EQ(read.pieces.at(0).id, "napkin");
  EXPECT_EQ(hash_of(read.end), hash_of(film.end)) << "the end is kept exactly";
  ASSERT_EQ(read.bodies.size(), 1u);
  EXPECT_EQ(read.bodies[0].triangles, film.bodies[0].triangles);
  ASSERT_EQ(read.motion.frames.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(read.motion.frames[i].grid, film.motion.frames[i].grid);
    EXPECT_EQ(read.motion.frames[i].step, film.motion.frames[i].step);
  }
  EXPECT_EQ(movie::encode_film(read), movie::encode_film(film));
}

/// Its body rises by 10 cm within the film's second half.
movie::Film with_a_body_that_moves() {
  movie::Film film = test::napkin_film();
  movie::BodyWay way{0, film.bodies[0].vertices, {}};
  for (Vec3& p : film.bodies[0].vertices) p.y += 0.1;
  way.keyframes.push_back({2, film.bodies[0].vertices});
  film.ways.push_back(std::move(way));
  for (std::size_t i = 5; i < film.motion.frames.size(); ++i)
    film.motion.frames[i].bodies = static_cast<float>(i - 4) * 0.4F;
  return film;
}

TEST(FilmCodec, KeepsHowABodyMoved) {
  const movie::Film film = with_a_body_that_moves();
  const std::string bytes = movie::encode_film(film);
  const movie::Film read = movie::decode_film(bytes).value();
  EXPECT_EQ(movie::encode_film(read), bytes);
  const auto height = [&](double time) {
    const double played = movie::played_at(read.motion, time);
    return movie::bodies_at(read, played)[0].vertices[0].y - film.ways[0].start[0].y;
  };
  const auto time_of = [&](std::size_t frame) { return static_cast<double>(read.motion.frames[frame].time); };
  EXPECT_NEAR(height(time_of(4)), 0, 1e-6);
  EXPECT_NEAR(height(0.5 * (time_of(4) + time_of(5))), 0.01, 1e-6);
  EXPECT_NEAR(height(time_of(9)), 0.1, 1e-6);
  EXPECT_EQ(movie::decode_motion(movie::encode_motion(film.motion)).value().frames[9].bodies, 2.0F);
}

TEST(FilmCodec, RefusesAMotionOfAnotherBody) {
  const auto refused = [](auto spoil) {
    movie::Film film = with_a_body_that_moves();
    spoil(film.ways[0]);
    EXPECT_EQ(movie::decode_film(movie::encode_film(film)).error().code, "film.damaged");
  };
  refused([](movie::BodyWay& way) { way.body = 1; });
  refused([](movie::BodyWay& way) { way.start.pop_back(); });
  refused([](movie::BodyWay& way) { way.keyframes[0].vertices.pop_back(); });
  refused([](movie::BodyWay& way) { way.keyframes[0].at = 0; });
  refused([](movie::BodyWay& way) { way.keyframes.clear(); });
}

TEST(FilmCodec, RefusesWhatIsCutOffOrChanged) {
  const std::string bytes = movie::encode_film(test::napkin_film());
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    EXPECT_EQ(movie::decode_film(bytes.substr(0, size)).error().code, "film.damaged") << size;
  }
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x21);
    EXPECT_FALSE(movie::decode_film(changed)) << at;
  }
}

TEST(FilmCodec, RefusesATriangleOfABodyWithoutItsVertex) {
  movie::Film film = test::napkin_film();
  film.bodies[0].triangles[0] = {0, 1, 4};
  EXPECT_EQ(movie::decode_film(movie::encode_film(film)).error().code, "film.damaged");
}

TEST(FilmCodec, RefusesAFrameOfAnotherCloth) {
  movie::Film film = test::napkin_film(1);
  film.motion.frames[0].grid.resize(9);
  EXPECT_EQ(movie::decode_film(movie::encode_film(film)).error().code, "film.damaged");
}

}  // namespace
}  // namespace toile
