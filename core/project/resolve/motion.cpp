#include "core/project/resolve/motion.h"

#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/body/mannequin/carry.h"
#include "core/json/tree.h"
#include "core/project/resolve/body_shape.h"

namespace toile::resolve {
namespace {

constexpr std::size_t kMostVertices = 5'000'000;  // of all keyframes: 120 MB

std::string counts_of(const geometry::TriangleMesh& mesh) {
  return std::to_string(mesh.vertices.size()) + " vertices and " + std::to_string(mesh.triangles.size()) +
         " triangles";
}

Error other_mesh(const std::string& why, const std::string& where) {
  return {"project.keyframe_mesh",
          "a keyframe must be the body's own mesh in another shape, with the same triangles; " + why, where};
}

/// Goes from keyframe to keyframe.
class Motion {
 public:
  Motion(const project::ProjectBody& given, geometry::TriangleMesh mesh, OpenedFiles& files)
      : given_(given), files_(files), mesh_(std::move(mesh)), mannequin_(given.mannequin) {}

  Status go_to(const project::ProjectKeyframe& keyframe, const std::string& where) {
    const double since = out_.empty() ? 0 : out_.back().at;
    if (keyframe.after_s <= since) {
      return Error{"project.keyframe_order",
                   "a keyframe must come later than the one before it, at " + number_text(since) + " s",
                   json::pointer_to(where, "after_s")};
    }
    std::vector<geometry::TriangleMesh> way;
    if (keyframe.mannequin) {
      way = TRY(to_mannequin(*keyframe.mannequin, json::pointer_to(where, "mannequin")));
    } else {
      way.push_back(TRY(to_file(keyframe, where)));
    }
    mannequin_ = keyframe.mannequin;
    mesh_ = way.back();
    for (std::size_t k = 0; k < way.size(); ++k) {
      const double share = static_cast<double>(k + 1) / static_cast<double>(way.size());
      TRY(place(given_, where, way[k].vertices));
      out_.push_back({since + (keyframe.after_s - since) * share, std::move(way[k].vertices)});
    }
    if (out_.size() * mesh_.vertices.size() <= kMostVertices) return {};
    return Error{"project.motion_large",
                 "the body's motion has more than " + std::to_string(kMostVertices) +
                     " vertices in all its keyframes; fewer of them, or a coarser mesh, will do",
                 where};
  }

  std::vector<body::Keyframe> take() { return std::move(out_); }

 private:
  Result<std::vector<geometry::TriangleMesh>> to_mannequin(const project::ProjectMannequin& wanted,
                                                           const std::string& where) {
    if (!mannequin_) return other_mesh("only a mannequin becomes a mannequin", where);
    const auto made = [&](const project::ProjectMannequin& one) -> Result<const mannequin::Mannequin*> {
      Result<const mannequin::Mannequin*> got = files_.made_mannequin(one);
      if (!got) return json::error_at(where, got.error());
      return got;
    };
    project::ProjectMannequin as_fine = wanted;
    as_fine.triangles = mannequin_->triangles;
    const mannequin::Mannequin* from = TRY(made(*mannequin_));
    const mannequin::Mannequin* to = TRY(made(as_fine));
    if (from->shape.figure != to->shape.figure) return other_mesh("a mannequin keeps its sex", where);
    return mannequin::on_the_way(mesh_, *from, *to);
  }

  Result<geometry::TriangleMesh> to_file(const project::ProjectKeyframe& keyframe, const std::string& where) {
    project::ProjectBody shape = given_;
    shape.file = keyframe.file;
    shape.mannequin.reset();
    geometry::TriangleMesh mesh = TRY(mesh_of(shape, files_, where)).mesh;
    if (mesh.triangles == mesh_.triangles && mesh.vertices.size() == mesh_.vertices.size()) return mesh;
    const std::string mine = counts_of(mesh), wanted = counts_of(mesh_);
    return other_mesh(mine == wanted ? "this one has as many in another order"
                                     : "this one has " + mine + ", the body " + wanted,
                      where);
  }

  const project::ProjectBody& given_;
  OpenedFiles& files_;
  geometry::TriangleMesh mesh_;                         ///< where it has come to, before it is placed
  std::optional<project::ProjectMannequin> mannequin_;  ///< what that is, where it is one
  std::vector<body::Keyframe> out_;
};

}  // namespace

Result<std::vector<body::Keyframe>> motion_of(const project::ProjectBody& given,
                                              const geometry::TriangleMesh& mesh, OpenedFiles& files,
                                              const std::string& where) {
  Motion motion(given, mesh, files);
  const std::string list = json::pointer_to(where, "motion");
  for (std::size_t k = 0; k < given.motion.size(); ++k)
    TRY(motion.go_to(given.motion[k], json::pointer_to(list, k)));
  return motion.take();
}

}  // namespace toile::resolve
