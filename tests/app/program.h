#pragma once
// Runs the real program as a user's shell would.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace toile {

/// What came of a run of the program.
struct Ran {
  int code = -1;   ///< exit code; -1 when it did not end by itself
  int signal = 0;  ///< that ended it: a crash, or SIGKILL after the time allowed
  std::string out, err;
};

/// Runs build/…/toile with `arguments` and waits at most `allowed_s`: long enough on a machine that is busy,
/// so that only what hangs is ended. It is sent SIGINT once it has said that it catches it and
/// `interrupt_once`, when given, holds.
Ran run_toile(const std::vector<std::string>& arguments, double allowed_s = 300,
              const std::function<bool()>& interrupt_once = {});

/// An empty folder of that name for one test.
std::filesystem::path fresh_folder(const std::string& name);

std::string text_of(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace toile
