#include "core/base/crew.h"

#include <pthread.h>

#include <ctime>
#include <utility>

#include "core/base/check.h"

namespace toile {

namespace {

// A ticket: the work's number above, its parts, and those that are taken.
constexpr int kPartBits = 20;
constexpr std::uint64_t kPartMask = (std::uint64_t{1} << kPartBits) - 1;

std::uint64_t taken_of(std::uint64_t ticket) { return ticket & kPartMask; }
std::uint64_t count_of(std::uint64_t ticket) { return ticket >> kPartBits & kPartMask; }
std::uint64_t number_of(std::uint64_t ticket) { return ticket >> 2 * kPartBits; }

/// How often a helper looks for work before it sleeps: some tens of microseconds, about as long as the work
/// between two pieces takes. Waking one costs as much.
constexpr int kLooks = 4000;

void breathe() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

Crew::Crew(int threads) {
  helpers_.reserve(static_cast<std::size_t>(std::max(0, threads - 1)));
  try {
    for (int i = 1; i < threads; ++i) helpers_.emplace_back([this] { help(); });
  } catch (const std::exception&) {
    // The system has no thread or memory left to give: those that there are do the same work.
  }
}

Crew::~Crew() {
  over_.store(true);
  ticket_.store((number_of(ticket_.load()) + 1) << 2 * kPartBits);  // wakes those that sleep
  ticket_.notify_all();
}

double Crew::helpers_cpu_s() {
  double sum = 0;
  for (std::jthread& helper : helpers_) {
    clockid_t clock{};
    timespec t{};
    if (pthread_getcpuclockid(helper.native_handle(), &clock) != 0) continue;
    clock_gettime(clock, &t);
    sum += static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
  return sum;
}

/// Takes a part of what is given out, and does it. False where none is left.
bool Crew::take_part() {
  std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
  do {
    if (taken_of(ticket) >= count_of(ticket)) return false;
  } while (!ticket_.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel));
  try {
    call_(work_, static_cast<int>(taken_of(ticket)));
  } catch (...) {  // thrown on in give_out
    const std::lock_guard lock(thrown_mutex_);
    if (!thrown_) thrown_ = std::current_exception();
  }
  done_.fetch_add(1, std::memory_order_release);
  return true;
}

void Crew::give_out(int count, const void* work, Call call) {
  TOILE_CHECK(static_cast<std::uint64_t>(count) <= kPartMask);
  work_ = work;
  call_ = call;
  done_.store(0, std::memory_order_relaxed);
  const std::uint64_t number = number_of(ticket_.load(std::memory_order_relaxed)) + 1;
  ticket_.store(number << 2 * kPartBits | static_cast<std::uint64_t>(count) << kPartBits,
                std::memory_order_release);
  ticket_.notify_all();
  while (take_part()) {
  }
  for (int looks = 0; done_.load(std::memory_order_acquire) < count; ++looks) {
    if (looks < kLooks) {
      breathe();
    } else {
      std::this_thread::yield();  // whoever holds the last part may wait for this very processor
    }
  }
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Crew::help() {
  int looks = 0;
  while (!over_.load(std::memory_order_relaxed)) {
    if (take_part()) {
      looks = 0;
      continue;
    }
    if (++looks < kLooks) {
      breathe();
      continue;
    }
    const std::uint64_t seen = ticket_.load(std::memory_order_acquire);
    if (taken_of(seen) >= count_of(seen) && !over_.load()) ticket_.wait(seen);
    looks = 0;
  }
}

}  // namespace toile
