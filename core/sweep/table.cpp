#include "core/sweep/table.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

#include "core/base/text.h"

namespace toile::sweep {
namespace {

using json::JsonValue;

double number_at(const JsonValue* in, std::string_view key) {
  const JsonValue* value = in ? in->find(key) : nullptr;
  return value && value->number() ? *value->number() : 0;
}

int count_at(const JsonValue* in, std::string_view key) { return static_cast<int>(number_at(in, key)); }

std::string text_at(const JsonValue& in, std::string_view key) {
  const JsonValue* value = in.find(key);
  return value && value->text() ? *value->text() : std::string();
}

/// The most of the girth's places that tells of trouble: a report may have several of one name.
std::optional<Ease> ease_at(const JsonValue& report, std::string_view at) {
  const JsonValue* fit = report.find("fit");
  std::optional<Ease> found;
  if (!fit || !fit->array()) return found;
  for (const JsonValue& girth : *fit->array()) {
    if (text_at(girth, "at") != at) continue;
    const Ease here{text_at(girth, "fit"), number_at(&girth, "ease_mm")};
    if (!found || here.ease_mm < found->ease_mm) found = here;
  }
  return found;
}

bool is_true(const JsonValue& in, std::string_view key) {
  const JsonValue* value = in.find(key);
  return value && value->boolean() && *value->boolean();
}

double tension_p99(const JsonValue* strain, std::string_view direction) {
  const JsonValue* figures = strain ? strain->find(direction) : nullptr;
  return number_at(figures ? figures->find("tension") : nullptr, "p99");
}

/// A field as RFC 4180 has it: in quotes where it must be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

JsonValue ease_json(const std::optional<Ease>& ease) {
  if (!ease) return {};
  return std::vector<json::JsonMember>{{"fit", ease->fit}, {"ease_mm", ease->ease_mm}};
}

JsonValue figures_json(const std::optional<Figures>& f) {
  if (!f) return {};
  return std::vector<json::JsonMember>{{"settled", f->settled},
                                       {"stop_reason", f->stop_reason},
                                       {"worn", f->worn.empty() ? JsonValue() : JsonValue(f->worn)},
                                       {"bust", ease_json(f->bust)},
                                       {"waist", ease_json(f->waist)},
                                       {"hip", ease_json(f->hip)},
                                       {"warp_p99", f->warp_p99},
                                       {"weft_p99", f->weft_p99},
                                       {"shear_p99", f->shear_p99},
                                       {"cloth_body", double(f->cloth_body)},
                                       {"cloth_cloth", double(f->cloth_cloth)},
                                       {"worst_body", double(f->worst_body)},
                                       {"worst_cloth", double(f->worst_cloth)},
                                       {"open_seams", double(f->open_seams)},
                                       {"cpu_s", f->cpu_s},
                                       {"simulated_s", f->simulated_s},
                                       {"particles", double(f->particles)},
                                       {"hash", f->hash}};
}

std::optional<Ease> ease_from(const JsonValue& figures, std::string_view at) {
  const JsonValue* given = figures.find(at);
  if (!given || !given->object()) return std::nullopt;
  return Ease{text_at(*given, "fit"), number_at(given, "ease_mm")};
}

/// Of what figures_json() has written.
Figures figures_from(const JsonValue& given) {
  Figures f;
  f.settled = is_true(given, "settled");
  f.stop_reason = text_at(given, "stop_reason");
  f.worn = text_at(given, "worn");
  f.bust = ease_from(given, "bust");
  f.waist = ease_from(given, "waist");
  f.hip = ease_from(given, "hip");
  f.warp_p99 = number_at(&given, "warp_p99");
  f.weft_p99 = number_at(&given, "weft_p99");
  f.shear_p99 = number_at(&given, "shear_p99");
  f.cloth_body = count_at(&given, "cloth_body");
  f.cloth_cloth = count_at(&given, "cloth_cloth");
  f.worst_body = count_at(&given, "worst_body");
  f.worst_cloth = count_at(&given, "worst_cloth");
  f.open_seams = count_at(&given, "open_seams");
  f.cpu_s = number_at(&given, "cpu_s");
  f.simulated_s = number_at(&given, "simulated_s");
  f.particles = count_at(&given, "particles");
  f.hash = text_at(given, "hash");
  return f;
}

constexpr const char* kColumnNames =
    "body,fabric,state,reason_code,worn,settled,bust_fit,bust_ease_mm,waist_fit,waist_ease_mm,hip_fit,"
    "hip_ease_mm,warp_p99_percent,weft_p99_percent,shear_p99_deg,cloth_body,cloth_cloth,worst_body,"
    "worst_cloth,open_seams,cpu_s,simulated_s,particles,hash,job\r\n";

using Fields = std::vector<std::string>;

void add_ease(Fields& fields, const std::optional<Ease>& ease) {
  fields.push_back(ease ? ease->fit : "");
  fields.push_back(ease ? fixed_text(ease->ease_mm, 1) : "");
}

void add_figures(Fields& fields, const Figures& f) {
  fields.insert(fields.end(), {f.worn, f.settled ? "yes" : "no"});
  for (const std::optional<Ease>& ease : {f.bust, f.waist, f.hip}) add_ease(fields, ease);
  for (const double ratio : {f.warp_p99, f.weft_p99}) fields.push_back(fixed_text(100 * ratio, 2));
  fields.push_back(fixed_text(f.shear_p99 * 180 / std::numbers::pi, 2));
  for (const int count : {f.cloth_body, f.cloth_cloth, f.worst_body, f.worst_cloth, f.open_seams})
    fields.push_back(std::to_string(count));
  fields.insert(fields.end(),
                {fixed_text(f.cpu_s, 2), fixed_text(f.simulated_s, 2), std::to_string(f.particles), f.hash});
}

std::string line_of(const Fields& fields) {
  std::string line;
  for (const std::string& one : fields)
    line += (line.empty() && &one == &fields.front() ? "" : ",") + field(one);
  return line + "\r\n";
}

}  // namespace

std::optional<Figures> figures_of(const JsonValue& report) {
  const JsonValue* settled = report.find("settled");
  if (!settled || !settled->boolean()) return std::nullopt;
  Figures f;
  f.settled = *settled->boolean();
  f.stop_reason = text_at(report, "stop_reason");
  f.worn = text_at(report, "worn");
  f.bust = ease_at(report, "bust");
  f.waist = ease_at(report, "waist");
  f.hip = ease_at(report, "hip");
  const JsonValue* strain = report.find("strain");
  f.warp_p99 = tension_p99(strain, "warp");
  f.weft_p99 = tension_p99(strain, "weft");
  f.shear_p99 = number_at(strain ? strain->find("shear") : nullptr, "p99");
  const JsonValue* crossings = report.find("intersections");
  f.cloth_body = count_at(crossings, "cloth_body");
  f.cloth_cloth = count_at(crossings, "cloth_cloth");
  const JsonValue* worst = crossings ? crossings->find("worst_frame") : nullptr;
  f.worst_body = count_at(worst, "cloth_body");
  f.worst_cloth = count_at(worst, "cloth_cloth");
  const JsonValue* open = report.find("open_seams");
  f.open_seams = open && open->array() ? static_cast<int>(open->array()->size()) : 0;
  f.cpu_s = number_at(&report, "cpu_s");
  f.simulated_s = number_at(&report, "simulated_s");
  f.particles = count_at(&report, "particles");
  f.hash = text_at(report, "hash");
  return f;
}

JsonValue cell_json(const Table& table, std::size_t body, std::size_t fabric) {
  const Cell& cell = table.at(body, fabric);
  return std::vector<json::JsonMember>{{"body", table.bodies[body]},
                                       {"fabric", table.fabrics[fabric]},
                                       {"job", cell.job.empty() ? JsonValue() : JsonValue(cell.job)},
                                       {"state", cell.state},
                                       {"reason_code", cell.reason_code},
                                       {"reason", cell.reason},
                                       {"fraction", cell.fraction},
                                       {"pictured", cell.pictured},
                                       {"figures", figures_json(cell.figures)}};
}

Cell cell_from(const JsonValue& given) {
  Cell cell;
  cell.job = text_at(given, "job");
  cell.state = text_at(given, "state");
  cell.reason_code = text_at(given, "reason_code");
  cell.reason = text_at(given, "reason");
  cell.fraction = number_at(&given, "fraction");
  cell.pictured = is_true(given, "pictured");
  if (const JsonValue* figures = given.find("figures"); figures && figures->object())
    cell.figures = figures_from(*figures);
  return cell;
}

std::string table_csv(const Table& table) {
  constexpr std::size_t kOfFigures = 20;
  std::string csv = kColumnNames;
  for (std::size_t body = 0; body < table.bodies.size(); ++body) {
    for (std::size_t fabric = 0; fabric < table.fabrics.size(); ++fabric) {
      const Cell& cell = table.at(body, fabric);
      Fields fields{table.bodies[body], table.fabrics[fabric], cell.state, cell.reason_code};
      if (cell.figures) {
        add_figures(fields, *cell.figures);
      } else {
        fields.resize(fields.size() + kOfFigures);
      }
      fields.push_back(cell.job);
      csv += line_of(fields);
    }
  }
  return csv;
}

Counts counts_of(const Table& table) {
  Counts counts;
  const std::pair<std::string_view, int*> words[] = {
      {"queued", &counts.queued},       {"running", &counts.running}, {"paused", &counts.paused},
      {"succeeded", &counts.succeeded}, {"failed", &counts.failed},   {"cancelled", &counts.cancelled},
      {"removed", &counts.removed}};
  for (const Cell& cell : table.cells) {
    for (const auto& [word, count] : words) *count += cell.state == word;
    counts.fraction += cell.fraction / static_cast<double>(table.cells.size());
  }
  counts.fraction = std::min(counts.fraction, 1.0);
  return counts;
}

}  // namespace toile::sweep
