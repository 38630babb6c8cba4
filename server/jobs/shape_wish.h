#pragma once
// How the garment of a drape under way hangs, for whoever wants to go on from it: asked of the worker that
// has the drape, which answers between two slices.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>

namespace toile::jobs {

/// Thread-safe; several may ask at once and are given the same.
class ShapeWish {
 public:
  /// Waits for an answer (warm::encode_hung; empty: the garment does not hang yet). Nothing where none came
  /// in time.
  std::optional<std::string> ask(std::chrono::milliseconds within);

  bool is_asked();
  void answer(std::string shape);

 private:
  std::mutex mutex_;
  std::condition_variable answered_;
  int asking_ = 0;
  std::optional<std::string> shape_;  ///< until all who asked have it
};

}  // namespace toile::jobs
