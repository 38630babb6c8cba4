#include "core/exports/write_report.h"

#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/base/units.h"
#include "core/base/write_file.h"
#include "core/exports/report_fields.h"

namespace toile::exports {
namespace {

using Json = nlohmann::ordered_json;

ReportFigures figures_of(const analysis::StrainFigures& f) { return {f.mean, f.p99, f.max}; }

ReportStretch stretch_of(const analysis::StretchFigures& f) {
  return {figures_of(f), figures_of(f.tension), figures_of(f.compression)};
}

ReportFinding finding_of(const preflight::Finding& f) {
  std::vector<ReportConcern> about;
  for (const preflight::Concern& c : f.about) about.push_back({preflight::name_of(c.thing), {c.id}});
  return {.code = {std::string(preflight::code_of(f.kind))},
          .severity = preflight::name_of(f.severity),
          .message = {f.message},
          .where = {preflight::where_text(f)},
          .about = std::move(about),
          .place = {f.place.x, f.place.y, f.place.z},
          .repaired = f.repaired};
}

ReportAttachment attachment_of(const analysis::AttachmentFigures& a) {
  ReportAttachment out{{a.id}, a.released, a.off_mm, {}};
  if (a.released) out.released_s = a.released_s;
  return out;
}

ReportFit fit_of(const analysis::FitLine& line) {
  ReportFit out;
  out.at = {line.place};
  out.fit = analysis::word_of(line.fit);
  out.text = {analysis::fit_text(line)};
  out.body_mm = mm_from_metres(line.body);
  out.garment_mm = mm_from_metres(line.garment);
  out.ease_mm = mm_from_metres(line.ease());
  out.worn_mm = mm_from_metres(line.worn);
  out.tight_by_mm = mm_from_metres(line.tight_by);
  out.shifted_mm = mm_from_metres(line.shifted);
  for (const std::string& piece : line.pieces) out.pieces.push_back({piece});
  out.place = {line.at.x, line.at.y, line.at.z};
  return out;
}

ReportDocument document_of(const analysis::Report& r) {
  ReportDocument out;
  out.name = {r.name};
  out.settled = r.settled();
  out.stop_reason = {drape::to_string(r.stop_reason)};
  out.cpu_s = r.cpu_s;
  out.wall_s = r.wall_s;
  out.resumed = r.resumed;
  out.steps = r.steps;
  out.simulated_s = r.simulated_s;
  out.particles = r.particles;
  out.sewn_particles = r.sewn_particles;
  out.triangles = r.triangles;
  out.body_triangles = r.body_triangles;
  out.intersections = {r.intersections.cloth_body,
                       r.intersections.cloth_cloth,
                       {r.worst_frame_step, r.worst_frame.cloth_body, r.worst_frame.cloth_cloth},
                       r.frames_checked};
  out.seam_gap_max_mm = r.seam_gap_max_mm;
  for (const drape::OpenSeam& s : r.open_seams) out.open_seams.push_back({{s.id}, 1e3 * s.gap});
  out.worn = drape::word_of(r.worn);
  for (const analysis::AttachmentFigures& a : r.attachments) out.attachments.push_back(attachment_of(a));
  out.strain = {stretch_of(r.warp), stretch_of(r.weft), figures_of(r.shear)};
  for (const analysis::FitLine& line : r.fit) out.fit.push_back(fit_of(line));
  out.rms_speed = r.rms_speed;
  out.max_speed = r.max_speed;
  out.lowest_m = r.lowest_m;
  out.highest_m = r.highest_m;
  for (const preflight::Finding& f : r.findings) out.findings.push_back(finding_of(f));
  out.hash = {r.hash};
  return out;
}

Json json_of(bool value) { return value; }
Json json_of(int value) { return value; }
Json json_of(double value) { return value; }
Json json_of(const FreeText& value) { return value.text; }
Json json_of(const HexHash& value) { return value.digits; }
Json json_of(const std::array<double, 3>& values) { return values; }
template <typename T>
Json json_of(const std::vector<T>& values);
template <typename T>
Json json_of(const T& object);

/// Visitor that writes an object as it always stood in report.json: every key, whole numbers apart from
/// others.
struct ReportWriter {
  Json object_json = Json::object();

  void object(const char*, const char*) {}
  template <typename T>
  void field(const char* key, const T& value, const char*, fields::Need, fields::Range = fields::kAnything) {
    object_json[key] = json_of(value);
  }
  void field(const char* key, const std::optional<double>& value, const char*, fields::Need, fields::Range) {
    if (value) object_json[key] = *value;
  }
  void choice(const char* key, const std::string& value, const char*, fields::Words,
              fields::Need = fields::Need::kOptional) {
    if (!value.empty()) object_json[key] = value;
  }
};

template <typename T>
Json json_of(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(json_of(value));
  return list;
}

template <typename T>
Json json_of(const T& object) {
  T copy = object;  // a visitor takes places, and writes to none of them here
  ReportWriter writer;
  fields::describe(writer, copy);
  return std::move(writer.object_json);
}

}  // namespace

std::string report_json(const analysis::Report& report) {
  return json_of(document_of(report)).dump(2) + "\n";
}

json::JsonValue report_schema() {
  fields::Definitions definitions;
  const json::JsonValue schema = fields::schema_of(ReportDocument{}, fields::kAnything, definitions);
  return fields::schema_file("Toile report", "", schema, definitions);
}

Status write_report(const std::filesystem::path& path, const analysis::Report& report) {
  return write_file(path, report_json(report));
}

}  // namespace toile::exports
