#pragma once
// Threads that do the parts of one piece of work side by side. What is given out in parts must come out the
// same whoever does which, and when: parts touch nothing in common, and what they find is put together in
// their order afterwards. So the number of threads changes no byte.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace toile {

class Crew {
 public:
  /// So many threads in all, the caller's among them; 1 starts none, and where the system gives fewer there
  /// are fewer. Pieces of work may be as short as some microseconds: helpers look out for the next for a
  /// moment before they sleep.
  explicit Crew(int threads = 1);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  int threads() const { return static_cast<int>(helpers_.size()) + 1; }
  /// Into how many parts work is taken whose parts are unlike: one who works alone takes it whole.
  std::size_t parts() const {
    return helpers_.empty() ? 1 : kPartsEach * static_cast<std::size_t>(threads());
  }
  /// s of processor time that the helpers have taken so far, idle looks included.
  double helpers_cpu_s();

  /// Calls part(i) for each i in [0, count) and returns when all have returned. What a part throws, be it for
  /// want of memory, is thrown here once no other is under way; which parts were done then is not known.
  /// Parts give out no work to the same crew. REQUIRES count < 2²⁰. One thread calls at a time.
  template <typename Part>
  void each(int count, const Part& part) {
    if (helpers_.empty() || count <= 1) {
      for (int i = 0; i < count; ++i) part(i);
      return;
    }
    give_out(count, &part, [](const void* work, int i) { (*static_cast<const Part*>(work))(i); });
  }

  /// Calls part(begin, end) for pieces of [0, count) of at least `least` items, as many as there are threads
  /// to take them. Where the pieces begin depends on the number of threads: items must not care.
  template <typename Part>
  void ranges(std::size_t count, std::size_t least, const Part& part) {
    const auto most = static_cast<std::size_t>(threads()) * kRangesEach;
    const std::size_t pieces = helpers_.empty() ? 1 : std::clamp<std::size_t>(count / least, 1, most);
    each(static_cast<int>(pieces), [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      part(count * k / pieces, count * (k + 1) / pieces);
    });
  }

 private:
  using Call = void (*)(const void* work, int part);
  static constexpr std::size_t kPartsEach = 4, kRangesEach = 2;  ///< so that who is held up takes fewer

  void give_out(int count, const void* work, Call call);
  void help();
  bool take_part();

  // What is given out, in one word, so that a late helper can never mistake one piece of work for another:
  // its number, how many parts it has, and how many of those are taken.
  std::atomic<std::uint64_t> ticket_{0};
  std::atomic<int> done_{0};  ///< parts
  std::atomic<bool> over_{false};
  const void* work_ = nullptr;  ///< read only by who holds a part of it
  Call call_ = nullptr;
  std::mutex thrown_mutex_;
  std::exception_ptr thrown_;  ///< the first of this work
  std::vector<std::jthread> helpers_;
};

}  // namespace toile
