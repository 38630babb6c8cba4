#include "tests/bench/service/visitor.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <utility>

#include "core/base/text.h"

namespace toile::bench {
namespace {

constexpr const char* kBlock =
    "v -0.05 0 -0.05\nv 0.05 0 -0.05\nv 0.05 0 0.05\nv -0.05 0 0.05\n"
    "v -0.05 0.1 -0.05\nv 0.05 0.1 -0.05\nv 0.05 0.1 0.05\nv -0.05 0.1 0.05\n"
    "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

http::HttpClient client_of(const std::string& url) {
  Result<http::HttpClient> client = http::HttpClient::make(url);
  if (!client) give_up(client.error().message);
  return std::move(*client);
}

}  // namespace

void give_up(const std::string& why) {
  std::fprintf(stderr, "bench_service: %s\n", why.c_str());
  std::exit(2);
}

std::string text_of_member(const json::JsonValue& value, const std::string& key) {
  const json::JsonValue* found = value.find(key);
  if (!found || !found->text()) give_up("an answer has no text " + key);
  return *found->text();
}

double number_of_member(const json::JsonValue& value, const std::string& key) {
  const json::JsonValue* found = value.find(key);
  if (!found || !found->number()) give_up("an answer has no number " + key);
  return *found->number();
}

std::string Cloth::document() const {
  const std::string s = std::to_string(size_mm), half = fixed_text(size_mm / 2000.0, 4);
  std::string text = R"({"toile": 1, "name": "Cloth", "pieces": [{"id": "cloth", "outline": [
    {"id": "south", "points": [[0, 0], [S, 0]]}, {"id": "east", "points": [[S, 0], [S, S]]},
    {"id": "north", "points": [[S, S], [0, S]]}, {"id": "west", "points": [[0, S], [0, 0]]}],
    "fabric": "cotton", "placement": {"rigid": {"translation": [-H, 0.11, H], "rotation": [-90, 0, 0]}}}],
    "fabrics": [{"id": "cotton", "areal_mass_g_m2": 150, "stretch_warp_n_m": 2000, "stretch_weft_n_m": 1500,
      "stretch_shear_n_m": 500, "bend_warp_un_m": 10, "bend_weft_un_m": 8, "bend_bias_un_m": 7,
      "thickness_mm": 0.4}],
    "seams": [], "bodies": [{"id": "block", "file": "block.obj", "unit": "m"}],
    "attachments": [{"id": "pin", "piece": "cloth", "edges": ["south"], "release_after_s": 3000}],
    "settings": {"particle_distance_mm": D, "sew_time_s": 0, "max_time_s": T}})";
  const std::pair<std::string, std::string> places[] = {{"[S,", "[" + s + ","},
                                                        {", S]", ", " + s + "]"},
                                                        {"-H", "-" + half},
                                                        {" H]", " " + half + "]"},
                                                        {": D,", ": " + std::to_string(distance_mm) + ","},
                                                        {": T}", ": " + fixed_text(seconds, 3) + "}"}};
  for (const auto& [from, to] : places) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  }
  return text;
}

Visitor::Visitor(const std::string& url, std::string token)
    : client_(client_of(url)), token_(std::move(token)) {}

http::HttpReply Visitor::ask(const std::string& method, const std::string& target, const std::string& body) {
  http::HttpClient::Request request;
  request.method = method;
  request.target = target;
  request.body = body;
  const bool file = target.starts_with("/api/v1/assets");
  if (!body.empty()) request.content_type = file ? "application/octet-stream" : "application/json";
  if (!token_.empty()) request.headers.emplace_back("Authorization", "Bearer " + token_);
  Result<http::HttpReply> reply = client_.ask(request);
  if (!reply) give_up(target + ": " + reply.error().message);
  return std::move(*reply);
}

json::JsonValue Visitor::told(const http::HttpReply& reply, const std::string& target) {
  if (reply.status < 200 || reply.status > 299)
    give_up(target + " answered " + std::to_string(reply.status) + ": " + reply.body);
  Result<json::JsonValue> tree = json::parse_json(reply.body, {.depth = 64});
  if (!tree) give_up(target + ": " + tree.error().message);
  return std::move(*tree);
}

std::string Visitor::project(const Cloth& cloth) {
  if (block_.empty()) block_ = text_of_member(post("/api/v1/assets?kind=body&name=block.obj", kBlock), "id");
  const std::string body =
      R"({"document": )" + cloth.document() + R"(, "files": {"block.obj": ")" + block_ + R"("}})";
  return text_of_member(post("/api/v1/projects", body), "id");
}

std::string Visitor::submit(const std::string& project, const std::string& more) {
  return text_of_member(post("/api/v1/jobs", R"({"project_id": ")" + project + "\"" + more + "}"), "id");
}

void Visitor::wait_for(const std::string& job) {
  for (;;) {
    const std::string state = text_of_member(get("/api/v1/jobs/" + job), "state");
    if (state == "succeeded") return;
    if (state == "failed" || state == "cancelled") give_up("the drape " + job + " is " + state);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace toile::bench
