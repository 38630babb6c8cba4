#pragma once
// Somebody who uses the service, over one connection that is kept.

#include <string>

#include "core/json/tree.h"
#include "server/http/client.h"

namespace toile::bench {

/// A drape of a square of cloth over a box, held by an edge so that it takes exactly as long as told.
struct Cloth {
  int size_mm = 200;
  int distance_mm = 35;  ///< between particles
  double seconds = 1;    ///< simulated
  std::string document() const;
};

/// What goes wrong ends the program: a bench has no figure then. Not thread-safe.
class Visitor {
 public:
  /// `token`: of an account; empty where there are none.
  explicit Visitor(const std::string& url, std::string token = "");

  http::HttpReply ask(const std::string& method, const std::string& target, const std::string& body = "");
  /// The answer as JSON; ends the program unless its status is 2xx.
  json::JsonValue get(const std::string& target) { return told(ask("GET", target), target); }
  json::JsonValue post(const std::string& target, const std::string& body) {
    return told(ask("POST", target, body), target);
  }
  /// The project's id.
  std::string project(const Cloth& cloth);
  /// The job's id. `more`: members of the request, each after a comma.
  std::string submit(const std::string& project, const std::string& more = "");
  /// Waits until that drape has ended; ends the program unless it has succeeded.
  void wait_for(const std::string& job);

 private:
  static json::JsonValue told(const http::HttpReply& reply, const std::string& target);

  http::HttpClient client_;
  std::string token_;
  std::string block_;  ///< id of the box
};

/// Without pictures, and draped although an equal one has been.
inline constexpr const char* kPlain = R"(, "pictures": false, "anew": true)";
inline constexpr const char* kAnew = R"(, "anew": true)";

std::string text_of_member(const json::JsonValue& value, const std::string& key);
double number_of_member(const json::JsonValue& value, const std::string& key);

/// Says why and ends the program with code 2.
[[noreturn]] void give_up(const std::string& why);

}  // namespace toile::bench
