// Project → document text, by the same list of fields that the reader uses.

#include "proto/cpp/field_writer.h"
#include "proto/cpp/json_codec.h"
#include "proto/cpp/project.h"

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
