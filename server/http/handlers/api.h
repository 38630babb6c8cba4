#pragma once
// The routes of the service, resource by resource: each handler file ends with the table of its own. A
// handler parses, calls and answers; it may block.

#include <atomic>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "server/accounts/gate.h"
#include "server/accounts/link_gate.h"
#include "server/accounts/log_in.h"
#include "server/documents/documents.h"
#include "server/http/metrics.h"
#include "server/http/router.h"
#include "server/jobs/job_stills.h"
#include "server/jobs/movies.h"
#include "server/jobs/service.h"
#include "server/store/store.h"
#include "server/ws/hub.h"

namespace toile::handlers {

/// Where people come in.
struct Doors {
  accounts::Gate gate;
  accounts::LogIn log_in;
  std::string cookie;  ///< name of that of a session
  Doors(store::Accounts& accounts, std::string cookie_named)
      : gate(accounts), log_in(accounts, gate), cookie(std::move(cookie_named)) {}
};

/// Where share links lead.
struct LinkDoor {
  accounts::LinkGate gate;
  bool secure;  ///< browsers come by https
  LinkDoor(store::Links& links, bool with_accounts, bool by_https)
      : gate(links, with_accounts), secure(by_https) {}
};

/// What handlers work with; all of it outlives the router.
struct Api {
  documents::Documents& documents;
  store::Store& store;  ///< that of the documents
  jobs::JobService& jobs;
  jobs::Movies& movies;
  jobs::JobStills& stills;
  const ws::Hub& hub;
  const http::Metrics& metrics;
  const std::atomic<bool>& ready;  ///< false while the server drains
  Doors* doors = nullptr;          ///< null: there are no accounts, and the store need not keep any
  LinkDoor* link_door = nullptr;   ///< null: there are no share links
};

/// A line of a table: a Route (router.h) whose handler is told what it works with.
struct ApiRoute {
  const char* method = "GET";
  const char* pattern = "";
  std::function<http::HttpResponse(const Api&, const store::RequestContext&, const http::HttpRequest&)>
      handler;
  http::BodyKind body = http::BodyKind::kUnused;
  std::function<std::size_t(const http::HttpRequest&)> limit = http::small_body;
  http::Work work = http::Work::kStore;
  http::Access access = http::Access::kByMethod;
  std::vector<std::string> parameters{};
  bool websocket = false;
};
using ApiRoutes = std::vector<ApiRoute>;

ApiRoutes health_routes();
ApiRoutes asset_routes();
ApiRoutes project_routes();
ApiRoutes pattern_file_routes();
ApiRoutes edit_routes();
ApiRoutes version_routes();
ApiRoutes body_routes();
ApiRoutes fabric_routes();
ApiRoutes arrangement_routes();
ApiRoutes job_routes();
ApiRoutes movie_routes();
ApiRoutes still_routes();
ApiRoutes link_routes();
ApiRoutes shared_routes();
ApiRoutes session_routes();
ApiRoutes admin_routes();

}  // namespace toile::handlers
