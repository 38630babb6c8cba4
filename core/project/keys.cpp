#include "core/project/keys.h"

#include "core/project/fields.h"

namespace toile {

std::vector<fields::FieldKey> project_keys() {
  std::vector<fields::FieldKey> keys;
  Project project;
  fields::FieldLister lister(keys, "");
  describe(lister, project);
  return keys;
}

}  // namespace toile
