#pragma once
// The server under measurement: the real program, over a folder of its own.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/app/serving.h"

namespace toile::bench {

/// The time, s, from some moment on.
double now_s();

class House {
 public:
  /// `options` of `toile serve` beside its port, folder and empty store.
  explicit House(const std::vector<std::string>& options);
  /// With accounts, which are made first.
  House(const std::vector<std::string>& accounts, const std::vector<std::string>& options);
  ~House();
  House(const House&) = delete;

  std::string url() const { return server_->url(); }
  int port() const { return server_->port(); }
  /// Of accounts, in their order.
  const std::vector<std::string>& tokens() const { return tokens_; }

  double resident_mb() const;
  /// Processor time that the server and its ended children have had, s.
  double worked_s() const;

 private:
  void serve(std::vector<std::string> options);

  std::filesystem::path folder_;
  std::vector<std::string> tokens_;
  std::unique_ptr<Serving> server_;
};

}  // namespace toile::bench
