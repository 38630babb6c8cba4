// Project → document text, by the same list of fields that the reader uses.

#include "core/json/fields/writer.h"
#include "core/json/tree.h"
#include "core/project/fields.h"
#include "core/project/project.h"

namespace toile {

std::string write_project(const Project& project) {
  Project copy = project;  // a visitor takes places, and writes to none of them here
  return write_json(fields::json_of(copy));
}

std::string write_project_line(const Project& project) {
  Project copy = project;
  return write_json_line(fields::json_of(copy));
}

}  // namespace toile
