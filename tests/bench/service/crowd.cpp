#include "tests/bench/service/crowd.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "tests/bench/service/visitor.h"

namespace toile::bench {
namespace {

constexpr int kSmallBuffer = 4096;  ///< bytes that a socket takes whose reader does not

/// A stream's socket after its handshake, with what has come behind it.
int opened(int port, const std::string& job, bool small, std::string& rest) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  if (small) ::setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &kSmallBuffer, sizeof kSmallBuffer);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0)
    give_up("a viewer is not let in");
  const std::string hello = "GET /api/v1/jobs/" + job +
                            "/stream HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
                            "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                            "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
  if (::send(socket, hello.data(), hello.size(), MSG_NOSIGNAL) < 0) give_up("a viewer is not let in");
  std::array<char, 1024> piece{};
  while (rest.find("\r\n\r\n") == std::string::npos) {
    const ssize_t got = ::recv(socket, piece.data(), piece.size(), 0);
    if (got <= 0) give_up("a viewer's handshake is not answered");
    rest.append(piece.data(), static_cast<std::size_t>(got));
  }
  if (!rest.starts_with("HTTP/1.1 101")) give_up("a viewer is refused: " + rest);
  rest.erase(0, rest.find("\r\n\r\n") + 4);
  return socket;
}

struct Message {
  std::uint8_t opcode = 0;
  std::size_t head = 0, size = 0;
};

/// Of the message at the buffer's start; head 0 when its head has not come whole.
Message message_in(const std::string& buffer) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(buffer[i]); };
  if (buffer.size() < 2) return {};
  Message message{static_cast<std::uint8_t>(byte(0) & 0x0F), 2, static_cast<std::size_t>(byte(1) & 0x7F)};
  const std::size_t more = message.size == 126 ? 2 : message.size == 127 ? 8 : 0;
  if (buffer.size() < 2 + more) return {};
  if (more > 0) message.size = 0;
  for (std::size_t i = 0; i < more; ++i) message.size = message.size << 8 | byte(2 + i);
  message.head += more;
  return message;
}

}  // namespace

Crowd::Crowd(int port, const std::string& job, int viewers, bool read)
    : viewers_(static_cast<std::size_t>(viewers)) {
  for (Viewer& viewer : viewers_) viewer.socket = opened(port, job, !read, viewer.buffer);
  if (read) reader_ = std::thread([this] { read_on(); });
}

Crowd::~Crowd() {
  over_ = true;
  if (reader_.joinable()) reader_.join();
  for (const Viewer& viewer : viewers_) ::close(viewer.socket);
}

std::vector<long> Crowd::frames() const {
  std::vector<long> counts;
  counts.reserve(viewers_.size());
  for (const Viewer& viewer : viewers_) counts.push_back(viewer.frames);
  return counts;
}

void Crowd::read_on() {
  std::vector<pollfd> sockets;
  for (const Viewer& viewer : viewers_) sockets.push_back({viewer.socket, POLLIN, 0});
  std::string piece(1 << 16, '\0');
  while (!over_) {
    if (::poll(sockets.data(), sockets.size(), 100) <= 0) continue;
    for (std::size_t i = 0; i < sockets.size(); ++i) {
      if (sockets[i].revents == 0) continue;
      const ssize_t got = ::recv(sockets[i].fd, piece.data(), piece.size(), 0);
      if (got <= 0) {
        sockets[i].fd = -1;  // poll passes over it
        ++gone_;
        continue;
      }
      viewers_[i].buffer.append(piece, 0, static_cast<std::size_t>(got));
      take(viewers_[i]);
    }
  }
}

void Crowd::take(Viewer& viewer) {
  constexpr std::uint8_t kBinary = 2, kPing = 9;
  for (;;) {
    const Message message = message_in(viewer.buffer);
    if (message.head == 0 || viewer.buffer.size() < message.head + message.size) return;
    if (message.opcode == kBinary) ++viewer.frames;
    if (message.opcode == kPing) {  // with an empty mask and its payload, which is short
      std::string pong{'\x8A', static_cast<char>(0x80 | message.size), 0, 0, 0, 0};
      pong += viewer.buffer.substr(message.head, message.size);
      if (::send(viewer.socket, pong.data(), pong.size(), MSG_NOSIGNAL) < 0) return;
    }
    viewer.buffer.erase(0, message.head + message.size);
  }
}

}  // namespace toile::bench
