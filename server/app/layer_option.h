#pragma once
// --layer: what the layers of a DXF file stand for, as the command line spells it.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf/layers.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library names itself so
class App;
}

namespace toile::app {

/// Adds the option, which may be given several times.
void add_layer_option(CLI::App& verb, std::vector<std::string>& layers);

/// What was given, "3=sew" each. Errors: pattern.layer, dxf.unknown_role.
Result<dxf::DxfLayerMap> read_layers(const std::vector<std::string>& given);

/// An error of reading the DXF, with the way out where it may come of its layers: the verb that lists them
/// and the option that says what they are.
Error with_way_out(Error error, std::string_view text, const std::string& file);

}  // namespace toile::app
