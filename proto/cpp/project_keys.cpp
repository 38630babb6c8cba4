// The format's keys as a flat list, for whoever must agree with the reader: the schema.

#include "proto/cpp/field_lister.h"

namespace toile {

std::vector<ProjectKey> project_keys() {
  std::vector<ProjectKey> keys;
  Project project;
  fields::FieldLister lister(keys, "");
  describe(lister, project);
  return keys;
}

}  // namespace toile
