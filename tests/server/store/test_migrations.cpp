#include "server/store/sqlite/migrations.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/server/store/store_folder.h"

namespace toile {
namespace {

sqlite::SqlDatabase database_in(const TemporaryFolder& folder) {
  Result<sqlite::SqlDatabase> database = sqlite::SqlDatabase::open(folder.path() + "/toile.db");
  EXPECT_TRUE(database);
  return std::move(*database);
}

std::int64_t number(sqlite::SqlDatabase& database, const char* sql) {
  Result<sqlite::SqlStatement> statement = database.prepare(sql);
  if (!statement || !statement->step()) return -1;
  return statement->integer(0);
}

TEST(Migrations, TakeAnEmptyDatabaseToThePresentSchemaOnce) {
  const TemporaryFolder folder;
  sqlite::SqlDatabase database = database_in(folder);
  ASSERT_TRUE(sqlite::migrate(database));
  ASSERT_TRUE(sqlite::migrate(database)) << "a second time changes nothing";
  EXPECT_EQ(number(database, "SELECT count(*) FROM schema_migrations"),
            static_cast<std::int64_t>(sqlite::migrations().size()));
  EXPECT_EQ(number(database, "SELECT count(*) FROM jobs"), 0);
}

TEST(Migrations, AreNumberedWithoutGaps) {
  int expected = 1;
  for (const sqlite::Migration& step : sqlite::migrations()) EXPECT_EQ(step.number, expected++);
}

TEST(Migrations, RefuseADatabaseThatANewerProgramHasWritten) {
  const TemporaryFolder folder;
  opened(folder.path());
  {
    sqlite::SqlDatabase database = database_in(folder);
    ASSERT_TRUE(database.run("INSERT INTO schema_migrations (number, name) VALUES (1000, 'from tomorrow')"));
  }
  const Result<std::unique_ptr<store::Store>> store = sqlite::open_sqlite_store(folder.path());
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().code, "store.newer_schema");
  EXPECT_NE(store.error().message.find("1000"), std::string::npos) << store.error().message;
  EXPECT_NE(store.error().where.find("toile.db"), std::string::npos);
}

TEST(Migrations, GoOnFromWhereAnOlderProgramStopped) {
  const TemporaryFolder folder;
  sqlite::SqlDatabase database = database_in(folder);
  const std::array<sqlite::Migration, 2> steps{{
      {1, "things", "CREATE TABLE things (a INTEGER); INSERT INTO things VALUES (7)"},
      {2, "more", "ALTER TABLE things ADD COLUMN b INTEGER NOT NULL DEFAULT 5"},
  }};
  ASSERT_TRUE(sqlite::migrate(database, std::span(steps).first(1)));
  ASSERT_TRUE(sqlite::migrate(database, steps));
  EXPECT_EQ(number(database, "SELECT a + b FROM things"), 12);
}

TEST(Migrations, LeaveNothingOfAStepThatFails) {
  const TemporaryFolder folder;
  sqlite::SqlDatabase database = database_in(folder);
  const std::array<sqlite::Migration, 2> steps{{
      {1, "good", "CREATE TABLE things (a INTEGER)"},
      {2, "bad", "CREATE TABLE half (a INTEGER); INSERT INTO nowhere VALUES (1)"},
  }};
  EXPECT_FALSE(sqlite::migrate(database, steps));
  EXPECT_EQ(number(database, "SELECT max(number) FROM schema_migrations"), 1);
  EXPECT_EQ(number(database, "SELECT count(*) FROM sqlite_schema WHERE name = 'half'"), 0);
  const std::array<sqlite::Migration, 2> mended{{steps[0], {2, "mended", "CREATE TABLE half (a INTEGER)"}}};
  EXPECT_TRUE(sqlite::migrate(database, mended));
}

}  // namespace
}  // namespace toile
