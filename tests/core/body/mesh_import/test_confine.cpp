#include "core/body/mesh_import/confine.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <vector>

namespace toile {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kFilters = false;
#else
constexpr bool kFilters = true;
#endif

/// What `deed` gives in a process that is confined.
int confined(const std::function<int()>& deed) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    mesh_import::confine();
    ::_exit(deed());
  }
  int status = 0;
  ::waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(Confine, LeavesMemoryAndTheFilesThatAreOpen) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  EXPECT_EQ(confined([&] {
              std::vector<char> much(std::size_t{64} << 20, 'x');
              return ::write(ends[1], much.data(), 3) == 3 ? 7 : 1;
            }),
            7);
  char bytes[3];
  EXPECT_EQ(::read(ends[0], bytes, sizeof bytes), 3);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(Confine, OpensNothing) {
  EXPECT_EQ(confined([] { return ::open("/etc/passwd", O_RDONLY) < 0 ? 7 : 1; }), 7);
}

TEST(Confine, StartsNoProcessAndReachesNoNetworkAlsoWhereItWasRoot) {
  if (!kFilters) GTEST_SKIP() << "sanitizers need what is forbidden here: NOT tried";
  EXPECT_EQ(confined([] { return ::fork() < 0 ? 7 : 1; }), 7);
  EXPECT_EQ(confined([] { return ::socket(AF_INET, SOCK_STREAM, 0) < 0 ? 7 : 1; }), 7);
  EXPECT_EQ(confined([] { return ::kill(::getppid(), 0) < 0 ? 7 : 1; }), 7);
}

}  // namespace
}  // namespace toile
