#include "tests/bench/service/figure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "core/base/text.h"

namespace toile::bench {
namespace {

std::string asked_text(const Figure& figure) {
  if (figure.asked == Asked::kNothing) return "";
  return (figure.asked == Asked::kAtMost ? "<= " : ">= ") + fixed_text(figure.mark, 2);
}

std::string holds_text(const Figure& figure) {
  if (figure.asked == Asked::kNothing) return "";
  return figure.holds() ? "yes" : "no";
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

std::string table_line(const Figure& figure) {
  const std::string what = figure.note.empty() ? figure.what : figure.what + " (" + figure.note + ")";
  return "| " + figure.gate + " | " + what + " | " + fixed_text(figure.value, 3) + " " + figure.unit + " | " +
         asked_text(figure) + " | " + holds_text(figure) + " | " + fixed_text(figure.load, 1) + " |\n";
}

std::string csv_line(const Figure& figure) {
  const char* kind = figure.asked == Asked::kAtMost ? "at most" : "at least";
  const bool asked = figure.asked != Asked::kNothing;
  return figure.gate + "," + quoted(figure.what) + "," + fixed_text(figure.value, 4) + "," + figure.unit +
         "," + (asked ? kind : "") + "," + (asked ? fixed_text(figure.mark, 3) : "") + "," +
         holds_text(figure) + "," + fixed_text(figure.load, 2) + "," + quoted(figure.note) + "\n";
}

double load_average() {
  double minute = 0;
  return getloadavg(&minute, 1) == 1 ? minute : 0;
}

double percentile(std::vector<double> samples, double share) {
  if (samples.empty()) return 0;
  std::sort(samples.begin(), samples.end());
  const double rank = std::ceil(share * static_cast<double>(samples.size()));
  const auto place = static_cast<std::size_t>(std::max(1.0, rank)) - 1;
  return samples[std::min(place, samples.size() - 1)];
}

double jain_index(const std::vector<double>& samples) {
  double sum = 0, squares = 0;
  for (const double sample : samples) {
    sum += sample;
    squares += sample * sample;
  }
  return squares > 0 ? sum * sum / (static_cast<double>(samples.size()) * squares) : 0;
}

double slope(const std::vector<double>& x, const std::vector<double>& y) {
  const auto count = static_cast<double>(x.size());
  if (x.size() < 2) return 0;
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / count;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / count;
  double both = 0, square = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    both += (x[i] - mean_x) * (y[i] - mean_y);
    square += (x[i] - mean_x) * (x[i] - mean_x);
  }
  return square > 0 ? both / square : 0;
}

}  // namespace toile::bench
