#pragma once
// What is kept between two starts of the server, behind one interface: projects, files, jobs and their
// results. One implementation stands on SQLite and a folder of blobs. Every call names the owner; what
// belongs to somebody else is not found. Calls are thread-safe and durable: once one returns, a crash does
// not undo it.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "server/store/accounts.h"
#include "server/store/job_priority.h"
#include "server/store/job_state.h"
#include "server/store/links.h"
#include "server/store/request_context.h"

namespace toile::store {

/// An uploaded file. Content, kind and name never change; the same three of one owner are one asset.
struct AssetRow {
  std::string id;    ///< "a_" and 32 hex digits: XXH3 over kind, name and content
  std::string kind;  ///< "dxf" or "body"
  std::string name;  ///< file name as uploaded, without folders
  std::int64_t size = 0;
  std::int64_t created_ms = 0;  ///< Unix time
  std::string info;             ///< JSON object: what reading it told (pieces, triangles, …)
};

/// A project document with the files that it names.
struct ProjectRow {
  std::string id;  ///< "p_" and 20 characters; rises with time
  std::string name;
  int revision = 1;                          ///< rises with every replacement; the ETag
  std::string document;                      ///< project.schema.json, text
  std::map<std::string, std::string> files;  ///< file name in the document → asset id
  std::int64_t created_ms = 0, updated_ms = 0;
};

/// A step of a project's history: edits that were made together.
struct EditRow {
  std::int64_t number = 0;  ///< rises by one within the project
  std::string edits;        ///< JSON list (edit.schema.json)
  std::string inverse;      ///< another: it gives the document of before
  std::string original;     ///< that document's own text, where the edits' writer would have put it otherwise
  bool undone = false;
  std::int64_t created_ms = 0;
};

enum class EditStep { kDo, kUndo, kRedo };

/// What a job's end fell short of although it ended well: "stills.not_drawn", with a sentence for a person.
struct JobNote {
  std::string code, message;
  friend bool operator==(const JobNote&, const JobNote&) = default;
};

/// How a drape came out whose pictures are still to be drawn: what its job will say once they are, or once
/// they are given up.
struct JobVerdict {
  bool succeeded = false;
  std::string code, reason, where;
  friend bool operator==(const JobVerdict&, const JobVerdict&) = default;
};

/// A file that a job has left.
struct ResultFile {
  std::int64_t bytes = 0;
  std::string hash;        ///< XXH3 of its bytes (core/base/hash.h); empty in rows of before it was kept
  ResultFile() = default;  // NOLINTNEXTLINE(google-explicit-constructor): a size alone, as in older rows
  ResultFile(std::int64_t size, std::string digits = "") : bytes(size), hash(std::move(digits)) {}
  friend bool operator==(const ResultFile&, const ResultFile&) = default;
};
using ResultFiles = std::map<std::string, ResultFile>;  ///< by name

/// Who works on a job. The number rises each time that another takes it, and fences: what is done under an
/// older one is refused.
struct JobLease {
  std::string holder;  ///< a store that is open (Store::holder); empty: nobody
  std::int64_t number = 0;
  std::int64_t until_ms = 0;  ///< Unix time; a holder who has not been heard of until then is given up
  friend bool operator==(const JobLease&, const JobLease&) = default;
};

/// Where a drape stands among those that were asked for together (sweeps.h).
struct SweepCell {
  std::string sweep;         ///< id; empty: it was asked for by itself
  int body = 0, fabric = 0;  ///< indices of its row and its column
  friend bool operator==(const SweepCell&, const SweepCell&) = default;
};

using Tags = std::vector<std::string>;

/// A drape that was asked for. The document and files are copies of the project's at that moment.
struct JobRow {
  std::string id;  ///< "j_" and 20 characters; rises with time
  std::string project_id;
  int project_revision = 0;
  std::string name;
  std::string document;
  std::map<std::string, std::string> files;
  JobPriority priority = JobPriority::kBatch;
  bool pictures = true;  ///< are drawn of its end
  SweepCell cell;
  Tags tags;          ///< to be put on it where it is made; who wants to know them asks JobSearch
  std::string input;  ///< what its results follow from, as a hash; empty: not known
  JobState state = JobState::kQueued;
  std::string reason_code;  ///< of a final state, e.g. "settled", "time", "start.crosses_body"
  std::string reason;       ///< a sentence for a person
  std::string reason_where;
  std::vector<JobNote> notes;
  std::optional<JobVerdict> verdict;  ///< there while the job has been draped and has not ended
  int attempt = 0;                    ///< starts that nothing is known to have come of
  bool suspect = false;               ///< may have crashed its holder: runs alone until it has come further
  JobLease lease;
  std::string progress;  ///< JSON: what its holder told last (server/jobs/row_progress.h)
  std::int64_t created_ms = 0, started_ms = 0, ended_ms = 0;
  std::int64_t worked_ms = 0;  ///< processor time, over all its starts, without that of its pictures
  std::string report;          ///< report.json's text once there is one
  ResultFiles results;
};

/// What an owner may keep. 0: as much as there is room for.
struct Quotas {
  std::int64_t bytes = 0;   ///< of uploads, documents and results together
  int unfinished_jobs = 0;  ///< waiting, running or paused
};

/// What an owner keeps.
struct Usage {
  std::int64_t bytes = 0;  ///< as Quotas counts them
  int assets = 0, projects = 0, jobs = 0, unfinished_jobs = 0;
};

/// How a store fares, for whoever runs it.
struct StoreFigures {
  std::map<std::string, std::int64_t> failures;      ///< since it was opened, by code (failures.h)
  std::int64_t disk_bytes = 0, disk_free_bytes = 0;  ///< of the disk that it is on; 0 where it has none
};

/// Something of some owner.
struct OwnedId {
  OwnerId owner;
  std::string id;
  friend bool operator==(const OwnedId&, const OwnedId&) = default;
};

/// A row that was asked for under an idempotency key: made by this call, or there already.
template <typename Row>
struct Made : Row {
  bool anew = true;
};

/// Somebody else has the job by now.
inline Error lease_lost() {
  return {"store.lease_lost", "another worker has taken the job over", "", ErrorKind::kStale};
}

/// Errors of every call: store.full (the disk; reading goes on working), store.busy, store.corrupt,
/// store.failed; of those that name a thing: store.not_found.
class Store {
 public:
  virtual ~Store() = default;

  /// Keeps the bytes under row's kind, name and info; id, size and time are the store's to give. Gives back
  /// the existing asset when this owner has the same content under the same name and kind. Errors:
  /// store.bad_name, quota.bytes.
  virtual Result<AssetRow> put_asset(const RequestContext& context, AssetRow row, std::string_view bytes) = 0;
  virtual Result<AssetRow> asset(const RequestContext& context, const std::string& id) = 0;
  virtual Result<std::string> asset_bytes(const RequestContext& context, const std::string& id) = 0;
  /// Where the bytes lie as a file, for readers that want one: its name ends as the asset's does (in lower
  /// case). Only to read.
  virtual Result<std::string> asset_path(const RequestContext& context, const std::string& id) = 0;
  /// Newest first; of every kind when `kind` is empty.
  virtual Result<std::vector<AssetRow>> assets(const RequestContext& context, const std::string& kind) = 0;
  /// Removes it with its bytes. Error: store.in_use while a project or a job of this owner names it.
  virtual Status remove_asset(const RequestContext& context, const std::string& id) = 0;

  /// Keeps name, document and files; id, revision and times are the store's to give. With an idempotency key
  /// that this owner has used, gives back the project that was made then, as it is now; a removed project has
  /// freed its key. Errors: store.idempotency_mismatch when the key was used for another document or other
  /// files, store.idempotency_key (empty means none; else 1 to 200 printable ASCII characters), quota.bytes.
  virtual Result<Made<ProjectRow>> create_project(const RequestContext& context, ProjectRow row,
                                                  const std::string& idempotency_key = "") = 0;
  /// Replaces document, files and name when the stored revision is `expected` (or expected is 0); its history
  /// is then empty. Errors: store.not_found, store.conflict.
  virtual Result<ProjectRow> replace_project(const RequestContext& context, const ProjectRow& row,
                                             int expected) = 0;
  virtual Result<ProjectRow> project(const RequestContext& context, const std::string& id) = 0;
  /// Newest first, from after `cursor` (an id, or empty), at most `limit` (and 1,000). Error: store.cursor
  /// when the cursor is no id; that of a project that is gone is good.
  virtual Result<std::vector<ProjectRow>> projects(const RequestContext& context, const std::string& cursor,
                                                   int limit) = 0;
  /// Removes it when the stored revision is `expected` (or expected is 0); its jobs stay. Errors:
  /// store.not_found, store.conflict.
  virtual Status remove_project(const RequestContext& context, const std::string& id, int expected) = 0;

  /// Replaces document, name and files when the stored revision is `expected`, together with a step of the
  /// history: kDo forgets what was undone and appends `edit` (number, time and undone are the store's to
  /// give); kUndo and kRedo turn over what edit.number names. A history holds at most 500 steps and 64 MiB,
  /// the newest. Errors: store.not_found (the project; the step), store.conflict.
  virtual Result<ProjectRow> edit_project(const RequestContext& context, const ProjectRow& row, int expected,
                                          EditStep step, const EditRow& edit) = 0;
  /// Steps of the history with numbers below `before` (0: all), newest first, at most `limit` (and 1,000);
  /// without inverse and original.
  virtual Result<std::vector<EditRow>> edits(const RequestContext& context, const std::string& project_id,
                                             std::int64_t before, int limit) = 0;
  /// What kUndo or kRedo would turn over next; nothing when there is nothing.
  virtual Result<std::optional<EditRow>> next_edit(const RequestContext& context,
                                                   const std::string& project_id, EditStep step) = 0;

  /// Keeps the row under a new id; its time is the store's to give. With an idempotency key that this owner
  /// has used, gives back the job it made then. Errors: store.idempotency_mismatch when that was for another
  /// project, store.idempotency_key (as for projects), quota.bytes, quota.jobs.
  virtual Result<Made<JobRow>> create_job(const RequestContext& context, JobRow row,
                                          const std::string& idempotency_key) = 0;
  /// The job that this owner made with the key; nothing when there is none, or the key is empty. Error:
  /// store.idempotency_key.
  virtual Result<std::optional<JobRow>> job_of_key(const RequestContext& context,
                                                   const std::string& idempotency_key) = 0;
  virtual Result<JobRow> job(const RequestContext& context, const std::string& id) = 0;
  /// Newest first, as projects(); without documents (row.document is empty).
  virtual Result<std::vector<JobRow>> jobs(const RequestContext& context, const std::string& cursor,
                                           int limit) = 0;
  /// The newest of this owner that succeeded on the same input; nothing when there is none, or `input` is
  /// empty.
  virtual Result<std::optional<JobRow>> succeeded_job_of_input(const RequestContext& context,
                                                               const std::string& input) = 0;
  /// Those of a project, oldest first, by their ids.
  virtual Result<std::vector<std::string>> jobs_of_project(const RequestContext& context,
                                                           const std::string& project_id) = 0;
  /// Removes a job with its results and its idempotency key. Error: store.in_use while it has not ended.
  virtual Status remove_job(const RequestContext& context, const std::string& id) = 0;
  /// Reads a job, without its document, has `edit` change it, and writes state, reason, notes, verdict,
  /// attempt, suspicion, lease, progress, times, work, input, report and results: in one transaction, so that
  /// of several who change it each sees what the one before has written. Gives back what is kept. An error of
  /// `edit` leaves the job as it is. `edit` must not call the store. Error: store.lease_lost, kind kStale,
  /// when context.lease is not the job's.
  using JobEdit = std::function<Status(JobRow&)>;
  virtual Result<JobRow> change_job(const RequestContext& context, const std::string& id,
                                    const JobEdit& edit) = 0;
  struct OwnedJob {
    OwnerId owner;
    JobRow job;  ///< without its document
  };
  /// All that have not ended, of all owners, the oldest first: what workers look for.
  virtual Result<std::vector<OwnedJob>> unfinished_jobs() = 0;

  /// Under what name this store, for as long as it is open, holds leases.
  virtual std::string holder() const = 0;
  /// A job that nobody works on any more although its row says so.
  struct LeftJob {
    OwnedJob owned;
    int running = 0;           ///< how many that holder had running, this one among them
    std::int64_t kept_ms = 0;  ///< Unix time of its checkpoint; 0: it has none
  };
  /// Gives `judge` each job whose holder is gone (its process is no more), has not been heard of in time, or,
  /// when `own`, is this very store, and each that is running without a holder. Keeps what it makes of them,
  /// as change_job does, and without a holder: in one transaction, so that where several look one alone
  /// judges. Gives back what is kept.
  using JudgeJob = std::function<void(LeftJob&)>;
  virtual Result<std::vector<OwnedJob>> take_from_the_gone(std::int64_t now_ms, bool own,
                                                           const JudgeJob& judge) = 0;
  /// Another value whenever another process has changed something.
  virtual std::int64_t changes_by_others() = 0;

  /// Jobs that ended before then, the oldest first, at most `limit`: what retention looks for.
  virtual Result<std::vector<OwnedId>> jobs_ended_before(std::int64_t unix_ms, int limit) = 0;
  /// Uploads from before then that no project and no job of their owner names.
  virtual Result<std::vector<OwnedId>> unused_assets(std::int64_t before_ms) = 0;
  virtual Result<Usage> usage(const RequestContext& context) = 0;

  /// Result files of a job. A name stands for a file of that job's own folder: no slash, no leading dot, no
  /// control character (store.bad_name). Writing one again replaces it. row.results is change_job's to write.
  /// Under a lease (context.lease) that is not the job's any more, or of a job that has ended, nothing is
  /// put, neither here nor as a checkpoint: store.lease_lost.
  virtual Status put_result(const RequestContext& context, const std::string& job_id, const std::string& name,
                            std::string_view bytes) = 0;
  /// Of a result that its row names with a hash, only what has it. Error: store.corrupt when the disk has
  /// something else.
  virtual Result<std::string> result_bytes(const RequestContext& context, const std::string& job_id,
                                           const std::string& name) = 0;
  /// Where a result lies as a file. Only to read. Errors: as result_bytes.
  virtual Result<std::string> result_path(const RequestContext& context, const std::string& job_id,
                                          const std::string& name) = 0;
  /// Gives `to` the result files that the row of `from` names, as they are: both are this owner's. Errors:
  /// store.corrupt when the disk has something else than the row says.
  virtual Status share_results(const RequestContext& context, const std::string& from,
                               const std::string& to) = 0;
  /// Removes all result files of a job. Nothing to remove is no error.
  virtual Status remove_results(const RequestContext& context, const std::string& job_id) = 0;

  /// The state that an unfinished job goes on from after a stop or a crash. Putting one replaces the one
  /// before; one that its job has left behind goes when the store is opened.
  struct KeptCheckpoint {
    std::string bytes;
    std::int64_t kept_ms = 0;  ///< Unix time
  };
  virtual Status put_checkpoint(const RequestContext& context, const std::string& job_id,
                                std::string_view bytes) = 0;
  virtual Result<KeptCheckpoint> checkpoint(const RequestContext& context, const std::string& job_id) = 0;
  /// Nothing to remove is no error.
  virtual Status remove_checkpoint(const RequestContext& context, const std::string& job_id) = 0;

  /// What the server remembers for an owner, by key; nothing when it was never put.
  virtual Result<std::optional<std::string>> get_setting(const RequestContext& context,
                                                         const std::string& key) = 0;
  virtual Status put_setting(const RequestContext& context, const std::string& key,
                             const std::string& value) = 0;

  /// A folder for files that live no longer than a call; what a crash leaves there, the next start removes.
  virtual std::string scratch_folder() const = 0;

  /// Where each job's log lies under its id: whoever writes them (server/log) needs no word of the store.
  virtual std::string log_folder() const = 0;
  /// What was written there of a job; empty when there is none.
  virtual Result<std::string> job_log(const RequestContext& context, const std::string& job_id) = 0;

  virtual StoreFigures figures() const = 0;

  /// Proof that the store takes and gives, for /readyz: writes a little and reads it back.
  virtual Status ping() = 0;

  /// Who may come in; null in a store that keeps nobody. It lives as long as the store.
  virtual Accounts* accounts() { return nullptr; }
  /// By which jobs are shown to others; null in a store that keeps none. They live as long as the store.
  virtual Links* links() { return nullptr; }
};

}  // namespace toile::store
