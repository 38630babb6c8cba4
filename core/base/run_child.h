#pragma once
// Another program, run for its output and kept on a short leash: limits on memory, processor time, time by
// the clock and output, no files of ours but the one it is given, and it never outlives the call.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace toile {

struct ChildLimits {
  std::uint64_t memory_bytes = 0;  ///< of address space; 0: no limit
  double cpu_s = 20;               ///< of processor time
  double wall_s = 40;              ///< by the clock
  std::size_t output_bytes = std::size_t{1} << 20;
  std::uint64_t file_bytes = 0;  ///< of each file that it writes; 0: it can write none
};

struct ChildCommand {
  std::string program;  ///< path
  std::vector<std::string> arguments;
  int input = -1;  ///< open file that becomes its standard input; stays the caller's. -1: nothing to read
};

struct ChildOutcome {
  enum class End { kExited, kKilledBySignal, kTookTooLong, kWroteTooMuch, kCancelled, kNotStarted };
  End end = End::kNotStarted;
  int code = 0;        ///< exit code, signal, or errno of what kept it from starting
  std::string output;  ///< of its standard output; standard error is dropped
};

/// Where a program of that name is, by PATH as a shell looks; empty when there is none.
std::string find_program(const std::string& name);

/// Runs the program and waits for its end. It gets an empty environment (but LD_LIBRARY_PATH), "/" as its
/// folder, can write no file unless the limits allow it, and is killed with all that it has started once a
/// limit is passed, this thread ends, or `cancel` (which may be null) becomes true. Safe in a process with
/// many threads. Linux.
ChildOutcome run_child(const ChildCommand& command, const ChildLimits& limits,
                       const std::atomic<bool>* cancel = nullptr);

}  // namespace toile
