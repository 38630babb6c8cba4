#include "server/documents/dress.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/aabb.h"
#include "core/base/names.h"
#include "core/body/measure/stance.h"
#include "core/json/tree.h"
#include "core/project/bodies.h"
#include "core/sweep/variants.h"
#include "server/documents/edits.h"

namespace toile::documents {
namespace {

Error bad_wish(const std::string& message, const std::string& key) {
  return {"request.body", message, json::pointer_to("", key)};
}

/// What of the wish goes into the document as it stands there.
json::JsonValue document_part(const json::JsonValue& wish, const std::string& id) {
  std::vector<json::JsonMember> members{{"id", id}};
  for (const json::JsonMember& member : *wish.object())
    if (member.key != "asset" && member.key != "turn") members.push_back(member);
  return members;
}

double lowest(const geometry::TriangleMesh& mesh) { return bounding_box(mesh.vertices).low.y; }

/// A name under which no other file of the project goes.
std::string free_name(const ProjectFileMap& files, const store::AssetRow& asset) {
  const auto taken = files.find(asset.name);
  if (taken == files.end() || taken->second == asset.id) return asset.name;
  return asset.id.substr(0, 10) + "-" + asset.name;
}

/// Guessed where nothing is said.
Status place_file(Documents& documents, const store::RequestContext& context, const json::JsonValue& wish,
                  const store::AssetRow& asset, project::ProjectBody& body) {
  const auto raw = TRY(documents.bodies().mesh(documents.store(), context, asset.id, {.unit_in_m = 1}));
  const std::string unit = body.unit, up = body.up;
  const Result<measure::StandingBody> standing = measure::stand_body(raw->mesh);
  if (standing) project::stand_up(body, standing->stance);
  if (!unit.empty()) {
    body.unit = unit;
    body.scale = 1;
  }
  if (!up.empty() && up != body.up) {
    body.up = up;
    body.rotation = {};
  }
  if (const json::JsonValue* turn = wish.find("turn")) body.rotation.y += *turn->number();
  return {};
}

/// Its feet on the floor, once everything else is said.
Status put_on_floor(resolve::OpenedFiles& opened, project::ProjectBody& body) {
  project::Project alone;
  alone.bodies = {body};
  const drape::DrapeInput input = TRY(resolve::resolve_project(alone, opened));
  const double floor = lowest(input.bodies[0].mesh);
  body.translation.y = -std::round(floor * 1e6) / 1e6 + 0.0;
  return {};
}

/// A figure that can be made, so that the refusal names the measure and not the document's place.
Result<project::ProjectBody> made_body(Documents& documents, const json::JsonValue& part) {
  project::ProjectBody body = TRY(project::read_body(part, ""));
  const Result<mannequin::MannequinSettings> settings = project::mannequin_settings(*body.mannequin);
  if (!settings) return json::error_at("/mannequin", settings.error());
  const auto figure = documents.mannequins().get(*settings);
  if (!figure) return json::error_at("/mannequin", figure.error());
  return body;
}

Result<project::ProjectBody> body_of(Documents& documents, const store::RequestContext& context,
                                     const std::string& id, const json::JsonValue& wish,
                                     ProjectFileMap& files, resolve::OpenedFiles& opened) {
  const json::JsonValue* given = wish.find("asset");
  if (!given) return made_body(documents, document_part(wish, id));
  if (!given->text()) return bad_wish("\"asset\" is the id of an uploaded body", "asset");
  if (const json::JsonValue* turn = wish.find("turn");
      turn && (!turn->number() || !(std::abs(*turn->number()) <= 360)))
    return bad_wish("this is an angle of at most 360 degrees", "turn");
  store::AssetRow asset = TRY(documents.store().asset(context, *given->text()));
  if (asset.kind != "body")
    return Error{"documents.wrong_kind", in_quotes(asset.name) + " is no body", "/asset"};
  const std::string name = free_name(files, asset);
  json::JsonValue part = document_part(wish, id);
  std::get<std::vector<json::JsonMember>>(part.data).push_back({"file", name});
  project::ProjectBody body = TRY(project::read_body(part, ""));
  TRY(place_file(documents, context, wish, asset, body));
  files[name] = asset.id;
  TRY(put_on_floor(opened, body));
  return body;
}

/// What the body before leaves to it, but for what the wish says of how cloth lies on it.
void carry_over(const project::ProjectBody& was, const json::JsonValue& wish, project::ProjectBody& body) {
  const double friction = body.friction, skin_offset_mm = body.skin_offset_mm;
  sweep::take_the_place_of(was, body);
  if (wish.find("friction")) body.friction = friction;
  if (wish.find("skin_offset_mm")) body.skin_offset_mm = skin_offset_mm;
}

Status check_keys(const json::JsonValue& wish) {
  const std::vector<std::string> known{"mannequin", "asset", "friction", "skin_offset_mm",
                                       "unit",      "up",    "turn"};
  if (!wish.object()) return Error{"request.body", "a body is a JSON object", ""};
  for (const json::JsonMember& member : *wish.object()) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    return Error{"request.unknown_key",
                 "the key " + in_quotes(member.key) + " is not known here; " + advice(member.key, known),
                 json::pointer_to("", member.key)};
  }
  const bool made = wish.find("mannequin") != nullptr, file = wish.find("asset") != nullptr;
  if (made == file) return Error{"request.body", "one of \"mannequin\" and \"asset\" must stand here", ""};
  for (const char* key : {"unit", "up", "turn"})
    if (made && wish.find(key)) return bad_wish("this is for a body from a file", key);
  return {};
}

}  // namespace

Result<store::ProjectRow> dress_project(Documents& documents, const store::RequestContext& context,
                                        const std::string& id, const std::string& body,
                                        const json::JsonValue& wish, int expected) {
  TRY(check_keys(wish));
  const ProjectChange change = [&](const project::Project& now, ProjectFileMap& files,
                                   resolve::OpenedFiles& opened) -> Result<project::Project> {
    project::ProjectBody made = TRY(body_of(documents, context, body, wish, files, opened));
    project::Project wanted = now;
    const auto at = std::find_if(wanted.bodies.begin(), wanted.bodies.end(),
                                 [&](const project::ProjectBody& one) { return one.id == body; });
    if (at == wanted.bodies.end()) {
      wanted.bodies.push_back(std::move(made));
    } else {
      carry_over(*at, wish, made);
      *at = std::move(made);
    }
    return wanted;
  };
  return change_project(documents, context, id, expected, change);
}

Result<DressedBody> body_of_wish(Documents& documents, const store::RequestContext& context,
                                 const std::string& body, const json::JsonValue& wish,
                                 const ProjectFileMap& files) {
  TRY(check_keys(wish));
  const auto growing = std::make_shared<ProjectFileMap>(files);
  resolve::OpenedFiles opened(growing_files_in_store(documents, context, growing));
  project::ProjectBody made = TRY(body_of(documents, context, body, wish, *growing, opened));
  TRY(check_more_files(documents, context, files, *growing));
  return DressedBody{std::move(made), *growing};
}

Result<store::ProjectRow> undress_project(Documents& documents, const store::RequestContext& context,
                                          const std::string& id, const std::string& body, int expected) {
  const ProjectChange change = [&](const project::Project& now, ProjectFileMap&,
                                   resolve::OpenedFiles&) -> Result<project::Project> {
    project::Project wanted = now;
    if (std::erase_if(wanted.bodies, [&](const project::ProjectBody& one) { return one.id == body; }) > 0)
      return wanted;
    return Error{"edit.unknown_body", "There is no body of that name.", "body " + clipped(body)};
  };
  return change_project(documents, context, id, expected, change);
}

}  // namespace toile::documents
