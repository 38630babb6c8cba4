// What is left when the process dies or the disk is full, in processes of their own.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "server/store/sqlite/database.h"
#include "tests/server/store/store_folder.h"
#include "tests/server/store/update_job.h"

namespace toile {
namespace {

constexpr std::size_t kIdSize = 22;

/// Writes projects, jobs, files and results for ever, and each job's id to `out` once all of it is
/// acknowledged.
[[noreturn]] void write_for_ever(const std::string& folder, int out) {
  const auto store = opened(folder);
  for (int i = 0;; ++i) {
    const std::string bytes(static_cast<std::size_t>(1000 + i), static_cast<char>('a' + i % 26));
    const Result<store::AssetRow> asset = store->put_asset(kMe, named("dxf", "a.dxf"), bytes);
    store::JobRow job = some_job("drape");
    if (asset) job.files = {{"a.dxf", asset->id}};
    auto made = store->create_job(kMe, job, "key-" + std::to_string(i) + "-" + bytes[0]);
    if (!asset || !made || !store->put_result(kMe, made->id, "report.json", made->id)) _exit(1);
    made->results = {{"report.json", kIdSize}};  // what no row names goes at the next start
    if (!test::update_job(*store, kMe, *made)) _exit(3);
    if (::write(out, made->id.data(), kIdSize) != static_cast<ssize_t>(kIdSize)) _exit(2);
  }
}

/// The ids that a writer acknowledged before it was killed, after it had acknowledged at least `least`.
std::vector<std::string> acknowledged_until_killed(const std::string& folder, std::size_t least,
                                                   void (*write)(const std::string& folder, int out)) {
  std::array<int, 2> ends;
  if (::pipe(ends.data()) != 0) return {};
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    write(folder, ends[1]);
  }
  ::close(ends[1]);
  std::vector<std::string> ids;
  std::string id(kIdSize, ' ');
  while (::read(ends[0], id.data(), kIdSize) == static_cast<ssize_t>(kIdSize)) {
    ids.push_back(id);
    if (ids.size() == least) ::kill(child, SIGKILL);  // and read on: more may be in the pipe
  }
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
  return ids;
}

std::string integrity_of(const std::string& folder) {
  Result<sqlite::SqlDatabase> database = sqlite::SqlDatabase::open(folder + "/toile.db");
  if (!database) return to_string(database.error());
  Result<sqlite::SqlStatement> check = database->prepare("PRAGMA integrity_check");
  if (!check || !check->step()) return "cannot be checked";
  return check->text(0);
}

TEST(StoreCrash, LosesNothingThatWasAcknowledgedBeforeAKill) {
  const TemporaryFolder folder;
  std::vector<std::string> ids;
  for (std::size_t round = 0; round < 6; ++round) {
    const std::vector<std::string> more =
        acknowledged_until_killed(folder.path(), 3 + 4 * round, write_for_ever);
    ASSERT_GE(more.size(), 3 + 4 * round);
    ids.insert(ids.end(), more.begin(), more.end());
    const auto store = opened(folder.path());
    for (const std::string& id : ids) {
      const Result<store::JobRow> job = store->job(kMe, id);
      ASSERT_TRUE(job) << to_string(job.error());
      const Result<std::string> bytes = store->asset_bytes(kMe, job->files.at("a.dxf"));
      ASSERT_TRUE(bytes) << to_string(bytes.error());
      const Result<std::string> result = store->result_bytes(kMe, id, "report.json");
      ASSERT_TRUE(result) << to_string(result.error());
      EXPECT_EQ(*result, id);
    }
    EXPECT_EQ(integrity_of(folder.path()), "ok");
  }
}

/// The same from eight threads, whose jobs the store takes on together; jobs alone.
[[noreturn]] void submit_for_ever(const std::string& folder, int out) {
  const auto store = opened(folder);
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < 8; ++thread) {
    threads.emplace_back([&, thread] {
      for (int i = 0;; ++i) {
        const std::string key =
            std::to_string(::getpid()) + "-" + std::to_string(thread) + "-" + std::to_string(i);
        const auto made = store->create_job(kMe, some_job(key), key);
        if (!made || !made->anew) _exit(1);
        if (::write(out, made->id.data(), kIdSize) != static_cast<ssize_t>(kIdSize)) _exit(2);
      }
    });
  }
  threads.clear();
  _exit(3);
}

TEST(StoreCrash, LosesNothingOfWhatManySubmitAtOnce) {
  const TemporaryFolder folder;
  std::vector<std::string> ids;
  for (std::size_t round = 0; round < 6; ++round) {
    const std::size_t least = 20 + 7 * round;
    const std::vector<std::string> more = acknowledged_until_killed(folder.path(), least, submit_for_ever);
    ASSERT_GE(more.size(), least);
    ids.insert(ids.end(), more.begin(), more.end());
    const auto store = opened(folder.path());
    for (const std::string& id : ids) {
      const Result<store::JobRow> job = store->job(kMe, id);
      ASSERT_TRUE(job) << to_string(job.error());
      const auto of_key = store->job_of_key(kMe, job->name);  // which is its key
      ASSERT_TRUE(of_key && *of_key);
      EXPECT_EQ((*of_key)->id, id);
    }
    EXPECT_EQ(integrity_of(folder.path()), "ok");
  }
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
}

/// Bytes.
std::uintmax_t largest_file(const std::string& folder) {
  std::uintmax_t most = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) most = std::max(most, entry.file_size());
  return most;
}

/// Which expectation of the full disk did not hold, 0 for none. Runs in a child, since the limit is the
/// process's.
int full_disk_story(const std::string& folder) {
  ::signal(SIGXFSZ, SIG_IGN);
  const auto store = opened(folder);
  const auto early = store->create_project(kMe, some_project("early"));
  const Result<store::AssetRow> asset = store->put_asset(kMe, named("dxf", "a.dxf"), "content");
  const auto job = store->create_job(kMe, some_job("early"), "");
  if (!early || !asset || !job) return 1;
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  // Room for a small write, which ping makes, and none for what is large, however much an empty store has.
  const rlimit small{.rlim_cur = largest_file(folder) + (128 << 10), .rlim_max = limit.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);

  const std::string large(1 << 20, 'x');
  store::ProjectRow big = some_project("big");
  big.document = large;
  if (code_of(store->create_project(kMe, big)) != "store.full") return 2;
  big.id = early->id;
  if (code_of(store->replace_project(kMe, big, 1)) != "store.full") return 3;
  store::JobRow big_job = some_job("big");
  big_job.document = large;
  if (code_of(store->create_job(kMe, big_job, "key")) != "store.full") return 4;
  if (code_of(store->put_asset(kMe, named("body", "b.obj"), large)) != "store.full") return 5;
  if (code_of(store->put_result(kMe, job->id, "big.glb", large)) != "store.full") return 6;

  if (!store->ping() || store->projects(kMe, "", 10)->size() != 1) return 7;
  const Result<store::ProjectRow> still = store->project(kMe, early->id);
  if (!still || still->revision != 1) return 8;
  const Result<std::string> bytes = store->asset_bytes(kMe, asset->id);
  if (!bytes || *bytes != "content") return 9;
  if (code_of(store->result_bytes(kMe, job->id, "big.glb")) != "store.not_found") return 10;
  if (!std::filesystem::is_empty(store->scratch_folder())) return 11;

  ::setrlimit(RLIMIT_FSIZE, &limit);
  if (!store->create_project(kMe, big)) return 12;
  if (!store->create_job(kMe, big_job, "key")) return 13;
  if (!store->put_asset(kMe, named("body", "b.obj"), large)) return 14;
  return 0;
}

TEST(StoreCrash, SaysThatTheDiskIsFullReadsOnAndRecovers) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) _exit(full_disk_story(folder.path()));
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 0) << "the number of the expectation that did not hold";
  EXPECT_EQ(integrity_of(folder.path()), "ok");
  EXPECT_EQ(opened(folder.path())->projects(kMe, "", 10)->size(), 2u);
}

}  // namespace
}  // namespace toile
