#pragma once
// Who is connected. Internal to http.

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/http/server_settings.h"

namespace toile::http {

class HttpSession;

/// Who is connected, so that a stop can tell them. Thread-safe.
class Connections {
 public:
  /// Whether one more of that address may come: when there are too many, of all or of the address, the one of
  /// them that has been idle longest is ended. `count` are connected.
  bool make_room(const std::string& address, int count, const ServerSettings& settings);
  /// False when the server is stopping.
  bool add(const std::shared_ptr<HttpSession>& session);
  void remove(const HttpSession* session);
  /// Asks everybody to come to an end; nobody may join any more.
  void stop_all();
  /// Those that did not come to an end. Nothing may run any more.
  void forget_all();
  std::size_t count() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<HttpSession>> sessions_;
  bool stopping_ = false;
};

}  // namespace toile::http
