#include "core/base/run_child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <utility>

namespace toile {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kCouldNotStart = 127;    // exit code of a child that never became the program
constexpr unsigned kMostFiles = 4096;  // closed one by one where the kernel cannot close a range

/// An open file that is closed when this goes.
class OpenFile {
 public:
  OpenFile() = default;
  explicit OpenFile(int fd) : fd_(fd) {}
  OpenFile(OpenFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~OpenFile() { close(); }
  void close() {
    if (fd_ >= 0) ::close(std::exchange(fd_, -1));
  }
  int get() const { return fd_; }

 private:
  int fd_ = -1;
};

/// All that the child needs between its birth and the program, made beforehand: there it shares our memory
/// and may neither allocate nor lock.
struct Launch {
  const char* program = nullptr;
  char* const* arguments = nullptr;
  char* const* environment = nullptr;
  int in = -1, out = -1, err = -1;  ///< all above 2
  pid_t parent = 0;
  ChildLimits limits;
};

void limit(int what, rlim_t soft, rlim_t hard) {
  const struct rlimit values { soft, hard };
  ::setrlimit(static_cast<__rlimit_resource_t>(what), &values);
}

#ifdef __SANITIZE_THREAD__
constexpr bool kCanLimitFiles = false;  // its runtime writes a file of its own as a program starts
#else
constexpr bool kCanLimitFiles = true;
#endif

/// To the millisecond by a timer, which outlives the start of the program and which it could set anew; and to
/// the second by what it cannot change.
void limit_time(double cpu_s) {
  const auto whole = static_cast<rlim_t>(std::ceil(cpu_s));
  limit(RLIMIT_CPU, whole, whole + 1);  // SIGXCPU, and SIGKILL for who ignores it
  const auto us = static_cast<long>(cpu_s * 1e6);
  const itimerval once{{0, 0}, {us / 1'000'000, us % 1'000'000}};
  ::setitimer(ITIMER_PROF, &once, nullptr);  // SIGPROF
}

[[noreturn]] void become(const Launch& launch) {
  ::setpgid(0, 0);  // so that what it starts can be killed with it
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != launch.parent) ::_exit(kCouldNotStart);
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
  limit(RLIMIT_CORE, 0, 0);
  const auto most = static_cast<rlim_t>(launch.limits.file_bytes);
  if (kCanLimitFiles || most > 0) limit(RLIMIT_FSIZE, most, most);  // pipes are no files
  limit_time(launch.limits.cpu_s);
  if (launch.limits.memory_bytes > 0) {
    limit(RLIMIT_AS, launch.limits.memory_bytes, launch.limits.memory_bytes);
  }
  if (::chdir("/") != 0 || ::dup2(launch.in, 0) < 0 || ::dup2(launch.out, 1) < 0 ||
      ::dup2(launch.err, 2) < 0) {
    ::_exit(kCouldNotStart);
  }
  if (::close_range(3, ~0U, 0) != 0) {
    for (unsigned fd = 3; fd < kMostFiles; ++fd) ::close(static_cast<int>(fd));
  }
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::execve(launch.program, launch.arguments, launch.environment);
  ::_exit(kCouldNotStart);
}

/// A copy of `fd` above the three that the child's own will be laid on.
OpenFile above_standard(int fd) { return OpenFile(fd < 0 ? -1 : ::fcntl(fd, F_DUPFD_CLOEXEC, 3)); }

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  out.reserve(texts.size() + 1);
  for (std::string& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

/// Starts the child with all signals held back: a handler of ours must not run in it while it shares our
/// memory. -1 with errno where that fails.
pid_t start(const Launch& launch) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  // posix_spawn sets no limits, and fork copies the page tables of a service that holds gigabytes. What the
  // child does before it becomes another program is made of system calls, and we stand still until then.
  const pid_t pid = ::vfork();   // NOLINT(clang-analyzer-security.insecureAPI.vfork)
  if (pid == 0) become(launch);  // NOLINT(clang-analyzer-unix.Vfork)
  const int reason = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = reason;
  return pid;
}

/// How long a child may go on: until a moment, and until somebody wants it no more.
struct Patience {
  Clock::time_point end;
  const std::atomic<bool>* cancel = nullptr;

  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
  bool over() const { return Clock::now() >= end || cancelled(); }
  int milliseconds() const {
    constexpr long long kAskEvery = 50;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    return static_cast<int>(std::clamp<long long>(left, 0, kAskEvery));
  }
  ChildOutcome::End reason() const {
    return cancelled() ? ChildOutcome::End::kCancelled : ChildOutcome::End::kTookTooLong;
  }
};

/// Reads until the child closes its output. kExited means that it did.
ChildOutcome::End read_all(int fd, const Patience& patience, std::size_t most, std::string& output) {
  constexpr std::size_t kChunk = std::size_t{1} << 16;
  for (;;) {
    pollfd waiting{fd, POLLIN, 0};
    if (::poll(&waiting, 1, patience.milliseconds()) < 0 && errno != EINTR) {
      return ChildOutcome::End::kTookTooLong;
    }
    if (waiting.revents == 0) {
      if (patience.over()) return patience.reason();
      continue;
    }
    const std::size_t had = output.size();
    output.resize(had + kChunk);
    const ssize_t got = ::read(fd, output.data() + had, kChunk);
    output.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return ChildOutcome::End::kExited;
    if (output.size() > most) return ChildOutcome::End::kWroteTooMuch;
  }
}

/// Whether the child ended by itself in time. It is not reaped yet, so that its number stays its own.
bool ended(pid_t pid, const Patience& patience) {
  for (long pause_us = 200;; pause_us = std::min(2 * pause_us, 20'000L)) {
    siginfo_t info{};
    const int done = ::waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT);
    if (done == 0 && info.si_pid == pid) return true;
    if ((done < 0 && errno != EINTR) || patience.over()) return false;
    const timespec pause{0, pause_us * 1000};
    ::nanosleep(&pause, nullptr);
  }
}

ChildOutcome not_started(int reason) { return {ChildOutcome::End::kNotStarted, reason, {}}; }

ChildOutcome wait_for(pid_t pid, int output, const ChildLimits& limits, const std::atomic<bool>* cancel) {
  const Patience patience{
      Clock::now() + std::chrono::microseconds(static_cast<long long>(limits.wall_s * 1e6)), cancel};
  ChildOutcome outcome;
  outcome.end = read_all(output, patience, limits.output_bytes, outcome.output);
  if (outcome.end == ChildOutcome::End::kExited && !ended(pid, patience)) outcome.end = patience.reason();
  ::kill(-pid, SIGKILL);  // and whatever it may have left behind
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (outcome.end != ChildOutcome::End::kExited) return outcome;
  if (WIFSIGNALED(status)) {
    outcome.code = WTERMSIG(status);
    const bool late = outcome.code == SIGXCPU || outcome.code == SIGPROF;
    outcome.end = late ? ChildOutcome::End::kTookTooLong : ChildOutcome::End::kKilledBySignal;
    return outcome;
  }
  outcome.code = WEXITSTATUS(status);
  if (outcome.code == kCouldNotStart) return not_started(ENOEXEC);
  return outcome;
}

}  // namespace

std::string find_program(const std::string& name) {
  const char* set = std::getenv("PATH");
  std::string_view folders = set ? set : "/usr/bin:/bin";
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    std::string path = std::string(folders.substr(0, end)) + "/" + name;
    if (path.front() == '/' && ::access(path.c_str(), X_OK) == 0) return path;
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  return "";
}

ChildOutcome run_child(const ChildCommand& command, const ChildLimits& limits,
                       const std::atomic<bool>* cancel) {
  const OpenFile nothing(::open("/dev/null", O_RDWR | O_CLOEXEC));
  int ends[2] = {-1, -1};
  if (nothing.get() < 0 || ::pipe2(ends, O_CLOEXEC) != 0) return not_started(errno);
  const OpenFile read_end(ends[0]);
  OpenFile write_end(ends[1]);
  OpenFile in = above_standard(command.input >= 0 ? command.input : nothing.get());
  OpenFile out = above_standard(write_end.get()), err = above_standard(nothing.get());
  write_end.close();
  if (in.get() < 0 || out.get() < 0 || err.get() < 0) return not_started(errno);

  std::vector<std::string> words{command.program}, variables{"LC_ALL=C"};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  if (const char* libraries = std::getenv("LD_LIBRARY_PATH")) {
    variables.push_back(std::string("LD_LIBRARY_PATH=") + libraries);
  }
  const std::vector<char*> arguments = pointers(words), environment = pointers(variables);
  const Launch launch{command.program.c_str(),
                      arguments.data(),
                      environment.data(),
                      in.get(),
                      out.get(),
                      err.get(),
                      ::getpid(),
                      limits};
  const pid_t pid = start(launch);
  if (pid < 0) return not_started(errno);
  out.close();  // else the end of the child's output would never come
  return wait_for(pid, read_end.get(), limits, cancel);
}

}  // namespace toile
