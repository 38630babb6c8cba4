#include "server/documents/landmarks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/base/rounded.h"
#include "core/base/units.h"
#include "core/body/measure/own_landmarks.h"
#include "core/project/resolve/body_places.h"
#include "core/project/resolve/resolve.h"
#include "server/documents/edits.h"
#include "server/documents/projects.h"

namespace toile::documents {
namespace {

constexpr std::size_t kLongestName = 100;  // bytes
constexpr double kFarthest = 100;          // m from the origin

/// In tenths of a millimetre: nobody points better.
Vec3 rounded_mm(Vec3 metres) {
  const auto mm = [](double x) { return rounded(mm_from_metres(x), 1); };
  return {mm(metres.x), mm(metres.y), mm(metres.z)};
}

/// `known`: those from which the document can tell it.
project::ProjectLandmark told(const std::string& name, Vec3 place, const geometry::TriangleMesh& mesh,
                              const std::vector<measure::Landmark>& known) {
  const measure::SkinPoint at = measure::nearest_on_skin(mesh, place);
  const Result<measure::BodyFigure> figure = measure::find_figure(mesh);
  if (!figure || known.empty()) return {.name = name, .triangle = at.triangle, .share = at.share};
  const measure::Landmark* own = measure::landmark_named(known, name);
  const measure::OwnLandmark mark =
      own ? measure::OwnLandmark{name, {}, name, measure::position_of(at, mesh) - own->place}
          : measure::told_from_nearest(name, at, mesh, known);
  return {.name = name,
          .near = mark.near,
          .offset_mm = rounded_mm(mark.offset),
          .body_height_mm = rounded(mm_from_metres(figure->height()), 1)};
}

Result<std::size_t> index_of(const project::Project& project, const std::string& body) {
  for (std::size_t b = 0; b < project.bodies.size(); ++b)
    if (project.bodies[b].id == body) return b;
  return Error{"edit.unknown_body", "There is no body of that name.", "body " + clipped(body)};
}

std::vector<project::ProjectLandmark>::iterator named(std::vector<project::ProjectLandmark>& list,
                                                      const std::string& name) {
  return std::find_if(list.begin(), list.end(),
                      [&](const project::ProjectLandmark& l) { return l.name == name; });
}

Status check(const std::string& name, Vec3 place) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
  if (name.empty() || name.size() > kLongestName || std::any_of(name.begin(), name.end(), is_control))
    return Error{"request.landmark", "a landmark's name is a word or a few, of at most 100 letters", "name"};
  for (const double x : {place.x, place.y, place.z})
    if (!(std::abs(x) <= kFarthest))
      return Error{"request.landmark", "a place is three numbers of at most 100 (metres)", "/place"};
  return {};
}

}  // namespace

Result<store::ProjectRow> move_landmark(Documents& documents, const store::RequestContext& context,
                                        const std::string& id, const std::string& body,
                                        const std::string& name, Vec3 place, int expected) {
  TRY(check(name, place));
  const ProjectChange change = [&](const project::Project& now, ProjectFileMap&,
                                   resolve::OpenedFiles& opened) -> Result<project::Project> {
    const std::size_t b = TRY(index_of(now, body));
    const drape::DrapeInput input = TRY(resolve::resolve_project(now, opened));
    // What stands before it in the document's list can tell it, and what the body has by itself.
    project::Project before = now;
    std::vector<project::ProjectLandmark>& earlier = before.bodies[b].landmarks;
    earlier.erase(named(earlier, name), earlier.end());
    resolve::BodyPlaces places(before, input.bodies);
    const std::vector<measure::Landmark> known = TRY(places.landmarks_of(static_cast<Index>(b)));
    project::ProjectLandmark mark = told(name, place, input.bodies[b].mesh, known);
    if (now.bodies[b].mannequin && mark.triangle)
      return Error{"landmark.of_mannequin", "this body has no landmark from which another could be told",
                   name};
    project::Project wanted = now;
    std::vector<project::ProjectLandmark>& list = wanted.bodies[b].landmarks;
    const auto at = named(list, name);
    if (at == list.end()) {
      list.push_back(std::move(mark));
    } else {
      *at = std::move(mark);
    }
    TRY(resolve::resolve_project(wanted, opened));
    return wanted;
  };
  return change_project(documents, context, id, expected, change);
}

Result<store::ProjectRow> forget_landmark(Documents& documents, const store::RequestContext& context,
                                          const std::string& id, const std::string& body,
                                          const std::string& name, int expected) {
  const ProjectChange change = [&](const project::Project& now, ProjectFileMap&,
                                   resolve::OpenedFiles& opened) -> Result<project::Project> {
    const std::size_t b = TRY(index_of(now, body));
    project::Project wanted = now;
    std::vector<project::ProjectLandmark>& list = wanted.bodies[b].landmarks;
    const auto at = named(list, name);
    if (at == list.end())
      return Error{"edit.unknown_landmark", "The document says nothing of a landmark of that name.",
                   "landmark " + clipped(name)};
    list.erase(at);
    TRY(resolve::resolve_project(wanted, opened));
    return wanted;
  };
  return change_project(documents, context, id, expected, change);
}

}  // namespace toile::documents
