#include "server/app/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace toile::app {
namespace {

constexpr int kCells = 30;
constexpr auto kPause = std::chrono::milliseconds(100);  // between two drawings of one phase

}  // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1), start_(Clock::now()) {}

void ProgressBar::show(const Progress& progress) {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (progress.phase == phase_ && now - drawn_ < kPause) return;
  drawn_ = now;
  phase_ = progress.phase;
  const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
  const int filled = static_cast<int>(fraction * kCells);
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - start_).count();
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(kCells - filled), '.');
  std::fprintf(stderr, "\r\x1b[K%-8s [%s] %3d%%  %lld:%02lld", phase_.c_str(), bar.c_str(),
               static_cast<int>(fraction * 100), static_cast<long long>(seconds / 60),
               static_cast<long long>(seconds % 60));
  std::fflush(stderr);
  visible_ = true;
}

void ProgressBar::clear() {
  if (!visible_) return;
  std::fprintf(stderr, "\r\x1b[K");
  std::fflush(stderr);
  visible_ = false;
}

}  // namespace toile::app
