#include "server/http/metrics.h"

#include <unistd.h>

#include <fstream>

#include <string_view>

#include "core/base/text.h"

namespace toile::http {
namespace {

using jobs::Histogram;

/// Methods that count by their own name; whatever else a stranger sends counts as "other".
std::string known_method(const std::string& method) {
  for (const char* known : {"GET", "HEAD", "POST", "PUT", "DELETE"}) {
    if (method == known) return method;
  }
  return "other";
}

std::string number(double value) { return significant_text(value, 9); }

void head(std::string& out, const char* name, const char* type, const char* help) {
  out += std::string("# HELP ") + name + " " + help + "\n# TYPE " + name + " " + type + "\n";
}

void single(std::string& out, const char* name, const char* type, const char* help, double value) {
  head(out, name, type, help);
  out += std::string(name) + " " + number(value) + "\n";
}

/// Of this process, from the kernel.
double resident_bytes() {
  std::ifstream in("/proc/self/statm");
  double total = 0, resident = 0;
  in >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// A line of a family whose members are told apart by one word. Codes and words of ours need no escapes.
void labelled(std::string& out, const char* name, const char* label, std::string_view word, double value) {
  out += std::string(name) + "{" + label + "=\"" + std::string(word) + "\"} " + number(value) + "\n";
}

template <typename Counts>
void family(std::string& out, const char* name, const char* help, const char* label, const Counts& counts) {
  head(out, name, "counter", help);
  for (const auto& [word, count] : counts) labelled(out, name, label, word, static_cast<double>(count));
}

void histogram(std::string& out, const std::string& name, const char* help, const Histogram& times) {
  head(out, name.c_str(), "histogram", help);
  const std::string bucket = name + "_bucket";
  for (std::size_t i = 0; i < Histogram::kBounds.size(); ++i) {
    labelled(out, bucket.c_str(), "le", number(Histogram::kBounds[i]), static_cast<double>(times.up_to(i)));
  }
  labelled(out, bucket.c_str(), "le", "+Inf", static_cast<double>(times.count()));
  out += name + "_sum " + number(times.sum()) + "\n";
  out += name + "_count " + number(static_cast<double>(times.count())) + "\n";
}

void tell_jobs(std::string& out, const jobs::JobService::Counts& jobs) {
  head(out, "toile_jobs", "gauge", "Drapes by state.");
  labelled(out, "toile_jobs", "state", "queued", jobs.queued);
  labelled(out, "toile_jobs", "state", "running", jobs.running);
  labelled(out, "toile_jobs", "state", "paused", jobs.paused);
  single(out, "toile_jobs_in_memory", "gauge", "Drapes that are begun and not put aside.", jobs.in_memory);
  const std::map<std::string, long long> ended{
      {"succeeded", jobs.succeeded}, {"failed", jobs.failed}, {"cancelled", jobs.cancelled}};
  family(out, "toile_jobs_ended_total", "Drapes that have ended since the start.", "state", ended);
  single(out, "toile_jobs_answered_total", "counter",
         "Of those, drapes that an equal one of before answered.", static_cast<double>(jobs.answered));
  single(out, "toile_queue_age_seconds", "gauge", "How long the drape has waited that waits longest.",
         jobs.oldest_queued_s);
  histogram(out, "toile_job_wait_seconds", "From a drape's submission to its beginning.", jobs.wait);
  histogram(out, "toile_job_run_seconds", "From a drape's beginning to its end.", jobs.run);
  single(out, "toile_steps_total", "counter", "Substeps of all drapes since the start.",
         static_cast<double>(jobs.steps));
  family(out, "toile_work_seconds_total",
         "Processor time of drapes by phase; of their pictures, time by the clock.", "phase", jobs.work_s);
}

void tell_store(std::string& out, const store::StoreFigures& store) {
  family(out, "toile_store_failures_total", "Calls that disk or database failed.", "code", store.failures);
  single(out, "toile_disk_bytes", "gauge", "Of the disk that the data lie on.",
         static_cast<double>(store.disk_bytes));
  single(out, "toile_disk_free_bytes", "gauge", "Of that, what is free for the service.",
         static_cast<double>(store.disk_free_bytes));
}

void tell_readers(std::string& out, const ReaderFigures& readers) {
  head(out, "toile_mesh_readers_total", "counter", "Processes that read mesh files, and how they ended.");
  labelled(out, "toile_mesh_readers_total", "end", "crashed", static_cast<double>(readers.crashed));
  labelled(out, "toile_mesh_readers_total", "end", "too_costly", static_cast<double>(readers.refused));
  labelled(out, "toile_mesh_readers_total", "end", "done",
           static_cast<double>(readers.started - readers.crashed - readers.refused));
}

void tell_certificate(std::string& out, const CertificateFigures& certificate) {
  if (certificate.expires_s == 0) return;  // no TLS
  single(out, "toile_certificate_expires_seconds", "gauge", "Unix time until which the certificate is good.",
         static_cast<double>(certificate.expires_s));
  head(out, "toile_certificate_reads_total", "counter", "Renewed certificates, and what came of them.");
  labelled(out, "toile_certificate_reads_total", "end", "taken", static_cast<double>(certificate.renewed));
  labelled(out, "toile_certificate_reads_total", "end", "refused", static_cast<double>(certificate.refused));
}

}  // namespace

void Metrics::count_request(const std::string& method, int status, const std::string& code, double seconds) {
  const std::lock_guard lock(mutex_);
  ++requests_[{known_method(method), status}];
  if (!code.empty()) ++problems_[code];
  seconds_ += seconds;
}

std::string Metrics::text(const ServiceFigures& service) const {
  std::string out;
  head(out, "toile_build_info", "gauge", "1, with the version that runs.");
  labelled(out, "toile_build_info", "version", TOILE_VERSION, 1);
  tell_jobs(out, service.jobs);
  tell_store(out, service.store);
  tell_readers(out, service.readers);
  tell_certificate(out, certificate);
  single(out, "toile_viewers", "gauge", "Open streams.", static_cast<double>(service.viewers));
  single(out, "toile_connections", "gauge", "Open connections.", connections.load());
  single(out, "process_resident_memory_bytes", "gauge", "Resident memory.", resident_bytes());
  const std::lock_guard lock(mutex_);
  head(out, "toile_http_requests_total", "counter", "Answered requests.");
  for (const auto& [key, count] : requests_) {
    out += "toile_http_requests_total{method=\"" + key.first + "\",status=\"" + std::to_string(key.second) +
           "\"} " + number(static_cast<double>(count)) + "\n";
  }
  family(out, "toile_http_problems_total", "Requests that were refused or failed.", "code", problems_);
  single(out, "toile_http_request_seconds_total", "counter", "Time from a request's header to its answer.",
         seconds_);
  return out;
}

}  // namespace toile::http
