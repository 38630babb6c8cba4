#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>

#include "server/accounts/gate.h"
#include "server/accounts/link_gate.h"
#include "server/ws/stream_settings.h"

namespace toile::http {

struct ServerSettings {
  /// To listen on. One that is not of the loopback wants accounts, and TLS or a proxy that speaks it.
  std::string address = "127.0.0.1";
  bool container = false;  ///< any address, for the machine around a container alone (host_of_container.h)
  std::string tls_certificate, tls_key;              ///< PEM files; empty: plain HTTP
  std::chrono::milliseconds tls_look_every{10'000};  ///< whether these have changed
  bool behind_proxy = false;  ///< which speaks TLS to others, passes Host on, and says X-Forwarded-For
  int port = 8460;            ///< 0: any that is free
  std::filesystem::path web;  ///< folder of the built page; need not be there
  int io_threads = 2;
  int light_threads = 2;    ///< for handlers that ask the store, and as many for those that read documents
  int submit_threads = 16;  ///< for those that submit: they wait for the disk, and those who wait share it
  int heavy_threads = 2;    ///< for those that read bodies and starts, and as many for uploads

  std::chrono::milliseconds idle_within{60'000};        ///< from one request to the next
  std::chrono::milliseconds header_within{3'000};       ///< from the first byte of a request
  std::chrono::milliseconds body_pause_within{10'000};  ///< from one piece of a body to the next
  std::chrono::milliseconds slow_for{5'000};            ///< before a body's rate is looked at
  std::size_t least_body_rate = 16 << 10;               ///< bytes a second on average from then on
  std::chrono::milliseconds write_within{20'000};       ///< for one piece of an answer
  std::chrono::milliseconds work_within{120'000};       ///< for a handler, before it is asked to give up
  std::size_t most_header_bytes = 8 << 10;
  int most_connections = 512;     ///< beyond it the one that has been idle longest makes room
  int most_of_address = 384;      ///< of them
  std::size_t most_waiting = 64;  ///< heavy requests of one user that wait, and as many uploads; then 429
  /// Of all bodies that are being received or worked on together; beyond it uploads wait for later (503).
  std::size_t most_body_bytes = std::size_t{512} << 20;
  /// Of all answers that lie in memory while they are sent; files are sent piece by piece and count nothing.
  std::size_t most_answer_bytes = std::size_t{256} << 20;

  ws::StreamSettings stream;

  bool secure() const { return behind_proxy || !tls_certificate.empty(); }  ///< browsers come by https

  /// Lets in who is known; it outlives the server. Null: there are no accounts, and whoever comes is the
  /// single user.
  accounts::Gate* gate = nullptr;
  /// Lets in who has a share link; it outlives the server. Null: there are none.
  accounts::LinkGate* links = nullptr;
};

}  // namespace toile::http
