#pragma once
// A schema as proto/schema keeps it, beside what the program's field descriptions make.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "core/json/tree.h"

namespace toile::test {

inline std::string kept_schema(const std::string& name) {
  std::ifstream in(std::string(TOILE_SOURCE_DIR) + "/proto/schema/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void expect_kept(const std::string& name, const json::JsonValue& made) {
  EXPECT_TRUE(kept_schema(name) == json::write_json(made))
      << "proto/schema/" << name << " is not what the fields say; to write it anew: ninja -C build/release "
      << "make_schemas && build/release/make_schemas proto/schema, then npm run generate in web";
}

/// The definition to which a reference leads within the same file, or the schema itself.
inline const json::JsonValue& resolved(const json::JsonValue& root, const json::JsonValue& schema) {
  const json::JsonValue* reference = schema.find("$ref");
  if (!reference) return schema;
  const std::string& text = *reference->text();
  return *root.find("$defs")->find(text.substr(text.rfind('/') + 1));
}

}  // namespace toile::test
