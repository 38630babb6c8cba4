#pragma once
// The client's side of a connection, byte by byte, so that tests can also say what no decent client would.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace toile::test {

/// A TCP connection to the loopback. Every call ends after a few seconds at the latest.
class Wire {
 public:
  explicit Wire(int port, int receive_buffer = 0);
  ~Wire();
  Wire(Wire&& other) noexcept;
  Wire(const Wire&) = delete;

  /// False when the other side does not take it.
  bool send(std::string_view bytes);
  /// Exactly `size` bytes; nothing when they do not come within `within_s`.
  std::optional<std::string> read(std::size_t size, double within_s = 120);
  /// Up to and with `mark`.
  std::optional<std::string> read_until(std::string_view mark, double within_s = 120);
  /// Waits for the other side's end; false when it does not come.
  bool closed(double within_s);

 private:
  bool fill(double within_s);

  int socket_ = -1;
  std::string buffer_;
  bool ended_ = false;
};

struct Answer {
  int status = 0;                              ///< 0: there was none
  std::map<std::string, std::string> headers;  ///< lower case
  std::string body;
};

/// The next answer on the wire. `head`: it has no body whatever its header says.
Answer read_answer(Wire& wire, bool head = false);

/// One request on a connection of its own. `headers` are whole lines.
Answer ask(int port, const std::string& method, const std::string& target, const std::string& body = "",
           const std::string& headers = "");

/// A viewer.
class Socket {
 public:
  Socket(int port, const std::string& target, const std::string& headers = "", int receive_buffer = 0);
  int status() const { return status_; }  ///< of the handshake; 101 is good

  enum Opcode : std::uint8_t { kContinuation = 0, kText = 1, kBinary = 2, kClose = 8, kPing = 9, kPong = 10 };
  struct Message {
    std::uint8_t opcode = 0;
    std::string payload;
    int close_code() const;
  };
  /// The next message; pings are answered and passed over when `pong`. Nothing at the end of the connection.
  std::optional<Message> read(double within_s = 20, bool pong = true);
  /// Reads until a close; its code, or 0 when the connection ends without.
  int read_to_close(double within_s = 20);
  bool send(Opcode opcode, std::string_view payload);
  /// Any bytes.
  bool send_raw(std::string_view bytes) { return wire_.send(bytes); }
  Wire& wire() { return wire_; }

 private:
  Wire wire_;
  int status_ = 0;
};

/// A frame as a client sends it. `first` and the mask bit can be wrong on purpose.
std::string client_frame(std::uint8_t first, std::string_view payload, bool masked = true);

}  // namespace toile::test
