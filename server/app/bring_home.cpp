#include "server/app/bring_home.h"

#include <optional>
#include <system_error>
#include <vector>

#include "core/base/hash.h"
#include "core/base/names.h"
#include "core/base/read_file.h"
#include "core/base/write_file.h"
#include "core/project/resolve/files.h"
#include "server/app/console.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

/// One file of the list that the server gives.
Status bring(Remote& remote, const std::string& job_id, const json::JsonValue& file, const fs::path& folder) {
  const std::string name = text_member(file, "name"), hash = text_member(file, "xxh3");
  if (name.find('/') != std::string::npos || !resolve::check_file_name(name).ok())
    return Error{"client.malformed", "the server names a result " + in_quotes(name), "", ErrorKind::kSystem};
  const std::optional<std::string> here = read_file(folder / name);
  if (here && !hash.empty() && hash_of(std::string_view(*here)) == hash) return {};
  const std::string bytes = TRY(remote.fetch("jobs/" + job_id + "/results/" + percent_encoded(name)));
  if (!hash.empty() && hash_of(std::string_view(bytes)) != hash)
    return Error{"client.other_bytes", "what has come is not what the server has kept", name,
                 ErrorKind::kSystem};
  return write_file(folder / name, bytes);
}

}  // namespace

Status bring_home(Remote& remote, const std::string& job_id, const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || !fs::is_directory(folder)) {
    return Error{"usage.out", "cannot make the folder for the results", folder.string()};
  }
  const json::JsonValue listed = TRY(remote.show("jobs/" + job_id + "/results"));
  const json::JsonValue* results = listed.find("results");
  if (!results || !results->array())
    return Error{"client.malformed", "the server's answer has no results", job_id, ErrorKind::kSystem};
  for (const json::JsonValue& file : *results->array()) TRY(bring(remote, job_id, file, folder));
  return {};
}

ExitCode exit_code_of_end(const std::string& state, const json::JsonValue* report) {
  if (state == "cancelled") return kCancelled;
  const json::JsonValue* settled = report ? report->find("settled") : nullptr;
  if (!settled || !settled->boolean() || !*settled->boolean()) return kUnsettled;
  return text_member(*report, "worn") == "no" ? kNotWorn : kDone;
}

ExitCode fail_remote(const Error& error, bool json) {
  print_error(error, json);
  const bool ours = error.kind == ErrorKind::kSystem || error.kind == ErrorKind::kUnavailable;
  return ours ? kInternal : exit_code_of(error);
}

}  // namespace toile::app
