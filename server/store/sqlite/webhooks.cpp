// Webhooks of the store, and their deliveries, which the database's own triggers write (migrations.cpp).

#include "server/store/webhooks.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "server/store/now.h"
#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {
namespace {

constexpr const char* kDeliveryColumns =
    "d.number, d.owner, d.webhook, d.event, d.at_ms, d.job, d.project_id, d.name, d.state, d.reason_code,"
    " d.outcome, d.attempts, d.next_ms, d.status, d.error, d.sweep";
constexpr int kDeliveryColumnCount = 16;

/// Words with commas between them, as a column has them.
std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

std::vector<std::string> parted(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    if (end > at) words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

Result<store::WebhookRow> webhook_from(const SqlStatement& row) {
  return store::WebhookRow{row.text(0),         row.text(1), row.text(2),   row.text(3),
                           parted(row.text(4)), row.text(5), row.integer(6)};
}

Result<store::Outcome> outcome_from(const std::string& word) {
  for (const store::Outcome outcome :
       {store::Outcome::kWaiting, store::Outcome::kDelivered, store::Outcome::kGivenUp})
    if (word == store::word_of(outcome)) return outcome;
  return Error{"store.corrupt", "a delivery has an outcome that there is not", word, ErrorKind::kSystem};
}

Result<store::DeliveryRow> delivery_from(const SqlStatement& row) {
  store::DeliveryRow delivery;
  delivery.number = row.integer(0);
  delivery.owner = row.text(1);
  delivery.webhook = row.text(2);
  delivery.event = {row.integer(3), row.integer(4), row.text(5), row.text(6),
                    row.text(7),    row.text(8),    row.text(9), row.text(15)};
  delivery.outcome = TRY(outcome_from(row.text(10)));
  delivery.attempts = static_cast<int>(row.integer(11));
  delivery.next_ms = row.integer(12);
  delivery.status = static_cast<int>(row.integer(13));
  delivery.error = row.text(14);
  return delivery;
}

Result<store::DueDelivery> due_from(const SqlStatement& row) {
  const store::DeliveryRow delivery = TRY(delivery_from(row));
  return store::DueDelivery{delivery, row.text(kDeliveryColumnCount), row.text(kDeliveryColumnCount + 1)};
}

}  // namespace

Result<store::WebhookRow> SqliteStore::add_webhook(store::WebhookRow row) {
  const std::lock_guard hold(mutex_);
  row.created_ms = store::now_ms();
  row.id = TRY(ids_.next('w', row.created_ms));
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  const std::int64_t there =
      TRY(row_of(database_.prepare("SELECT count(*) FROM webhooks WHERE owner = ?", {row.owner}), count_from,
                 "webhook", ""));
  if (there >= kMost) {
    return Error{"webhooks.too_many",
                 "there are " + std::to_string(kMost) + " webhooks already; remove one that is not needed",
                 "", ErrorKind::kConflict};
  }
  TRY(
      database_.run("INSERT INTO webhooks (owner, id, url, secret, states, label, created_ms)"
                    " VALUES (?, ?, ?, ?, ?, ?, ?)",
                    {row.owner, row.id, row.url, row.secret, joined(row.states), row.label, row.created_ms}));
  TRY(transaction.commit());
  return row;
}

Result<std::vector<store::WebhookRow>> SqliteStore::webhooks(const store::OwnerId& owner) {
  const std::lock_guard hold(mutex_);
  return rows_of(database_.prepare("SELECT id, owner, url, secret, states, label, created_ms FROM webhooks"
                                   " WHERE owner = ? ORDER BY id DESC",
                                   {owner}),
                 webhook_from);
}

Status SqliteStore::remove_webhook(const store::OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  const int gone = TRY(database_.run("DELETE FROM webhooks WHERE owner = ? AND id = ?", {owner, id}));
  if (gone == 0) return not_found("webhook", id);
  TRY(database_.run("DELETE FROM deliveries WHERE owner = ? AND webhook = ?", {owner, id}));
  return transaction.commit();
}

Status SqliteStore::ping_webhook(const store::OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  const int made = TRY(database_.run(
      "INSERT INTO deliveries (owner, webhook, event, at_ms, job, project_id, name, state, reason_code)"
      " SELECT owner, id, 0, ?, '', '', '', ?, '' FROM webhooks WHERE owner = ? AND id = ?",
      {store::now_ms(), std::string_view(store::kPing), owner, id}));
  return made > 0 ? Status() : Status(not_found("webhook", id));
}

Result<std::vector<store::DeliveryRow>> SqliteStore::deliveries(const store::OwnerId& owner,
                                                                const std::string& id, int limit) {
  const std::lock_guard hold(mutex_);
  TRY(row_of(database_.prepare("SELECT id FROM webhooks WHERE owner = ? AND id = ?", {owner, id}), text_from,
             "webhook", id));
  return rows_of(database_.prepare(select(kDeliveryColumns,
                                          "FROM deliveries d WHERE d.owner = ? AND d.webhook = ?"
                                          " ORDER BY d.number DESC LIMIT ?"),
                                   {owner, id, std::int64_t{limit}}),
                 delivery_from);
}

Result<std::vector<store::DueDelivery>> SqliteStore::due_deliveries(std::int64_t now_ms) {
  const std::lock_guard hold(mutex_);
  const std::string sql = std::string("SELECT ") + kDeliveryColumns +
                          ", w.url, w.secret FROM deliveries d"
                          " JOIN webhooks w ON w.owner = d.owner AND w.id = d.webhook"
                          " WHERE d.number IN (SELECT min(number) FROM deliveries"
                          " WHERE outcome = 'waiting' AND next_ms <= ? GROUP BY owner)"
                          " AND NOT EXISTS (SELECT 1 FROM accounts a WHERE a.id = d.owner AND a.locked <> 0)"
                          " ORDER BY d.next_ms";
  return rows_of(database_.prepare(sql, {now_ms}), due_from);
}

Status SqliteStore::change_delivery(const store::DeliveryRow& row) {
  const std::lock_guard hold(mutex_);
  TRY(
      database_.run("UPDATE deliveries SET outcome = ?, attempts = ?, next_ms = ?, status = ?, error = ?"
                    " WHERE number = ?",
                    {store::word_of(row.outcome), std::int64_t{row.attempts}, row.next_ms,
                     std::int64_t{row.status}, row.error, row.number}));
  return {};
}

}  // namespace toile::sqlite
