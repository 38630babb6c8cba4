#include "server/http/connections.h"

#include <algorithm>
#include <chrono>

#include "server/http/session.h"

namespace toile::http {

bool Connections::make_room(const std::string& address, int count, const ServerSettings& settings) {
  const std::lock_guard lock(mutex_);
  const auto of_address = std::count_if(sessions_.begin(), sessions_.end(),
                                        [&](const auto& session) { return session->address() == address; });
  // All that come by a proxy come from its address.
  const bool too_many_of_it = !settings.behind_proxy && of_address >= settings.most_of_address;
  if (count < settings.most_connections && !too_many_of_it) return true;
  HttpSession* idlest = nullptr;
  for (const auto& session : sessions_) {
    if (too_many_of_it && session->address() != address) continue;
    if (idlest == nullptr || session->idle_since() < idlest->idle_since()) idlest = session.get();
  }
  if (idlest == nullptr || idlest->idle_since() == std::chrono::steady_clock::time_point::max()) return false;
  idlest->make_room();
  return true;
}

bool Connections::add(const std::shared_ptr<HttpSession>& session) {
  const std::lock_guard lock(mutex_);
  if (!stopping_) sessions_.push_back(session);
  return !stopping_;
}

void Connections::remove(const HttpSession* session) {
  const std::lock_guard lock(mutex_);
  std::erase_if(sessions_, [session](const auto& other) { return other.get() == session; });
}

void Connections::stop_all() {
  const std::lock_guard lock(mutex_);
  stopping_ = true;
  for (const auto& session : sessions_) session->stop();
}

void Connections::forget_all() {
  const std::lock_guard lock(mutex_);
  sessions_.clear();
}

std::size_t Connections::count() const {
  const std::lock_guard lock(mutex_);
  return sessions_.size();
}

}  // namespace toile::http
