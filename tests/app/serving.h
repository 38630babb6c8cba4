#pragma once
// The real program as a server in a process of its own.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "server/http/client.h"

namespace toile {

class Serving {
 public:
  /// Starts `toile serve` over `data`, on a free port or one that is known to be, and waits until it prints
  /// its address.
  explicit Serving(const std::filesystem::path& data, const std::vector<std::string>& more = {},
                   int port = 0);
  ~Serving();  ///< kills it, if it still runs
  Serving(const Serving&) = delete;

  bool up() const { return port_ > 0; }
  int port() const { return port_; }
  pid_t pid() const { return pid_; }
  /// The server's processes that read meshes, now.
  std::vector<pid_t> readers() const;
  std::string url() const {
    return (roots_.empty() ? "http" : "https") + ("://127.0.0.1:" + std::to_string(port_));
  }
  /// Whoever asks from now on believes what this PEM file vouches for, at first the certificate in `more`.
  void believe(const std::filesystem::path& roots) { roots_ = roots; }
  /// Sends a signal and waits at most `within_s`; the exit code, or minus the signal that ended it.
  int end(int signal, double within_s = 20);
  /// What it has said on stdout and stderr.
  std::string said() const;

  /// One request; status 0 when nothing answers.
  http::HttpReply ask(const http::HttpClient::Request& request) const;
  http::HttpReply get(const std::string& target) const;
  http::HttpReply post(const std::string& target, const std::string& json, const std::string& key = "") const;

 private:
  pid_t pid_ = -1;
  int port_ = 0;
  std::filesystem::path log_, roots_;  ///< roots_: empty without TLS
};

}  // namespace toile
