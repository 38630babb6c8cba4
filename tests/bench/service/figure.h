#pragma once
// What a gate of the service measured, beside what is asked.

#include <string>
#include <vector>

namespace toile::bench {

enum class Asked { kAtMost, kAtLeast, kNothing };

struct Figure {
  std::string gate;  ///< "submit", …
  std::string what;  ///< in words
  double value = 0;
  std::string unit;
  Asked asked = Asked::kNothing;
  double mark = 0;   ///< that is asked
  double load = 0;   ///< average of the machine's last minute when the gate ended, without a unit
  std::string note;  ///< what else belongs to it

  bool holds() const {
    return asked == Asked::kNothing || (asked == Asked::kAtMost ? value <= mark : value >= mark);
  }
};

using Figures = std::vector<Figure>;

/// A line of a table in Markdown, and of a CSV file whose columns are kCsvHead.
std::string table_line(const Figure& figure);
std::string csv_line(const Figure& figure);
inline constexpr const char* kTableHead =
    "| gate | measured | figure | asked | holds | load |\n|---|---|---|---|---|---|\n";
inline constexpr const char* kCsvHead = "gate,what,value,unit,asked,mark,holds,load,note\n";

/// Of the machine over the last minute.
double load_average();

/// The smallest value that `share` of the samples do not exceed (nearest rank); 0 of none.
double percentile(std::vector<double> samples, double share);
/// 1 when all are the same, 1/n when one has all (Jain, Chiu, Hawe 1984).
double jain_index(const std::vector<double>& samples);
/// Slope of the line of least squares through (x, y).
double slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace toile::bench
