#include "server/app/sweep_bodies.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include "core/base/names.h"
#include "core/base/text.h"
#include "core/body/mesh_import/formats.h"
#include "core/json/tree.h"
#include "core/project/bodies.h"

namespace toile::app {
namespace {

std::vector<std::string> parts_of(const std::string& word) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= word.size();) {
    const std::size_t end = std::min(word.find(',', at), word.size());
    parts.push_back(word.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// "arm-length=60" as a document has it: "arm_length_cm": 60.
Result<json::JsonMember> member_of(const std::string& part, const std::string& word) {
  const std::size_t at = part.find('=');
  std::string key = part.substr(0, at);
  const std::string value = part.substr(at + 1);
  std::replace(key.begin(), key.end(), '-', '_');
  if (key == "sex" || key == "pose") return json::JsonMember{key, value};
  const std::optional<double> number = number_in<double>(value);
  if (!number)
    return Error{"usage.body",
                 "a measure is a number of cm, \"waist=80\", and " + in_quotes(part) + " is none", word};
  if (key == "arm_angle" || key == "triangles") return json::JsonMember{key, *number};
  return json::JsonMember{(key == "chest" ? "bust" : key) + "_cm", *number};
}

}  // namespace

Result<BodyWord> read_body_word(const std::string& word) {
  BodyWord body;
  body.own = word == "own";
  if (body.own) return body;
  std::error_code ignored;
  if (std::filesystem::exists(word, ignored) || word.find('/') != std::string::npos) {
    body.file = word;
    return body;
  }
  std::vector<json::JsonMember> members;
  const std::vector<std::string> parts = parts_of(word);
  for (const std::string& part : parts) {
    if (part.find('=') == std::string::npos && &part == &parts.front()) {
      members.push_back({"preset", part});
      continue;
    }
    if (part.find('=') == std::string::npos)
      return Error{"usage.body",
                   "a body is \"own\", a mesh file, or a preset with measures: \"eu40,waist=80\"; " +
                       in_quotes(part) + " says nothing of it",
                   word};
    json::JsonMember member = TRY(member_of(part, word));
    members.push_back(std::move(member));
  }
  Result<project::ProjectMannequin> mannequin = project::read_mannequin(members, "");
  if (!mannequin) return json::error_at(clipped(word), mannequin.error());
  const Result<mannequin::MannequinSettings> known = project::mannequin_settings(*mannequin);
  if (!known) return json::error_at(clipped(word), known.error());
  body.mannequin = *mannequin;
  return body;
}

}  // namespace toile::app
