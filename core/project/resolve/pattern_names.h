#pragma once
// A document's names as indices of what they name.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile::resolve {

template <typename T>
std::vector<std::string> ids_of(const std::vector<T>& things) {
  std::vector<std::string> ids;
  ids.reserve(things.size());
  for (const T& thing : things) ids.push_back(thing.id);
  return ids;
}

/// Index of `name`, or an error project.unknown_<thing> that says which names there are.
Result<Index> index_of(const std::string& name, const std::vector<std::string>& names, const char* thing,
                       const std::string& where);

/// Looks up pieces, edges and lines by name. Errors: project.unknown_piece, project.unknown_edge,
/// project.unknown_line, at `where`.
class PatternNames {
 public:
  explicit PatternNames(const pattern::Pattern& pattern);

  Result<Index> panel(const std::string& name, const std::string& where) const;
  Result<Index> edge(Index panel, const std::string& name, const std::string& where) const;
  Result<Index> line(Index panel, const std::string& name, const std::string& where) const;
  bool has_edge(Index panel, const std::string& name) const;

 private:
  Error in_piece(Index panel, Error error) const;

  std::vector<std::string> panels_;
  std::vector<std::vector<std::string>> edges_;  ///< of each panel, as SeamEdge::edge counts
  std::vector<std::vector<std::string>> lines_;
};

}  // namespace toile::resolve
