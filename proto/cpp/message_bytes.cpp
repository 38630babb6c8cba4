#include "proto/cpp/message_bytes.h"

namespace toile::proto {

void put_varint(std::string& out, std::uint32_t value) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<char>(value | 0x80));
  out.push_back(static_cast<char>(value));
}

void put_difference(std::string& out, std::int32_t difference) {
  const auto d = static_cast<std::uint32_t>(difference);
  put_varint(out, (d << 1) ^ (difference < 0 ? ~0u : 0u));
}

void put_prefix(std::string& out, MessageType type, std::uint32_t epoch) {
  out += kMessageMagic;
  out.push_back(static_cast<char>(kMessageVersion));
  out.push_back(static_cast<char>(type));
  put(out, epoch);
}

std::string_view ByteReader::take_bytes(std::size_t count) {
  if (!ok_ || count > rest_.size()) {
    ok_ = false;
    return {};
  }
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

std::uint32_t ByteReader::take_varint() {
  std::uint32_t value = 0;
  for (int shift = 0; shift < 35; shift += 7) {
    const std::uint32_t byte = take<std::uint8_t>();
    if (!ok_ || (shift == 28 && byte > 0x0f)) break;  // more than 32 bits
    value |= (byte & 0x7f) << shift;
    if (byte < 0x80) return value;
  }
  ok_ = false;
  return 0;
}

std::int32_t ByteReader::take_difference() {
  const std::uint32_t code = take_varint();
  return static_cast<std::int32_t>((code >> 1) ^ (~(code & 1) + 1));
}

Error malformed(std::string message) { return {"frame.malformed", std::move(message), "stream message"}; }

Result<MessageType> message_type(std::string_view bytes) {
  if (bytes.size() < kPrefixSize || !bytes.starts_with(kMessageMagic)) {
    return malformed("this is no message of a drape's stream");
  }
  if (static_cast<std::uint8_t>(bytes[2]) != kMessageVersion) {
    return Error{"frame.version",
                 "the stream speaks another version than this program; bring both to the same",
                 "stream message"};
  }
  const auto type = static_cast<std::uint8_t>(bytes[3]);
  if (type < 1 || type > 3) return malformed("the message is of no known type");
  return static_cast<MessageType>(type);
}

}  // namespace toile::proto
