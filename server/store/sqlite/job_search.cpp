// Jobs found by what they are, and their tags.

#include "server/store/job_search.h"

#include <cstdint>
#include <utility>

#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {
namespace {

constexpr const char* kThatFit =
    "FROM jobs WHERE owner = ? AND id < ?"
    " AND (? = '' OR instr(?, ',' || state || ',') > 0) AND (? = '' OR project_id = ?)"
    " AND (? = '' OR EXISTS (SELECT 1 FROM tags WHERE tags.owner = jobs.owner AND tags.job = jobs.id AND"
    " tags.tag = ?))"
    " AND (? = '' OR sweep = ?)"
    " AND created_ms >= ? AND (? = 0 OR created_ms < ?) ORDER BY id DESC LIMIT ?";

/// ",queued,running,"; empty for any.
std::string words_of(const std::vector<store::JobState>& states) {
  std::string words;
  for (const store::JobState state : states) words.append(",").append(store::name_of(state));
  return words.empty() ? words : words + ",";
}

struct TagOfJob {
  std::string job, tag;
};

Result<TagOfJob> tag_from(const SqlStatement& row) { return TagOfJob{row.text(0), row.text(1)}; }

}  // namespace

Result<std::vector<store::JobRow>> SqliteStore::find_jobs(const store::RequestContext& context,
                                                          const store::JobQuery& query,
                                                          const std::string& cursor, int limit) {
  const std::string before = TRY(before_what(cursor, 'j'));
  const std::string states = words_of(query.states);
  const std::string of_sweep = query.sweep == store::JobQuery::kAlone ? "" : query.sweep;
  const std::lock_guard hold(mutex_);
  return readable_rows_of(
      database_.prepare(
          select(kJobListColumns, kThatFit),
          {context.owner, before, states, states, query.project_id, query.project_id, query.tag, query.tag,
           query.sweep, of_sweep, query.since_ms, query.until_ms, query.until_ms, page_limit(limit)}),
      job_from, context.log);
}

Status SqliteStore::set_tags(const store::RequestContext& context, const std::string& job,
                             const store::Tags& tags) {
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  TRY(row_of(database_.prepare("SELECT id FROM jobs WHERE owner = ? AND id = ?", {context.owner, job}),
             text_from, "job", job));
  TRY(database_.run("DELETE FROM tags WHERE owner = ? AND job = ?", {context.owner, job}));
  TRY(insert_tags(context.owner, job, tags));
  return transaction.commit();
}

/// REQUIRES mutex_.
Status SqliteStore::insert_tags(const store::OwnerId& owner, const std::string& job,
                                const store::Tags& tags) {
  for (const std::string& tag : tags) {
    TRY(database_.run("INSERT OR IGNORE INTO tags (owner, job, tag) VALUES (?, ?, ?)", {owner, job, tag}));
  }
  return {};
}

Result<std::map<std::string, store::Tags>> SqliteStore::tags_of_jobs(const store::OwnerId& owner,
                                                                     const std::string& first,
                                                                     const std::string& last) {
  const std::lock_guard hold(mutex_);
  std::vector<TagOfJob> rows =
      TRY(rows_of(database_.prepare(
                      "SELECT job, tag FROM tags WHERE owner = ? AND job >= ? AND job <= ? ORDER BY job, tag",
                      {owner, first, last}),
                  tag_from));
  std::map<std::string, store::Tags> tags;
  for (TagOfJob& row : rows) tags[row.job].push_back(std::move(row.tag));
  return tags;
}

}  // namespace toile::sqlite
