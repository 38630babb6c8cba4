#include "server/http/metrics.h"

#include <unistd.h>

#include <fstream>

#include "core/base/text.h"

namespace toile::http {
namespace {

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

}  // namespace

void Metrics::count_request(const std::string& method, int status, double seconds) {
  const std::lock_guard lock(mutex_);
  ++requests_[{known_method(method), status}];
  seconds_ += seconds;
}

std::string Metrics::text(const jobs::JobService::Counts& jobs, std::size_t viewers) const {
  std::string out;
  head(out, "toile_jobs", "gauge", "Drapes by state.");
  out += "toile_jobs{state=\"queued\"} " + number(jobs.queued) + "\n";
  out += "toile_jobs{state=\"running\"} " + number(jobs.running) + "\n";
  out += "toile_jobs{state=\"paused\"} " + number(jobs.paused) + "\n";
  head(out, "toile_jobs_ended_total", "counter", "Drapes that have ended since the start.");
  out += "toile_jobs_ended_total{state=\"succeeded\"} " + number(static_cast<double>(jobs.succeeded)) + "\n";
  out += "toile_jobs_ended_total{state=\"failed\"} " + number(static_cast<double>(jobs.failed)) + "\n";
  out += "toile_jobs_ended_total{state=\"cancelled\"} " + number(static_cast<double>(jobs.cancelled)) + "\n";
  single(out, "toile_steps_total", "counter", "Substeps of all drapes since the start.",
         static_cast<double>(jobs.steps));
  single(out, "toile_viewers", "gauge", "Open streams.", static_cast<double>(viewers));
  single(out, "toile_connections", "gauge", "Open connections.", connections.load());
  single(out, "process_resident_memory_bytes", "gauge", "Resident memory.", resident_bytes());
  head(out, "toile_http_requests_total", "counter", "Answered requests.");
  const std::lock_guard lock(mutex_);
  for (const auto& [key, count] : requests_) {
    out += "toile_http_requests_total{method=\"" + key.first + "\",status=\"" + std::to_string(key.second) +
           "\"} " + number(static_cast<double>(count)) + "\n";
  }
  single(out, "toile_http_request_seconds_total", "counter", "Time from a request's header to its answer.",
         seconds_);
  return out;
}

}  // namespace toile::http
