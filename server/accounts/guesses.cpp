#include "server/accounts/guesses.h"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>

namespace toile::accounts {

std::chrono::seconds Guesses::wait(const std::string& name, Clock::time_point now) const {
  const std::lock_guard lock(mutex_);
  const auto found = windows_.find(name);
  if (found == windows_.end() || found->second.misses < most_) return std::chrono::seconds(0);
  const auto left = found->second.began + window_ - now;
  if (left <= Clock::duration::zero()) return std::chrono::seconds(0);
  return std::chrono::ceil<std::chrono::seconds>(left);
}

void Guesses::missed(const std::string& name, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  if (!windows_.contains(name)) make_room(now);
  Window& window = windows_[name];
  if (window.misses == 0 || now - window.began >= window_) window = {now, 0};
  ++window.misses;
}

void Guesses::met(const std::string& name) {
  const std::lock_guard lock(mutex_);
  windows_.erase(name);
}

void Guesses::make_room(Clock::time_point now) {
  if (windows_.size() < most_names_) return;
  std::erase_if(windows_, [&](const auto& entry) { return now - entry.second.began >= window_; });
  if (windows_.size() < most_names_) return;
  const auto older = [](const auto& a, const auto& b) { return a.second.began < b.second.began; };
  windows_.erase(std::min_element(windows_.begin(), windows_.end(), older));
}

std::string network_of(const std::string& address) {
  in6_addr six{};
  if (::inet_pton(AF_INET6, address.c_str(), &six) != 1) return address;
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (IN6_IS_ADDR_V4MAPPED(&six)) {
    ::inet_ntop(AF_INET, &six.s6_addr[12], text.data(), text.size());
    return text.data();
  }
  std::fill(std::begin(six.s6_addr) + 8, std::end(six.s6_addr), std::uint8_t{0});
  ::inet_ntop(AF_INET6, &six, text.data(), text.size());
  return std::string(text.data()) + "/64";
}

}  // namespace toile::accounts
