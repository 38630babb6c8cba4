#pragma once
// One project in other fabrics and on other bodies: what the cells of a sweep drape.

#include <string>

#include "core/base/result.h"
#include "core/project/project.h"

namespace toile::sweep {

/// What most pieces are cut of, the first of several: id in the document, or name in the library. Empty where
/// no piece and no project says a fabric.
std::string main_fabric(const project::Project& project);

/// The garment with its main fabric replaced; linings, interlinings and what else is cut of another stay, and
/// so do the figures that pieces have for themselves. `fabric` is an id of the document or a name of the
/// library. Error: project.unknown_fabric.
Result<project::Project> cut_of(project::Project project, const std::string& fabric);

/// What another body does not change: how cloth lies on it, where a figure stands, and landmarks that mean
/// the same on it. REQUIRES of `now` no landmarks of its own.
void take_the_place_of(const project::ProjectBody& was, project::ProjectBody& now);

/// The garment on `body`, in place of the one with its id, or beside the others when there is none. A
/// mannequin moves as the one before did, in its own measures. Error: sweep.moving_body when one of the two
/// comes from a file and the one before moves.
Result<project::Project> worn_by(project::Project project, project::ProjectBody body);

/// Id of the body that a sweep changes when nobody says which: the first; "body" where there is none.
std::string main_body(const project::Project& project);

/// What a body is called that has no other name: its preset, its file, or what it measures.
std::string name_of(const project::ProjectBody& body);

}  // namespace toile::sweep
