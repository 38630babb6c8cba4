#include "core/exports/write_report.h"

#include <nlohmann/json.hpp>

#include "core/base/write_file.h"

namespace toile::exports {

namespace {

nlohmann::ordered_json strain_json(const analysis::StrainFigures& f) {
  return {{"mean", f.mean}, {"p99", f.p99}, {"max", f.max}};
}

nlohmann::ordered_json stretch_json(const analysis::StretchFigures& f) {
  nlohmann::ordered_json j = strain_json(f);
  j["tension"] = strain_json(f.tension);
  j["compression"] = strain_json(f.compression);
  return j;
}

nlohmann::ordered_json finding_json(const preflight::Finding& f) {
  return {{"code", preflight::code_of(f.kind)},
          {"severity", preflight::name_of(f.severity)},
          {"message", f.message},
          {"where", preflight::where_text(f)},
          {"place", {f.place.x, f.place.y, f.place.z}},
          {"repaired", f.repaired}};
}

nlohmann::ordered_json attachment_json(const analysis::AttachmentFigures& a) {
  nlohmann::ordered_json j{{"id", a.id}, {"released", a.released}, {"off_mm", a.off_mm}};
  if (a.released) j["released_s"] = a.released_s;
  return j;
}

}  // namespace

std::string report_json(const analysis::Report& r) {
  nlohmann::ordered_json j;
  j["name"] = r.name;
  j["settled"] = r.settled();
  j["stop_reason"] = drape::to_string(r.stop_reason);
  j["cpu_s"] = r.cpu_s;
  j["wall_s"] = r.wall_s;
  j["resumed"] = r.resumed;
  j["steps"] = r.steps;
  j["simulated_s"] = r.simulated_s;
  j["particles"] = r.particles;
  j["sewn_particles"] = r.sewn_particles;
  j["triangles"] = r.triangles;
  j["body_triangles"] = r.body_triangles;
  j["intersections"] = {{"cloth_body", r.intersections.cloth_body},
                        {"cloth_cloth", r.intersections.cloth_cloth},
                        {"worst_frame",
                         {{"step", r.worst_frame_step},
                          {"cloth_body", r.worst_frame.cloth_body},
                          {"cloth_cloth", r.worst_frame.cloth_cloth}}},
                        {"frames_checked", r.frames_checked}};
  j["seam_gap_max_mm"] = r.seam_gap_max_mm;
  j["attachments"] = nlohmann::ordered_json::array();
  for (const analysis::AttachmentFigures& a : r.attachments) j["attachments"].push_back(attachment_json(a));
  j["strain"] = {
      {"warp", stretch_json(r.warp)}, {"weft", stretch_json(r.weft)}, {"shear", strain_json(r.shear)}};
  j["rms_speed"] = r.rms_speed;
  j["max_speed"] = r.max_speed;
  j["lowest_m"] = r.lowest_m;
  j["highest_m"] = r.highest_m;
  j["findings"] = nlohmann::ordered_json::array();
  for (const preflight::Finding& f : r.findings) j["findings"].push_back(finding_json(f));
  j["hash"] = r.hash;
  return j.dump(2) + "\n";
}

Status write_report(const std::filesystem::path& path, const analysis::Report& report) {
  return write_file(path, report_json(report));
}

}  // namespace toile::exports
