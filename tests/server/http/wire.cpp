#include "tests/server/http/wire.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <utility>

namespace toile::test {
namespace {

using Clock = std::chrono::steady_clock;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string big_endian(std::uint64_t value, int bytes) {
  std::string out;
  for (int i = bytes - 1; i >= 0; --i) out += static_cast<char>((value >> (8 * i)) & 0xff);
  return out;
}

std::uint64_t number_of(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char c : bytes) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

}  // namespace

Wire::Wire(int port, int receive_buffer) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  if (receive_buffer > 0)
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  const timeval patience{20, 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ended_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0;
}

Wire::~Wire() {
  if (socket_ >= 0) ::close(socket_);
}

Wire::Wire(Wire&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), buffer_(std::move(other.buffer_)), ended_(other.ended_) {}

bool Wire::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

bool Wire::fill(double within_s) {
  if (ended_) return false;
  pollfd waiting{socket_, POLLIN, 0};
  if (::poll(&waiting, 1, static_cast<int>(std::max(0.0, within_s) * 1000)) <= 0) return false;
  char chunk[16384];
  const ssize_t size = ::recv(socket_, chunk, sizeof chunk, 0);
  if (size <= 0) {
    ended_ = true;
    return false;
  }
  buffer_.append(chunk, static_cast<std::size_t>(size));
  return true;
}

std::optional<std::string> Wire::read(std::size_t size, double within_s) {
  const Clock::time_point until = Clock::now() + std::chrono::milliseconds(static_cast<int>(within_s * 1000));
  while (buffer_.size() < size) {
    if (!fill(std::chrono::duration<double>(until - Clock::now()).count())) return std::nullopt;
  }
  std::string out = buffer_.substr(0, size);
  buffer_.erase(0, size);
  return out;
}

std::optional<std::string> Wire::read_until(std::string_view mark, double within_s) {
  const Clock::time_point until = Clock::now() + std::chrono::milliseconds(static_cast<int>(within_s * 1000));
  for (;;) {
    if (const std::size_t at = buffer_.find(mark); at != std::string::npos) return read(at + mark.size(), 0);
    if (!fill(std::chrono::duration<double>(until - Clock::now()).count())) return std::nullopt;
  }
}

bool Wire::closed(double within_s) {
  const Clock::time_point until = Clock::now() + std::chrono::milliseconds(static_cast<int>(within_s * 1000));
  while (!ended_ && Clock::now() < until) {
    if (fill(std::chrono::duration<double>(until - Clock::now()).count())) buffer_.clear();
  }
  return ended_;
}

Answer read_answer(Wire& wire, bool head) {
  Answer answer;
  const auto header = wire.read_until("\r\n\r\n");
  if (!header || !header->starts_with("HTTP/1.1 ")) return answer;
  answer.status = std::stoi(header->substr(9, 3));
  for (std::size_t at = header->find("\r\n") + 2; at + 2 < header->size();) {
    const std::size_t end = header->find("\r\n", at), colon = header->find(": ", at);
    if (colon < end)
      answer.headers[lower(header->substr(at, colon - at))] = header->substr(colon + 2, end - colon - 2);
    at = end + 2;
  }
  if (answer.status == 100) return read_answer(wire, head);
  const auto length = answer.headers.find("content-length");
  if (head || length == answer.headers.end()) return answer;
  const auto body = wire.read(std::stoul(length->second), 60);
  answer.body = body ? *body : "cut off";
  return answer;
}

Answer ask(int port, const std::string& method, const std::string& target, const std::string& body,
           const std::string& headers) {
  Wire wire(port);
  std::string head =
      method + " " + target + " HTTP/1.1\r\nHost: localhost:" + std::to_string(port) + "\r\n" + headers;
  if (!body.empty() || method == "POST" || method == "PUT") {
    head += "Content-Length: " + std::to_string(body.size()) + "\r\n";
  }
  wire.send(head + "\r\n");
  wire.send(body);  // may fail: refused before all of it is there
  return read_answer(wire, method == "HEAD");
}

std::string client_frame(std::uint8_t first, std::string_view payload, bool masked) {
  std::string out(1, static_cast<char>(first));
  const std::uint8_t mask_bit = masked ? 0x80 : 0;
  if (payload.size() < 126) {
    out += static_cast<char>(mask_bit | payload.size());
  } else if (payload.size() < 65536) {
    out += static_cast<char>(mask_bit | 126);
    out += big_endian(payload.size(), 2);
  } else {
    out += static_cast<char>(mask_bit | 127);
    out += big_endian(payload.size(), 8);
  }
  if (!masked) return out += payload;
  const std::string mask = "\x12\x34\x56\x78";
  out += mask;
  for (std::size_t i = 0; i < payload.size(); ++i) out += static_cast<char>(payload[i] ^ mask[i % 4]);
  return out;
}

Socket::Socket(int port, const std::string& target, const std::string& headers, int receive_buffer)
    : wire_(port, receive_buffer) {
  wire_.send("GET " + target + " HTTP/1.1\r\nHost: localhost:" + std::to_string(port) +
             "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
             "Sec-WebSocket-Key: AAECAwQFBgcICQoLDA0ODw==\r\n" +
             headers + "\r\n");
  status_ = read_answer(wire_).status;
}

int Socket::Message::close_code() const {
  return opcode == kClose && payload.size() >= 2 ? static_cast<int>(number_of(payload.substr(0, 2))) : 0;
}

std::optional<Socket::Message> Socket::read(double within_s, bool pong) {
  for (;;) {
    const auto head = wire_.read(2, within_s);
    if (!head) return std::nullopt;
    std::uint64_t size = static_cast<unsigned char>((*head)[1]) & 0x7f;
    if (size >= 126) {
      const auto longer = wire_.read(size == 126 ? 2 : 8, within_s);
      if (!longer) return std::nullopt;
      size = number_of(*longer);
    }
    const auto payload = wire_.read(size, within_s);
    if (!payload) return std::nullopt;
    const Message message{static_cast<std::uint8_t>(static_cast<unsigned char>((*head)[0]) & 0x0f), *payload};
    if (message.opcode != kPing || !pong) return message;
    send(kPong, message.payload);
  }
}

int Socket::read_to_close(double within_s) {
  while (const std::optional<Message> message = read(within_s)) {
    if (message->opcode != kClose) continue;
    send(kClose, message->payload.substr(0, 2));
    return message->close_code();
  }
  return 0;
}

bool Socket::send(Opcode opcode, std::string_view payload) {
  return wire_.send(client_frame(static_cast<std::uint8_t>(0x80 | opcode), payload));
}

}  // namespace toile::test
