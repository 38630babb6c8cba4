#pragma once
// The document's bodies by themselves: read and written without the rest of a document, and the mannequin in
// the core's own terms.

#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/body/mannequin/mannequin.h"
#include "core/body/measure/stance.h"
#include "core/json/tree.h"
#include "core/project/project.h"

namespace toile::project {

/// "female", "male", "child".
const char* name_of(mannequin::Sex sex);

/// The preset's sex and measures first, what the document says over them. With neither preset nor sex it is a
/// woman of 170 cm, 90-72-96, where these are not given: so documents have meant it from the first. Errors,
/// with the key as place: project.unknown_preset.
Result<mannequin::MannequinSettings> mannequin_settings(const ProjectMannequin& given);

/// Errors: project.* as for a document, `where` begins with the object's own pointer.
Result<ProjectMannequin> read_mannequin(const json::JsonValue& object, const std::string& where);
Result<ProjectBody> read_body(const json::JsonValue& object, const std::string& where);
/// As a document has it.
json::JsonValue mannequin_json(const ProjectMannequin& mannequin);

/// The body of a file, whose unit and directions are not said yet, as stand_body() put it; not its height.
void stand_up(ProjectBody& body, const measure::BodyStance& stance);
/// How the body was turned for that, in words; empty where it stood upright in its file and looked to the
/// front.
std::string turned_words(const measure::BodyStance& stance);

/// What the document means without its bodies, which take long to read: what is told by them goes with them.
Project without_bodies(Project project);

/// Least and most that a document may ask of a measure, cm.
std::pair<double, double> measure_range_cm(measure::Measure m);

}  // namespace toile::project
