#pragma once
// Runs the real program as a user's shell would.

#include <filesystem>
#include <string>
#include <vector>

namespace toile {

/// What came of a run of the program.
struct Ran {
  int code = -1;   ///< exit code; -1 when it did not end by itself
  int signal = 0;  ///< that ended it: a crash, or SIGKILL after the time allowed
  double seconds = 0;
  std::string out, err;
};

/// Runs build/…/toile with `arguments` and waits at most `allowed_s`. With `interrupt_after_s` >= 0 it is
/// sent SIGINT at that time.
Ran run_toile(const std::vector<std::string>& arguments, double allowed_s = 60,
              double interrupt_after_s = -1);

/// An empty folder of that name for one test.
std::filesystem::path fresh_folder(const std::string& name);

std::string text_of(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace toile
