#include "tests/garmentcode/to_project.h"

#include <Eigen/Geometry>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/units.h"
#include "core/base/write_file.h"

namespace toile::test {

namespace {

using nlohmann::json;

struct SourcePanel {
  bool clockwise = false;
  int edges = 0;
  /// The id that the reader gives to edge i of the source: outlines are turned counter-clockwise, e0 at the
  /// same corner.
  std::string edge_id(int i) const { return "e" + std::to_string(clockwise ? edges - 1 - i : i); }
};

double signed_area(const std::vector<Vec2>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += cross(p[i], p[(i + 1) % p.size()]);
  return sum / 2;
}

/// GarmentCode turns about x, then the turned y, then the turned z; a placement about the fixed x, y, z.
Eigen::Matrix3d rotation_of(const json& degrees) {
  const auto about = [&](int k, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(radians_from_degrees(degrees[k].get<double>()), axis);
  };
  return (about(0, Eigen::Vector3d::UnitX()) * about(1, Eigen::Vector3d::UnitY()) *
          about(2, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

ProjectRigid placement_of(const json& panel) {
  const Eigen::Matrix3d r = rotation_of(panel["rotation_euler_xyz_deg"]);
  const Eigen::Vector3d offset(panel["dxf_offset"][0], panel["dxf_offset"][1], 0);
  Eigen::Vector3d t(panel["translation_mm"][0], panel["translation_mm"][1], panel["translation_mm"][2]);
  t = (t - r * offset) * 1e-3;
  ProjectRigid rigid;
  rigid.translation = {t.x(), t.y(), t.z()};
  rigid.rotation = {degrees_from_radians(std::atan2(r(2, 1), r(2, 2))),
                    degrees_from_radians(-std::asin(r(2, 0))),
                    degrees_from_radians(std::atan2(r(1, 0), r(0, 0)))};
  return rigid;
}

ProjectPiece piece_of(const std::string& id, const json& panel, const std::string& dxf, SourcePanel& source) {
  ProjectPiece piece;
  piece.id = id;
  piece.from = ProjectDxf{dxf, id, {}, "mm"};
  piece.fabric = "cotton";
  piece.placement.rigid = placement_of(panel);
  std::vector<Vec2> outline;
  for (const json& edge : panel["edges"]) {
    const auto point = [&](const json& p) {
      return Vec2{p[0].get<double>() + panel["dxf_offset"][0].get<double>(),
                  p[1].get<double>() + panel["dxf_offset"][1].get<double>()};
    };
    piece.from->corners.push_back(point(edge["pts"][0]));
    for (std::size_t i = 0; i + 1 < edge["pts"].size(); ++i) outline.push_back(point(edge["pts"][i]));
  }
  source = {signed_area(outline) < 0, static_cast<int>(panel["edges"].size())};
  return piece;
}

/// Stitched edges run against each other in the source's own winding.
ProjectSeam seam_of(const json& stitch, int number, const std::map<std::string, SourcePanel>& sources) {
  const SourcePanel& a = sources.at(stitch["a"]["panel"]);
  const SourcePanel& b = sources.at(stitch["b"]["panel"]);
  ProjectSeam seam;
  seam.id = "seam" + std::to_string(number);
  seam.a = {{stitch["a"]["panel"], a.edge_id(stitch["a"]["edge"]), false}};
  seam.b = {{stitch["b"]["panel"], b.edge_id(stitch["b"]["edge"]), false}};
  seam.same_direction = a.clockwise != b.clockwise;
  return seam;
}

/// A plain cotton shirting: mass, bending and stretch of the order of Wang et al. 2011 and Feng et al. 2022.
ProjectFabric cotton() {
  ProjectFabric fabric;
  fabric.id = "cotton", fabric.name = "Plain cotton";
  fabric.areal_mass_g_m2 = 150;
  fabric.bend_warp_un_m = 12, fabric.bend_weft_un_m = 8, fabric.bend_bias_un_m = 9;
  return fabric;
}

}  // namespace

Result<Project> garmentcode_project(const std::filesystem::path& folder, const std::string& name,
                                    const std::string& body_file, const std::vector<std::string>& held) {
  std::ifstream in(folder / (name + ".seams.json"));
  const json source = json::parse(in, nullptr, false);
  if (source.is_discarded()) return Error{"test.seams", "no seams file", (folder / name).string()};

  Project project;
  project.name = name;
  std::map<std::string, SourcePanel> sources;
  for (const auto& [id, panel] : source["panels"].items()) {
    project.pieces.push_back(piece_of(id, panel, name + ".dxf", sources[id]));
    for (const std::string& prefix : held) {
      if (id.rfind(prefix, 0) == 0) project.attachments.push_back({"hold_" + id, id, {}, "height", 1.0});
    }
  }
  int number = 0;
  for (const json& stitch : source["stitches"]) project.seams.push_back(seam_of(stitch, number++, sources));
  project.fabrics = {cotton()};
  ProjectBody body;
  body.id = "body", body.file = body_file, body.unit = "m";
  project.bodies = {body};
  return project;
}

Status write_garmentcode_project(const std::filesystem::path& data, const std::string& name,
                                 const std::string& body, const std::vector<std::string>& held,
                                 double particle_distance_mm, const std::filesystem::path& out) {
  auto project = garmentcode_project(data / "garmentcode", name, body, held);
  if (!project) return project.error();
  project->settings.particle_distance_mm = particle_distance_mm;
  std::filesystem::create_directories(out);
  const auto copy = [&](const std::filesystem::path& from) {
    std::filesystem::copy_file(from, out / from.filename(),
                               std::filesystem::copy_options::overwrite_existing);
  };
  copy(data / "garmentcode" / (name + ".dxf"));
  copy(data / "bodies" / body);
  return write_file(out / "project.json", write_project(*project));
}

}  // namespace toile::test
