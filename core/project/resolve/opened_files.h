#pragma once
// The files of a document while somebody works on it, each read once.

#include <deque>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/body/mesh_import/repair.h"
#include "core/pattern/dxf/read.h"
#include "core/project/project.h"
#include "core/project/resolve/files.h"

namespace toile::resolve {

/// Keeps what it has read, so that a document which is resolved again (before and after an edit) does not
/// read its files again. What failed is asked for again. Not for several threads at once.
class OpenedFiles {
 public:
  explicit OpenedFiles(ProjectFiles source) : source_(std::move(source)) {}

  /// In the unit and size that the piece asks for, with its layers; the pointer holds as long as the object.
  /// Errors: project.path, dxf.*, and what the source gives.
  Result<const dxf::DxfDrawing*> drawing(const project::ProjectDxf& from);
  /// REQUIRES a body from a file, whose name has passed check_file_name. Errors: what the source gives.
  Result<mesh_import::RepairedMesh> body_mesh(const project::ProjectBody& body);
  /// Errors: project.unknown_preset, mannequin.*, and what the source gives.
  Result<geometry::TriangleMesh> mannequin(const project::ProjectMannequin& given);
  /// With its shape, which takes long to find. The pointer holds as long as the object. Errors:
  /// project.unknown_preset, mannequin.*.
  Result<const mannequin::Mannequin*> made_mannequin(const project::ProjectMannequin& given);

  /// For what is read but once: pictures.
  const ProjectFiles& source() const { return source_; }

 private:
  /// File, unit, size and layers: all that a drawing depends on.
  using Reading =
      std::tuple<std::string, std::string, std::string, std::vector<std::pair<std::string, std::string>>>;

  Result<const std::string*> dxf_text(const std::string& name);

  ProjectFiles source_;
  std::map<std::string, std::string> texts_;  ///< of DXF files
  std::map<Reading, dxf::DxfDrawing> drawings_;
  std::map<std::tuple<std::string, double, bool>, mesh_import::RepairedMesh>
      meshes_;  ///< by file, unit, whether z is up
  std::vector<std::pair<project::ProjectMannequin, geometry::TriangleMesh>> mannequins_;
  std::deque<std::pair<project::ProjectMannequin, mannequin::Mannequin>> made_;
};

}  // namespace toile::resolve
