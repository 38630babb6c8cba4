#pragma once
// Where a server finds what it works with.

#include <filesystem>
#include <optional>
#include <string>

#include "server/jobs/limits.h"
#include "server/jobs/retention.h"
#include "server/log/stderr_sink.h"
#include "server/store/store.h"

namespace toile::app {

struct ServeOptions {
  std::string address = "127.0.0.1";
  bool container = false;  ///< listen on any address, for the machine around the container alone
  std::string tls_certificate, tls_key;  ///< PEM files; empty: no TLS
  bool webhooks_to_private = false;      ///< tells webhooks of private networks as well
  bool behind_proxy = false;             ///< a proxy speaks TLS to others
  bool accounts = false;                 ///< only who is known is let in, also while the store has no account
  int port = 8460;                       ///< 0: any that is free
  std::string data = "data";             ///< folder of the store; made when it is not there
  int workers = 0;                       ///< drapes at once; 0: one for each core, at most kMostWorkers
  bool no_workers = false;               ///< other processes drape
  double checkpoint_every_s = 5;         ///< by the clock: what a crash can cost a drape
  std::string web;         ///< folder of the built page; empty: the one that came with the program
  std::string sample;      ///< folder of the first project; empty: the one that came with the program
  bool no_sample = false;  ///< begin a new store empty
  std::optional<log::LogFormat> log;  ///< nothing: text on a terminal, else JSON
  store::Quotas quotas;               ///< of each user
  jobs::JobLimits limits;             ///< of each drape
  jobs::RetentionSettings retention;
};

inline constexpr int kMostWorkers = 64;

/// How many drapes at once when nothing is said: one for each core.
int usual_workers();
/// How lines are logged when nothing is said: text for people.
log::LogFormat usual_log();

/// `options` with the defaults of this machine in place of what was left open.
ServeOptions completed(ServeOptions options);

/// A folder that comes with the program ("samples/skirt"): in the working folder, in the source tree above
/// the program's own folder, or in ../share/toile beside it. Empty when it is nowhere.
std::filesystem::path shipped_folder(const std::string& relative);

}  // namespace toile::app
