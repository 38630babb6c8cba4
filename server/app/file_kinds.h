#pragma once
// What kind of file stands where another is wanted: told by its name, before anybody tries to read it. Each
// gives back what to say, or nothing, as checks of the command line do.

#include <string>

namespace toile::app {

/// Of a project document.
std::string not_a_project(const std::string& path);
/// Of a pattern.
std::string not_a_pattern(const std::string& path);
/// Of a body's mesh.
std::string not_a_body(const std::string& path);

}  // namespace toile::app
