#include "core/project/resolve/pattern_names.h"

#include <algorithm>
#include <utility>

#include "core/base/names.h"

namespace toile::resolve {

Result<Index> index_of(const std::string& name, const std::vector<std::string>& names, const char* thing,
                       const std::string& where) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Index>(found - names.begin());
  return Error{std::string("project.unknown_") + thing,
               std::string("there is no ") + thing + " " + in_quotes(name) + "; " + advice(name, names),
               where};
}

PatternNames::PatternNames(const pattern::Pattern& pattern) : panels_(ids_of(pattern.panels)) {
  for (const pattern::Panel& panel : pattern.panels) {
    std::vector<std::string>& ids = edges_.emplace_back();
    for (const pattern::PanelEdge* edge : pattern::edges_of(panel)) ids.push_back(edge->id);
    lines_.push_back(ids_of(panel.lines));
  }
}

Result<Index> PatternNames::panel(const std::string& name, const std::string& where) const {
  return index_of(name, panels_, "piece", where);
}

Result<Index> PatternNames::edge(Index panel, const std::string& name, const std::string& where) const {
  Result<Index> found = index_of(name, edges_[static_cast<std::size_t>(panel)], "edge", where);
  if (found) return found;
  return in_piece(panel, found.error());
}

Result<Index> PatternNames::line(Index panel, const std::string& name, const std::string& where) const {
  Result<Index> found = index_of(name, lines_[static_cast<std::size_t>(panel)], "line", where);
  if (found) return found;
  return in_piece(panel, found.error());
}

bool PatternNames::has_edge(Index panel, const std::string& name) const {
  const std::vector<std::string>& ids = edges_[static_cast<std::size_t>(panel)];
  return std::find(ids.begin(), ids.end(), name) != ids.end();
}

Error PatternNames::in_piece(Index panel, Error error) const {
  error.message =
      "piece " + in_quotes(panels_[static_cast<std::size_t>(panel)]) + ": " + std::move(error.message);
  return error;
}

}  // namespace toile::resolve
