#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>

#include "server/ws/stream_settings.h"

namespace toile::http {

struct ServerSettings {
  std::string address = "127.0.0.1";  ///< of the loopback
  int port = 8460;                    ///< 0: any that is free
  std::filesystem::path web;          ///< folder of the built page; need not be there
  int io_threads = 2;
  int light_threads = 2;  ///< for handlers that ask the store
  int heavy_threads = 2;  ///< for those that read geometry

  std::chrono::milliseconds idle_within{60'000};   ///< from one request to the next
  std::chrono::milliseconds header_within{3'000};  ///< from the first byte of a request
  std::chrono::milliseconds body_within{60'000};
  std::chrono::milliseconds write_within{60'000};
  std::size_t most_header_bytes = 8 << 10;
  int most_connections = 512;
  /// Of all bodies that are being received or worked on together; beyond it uploads wait for later (503).
  std::size_t most_body_bytes = std::size_t{512} << 20;

  ws::StreamSettings stream;
};

}  // namespace toile::http
