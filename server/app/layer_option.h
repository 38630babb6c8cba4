#pragma once
// --layer: what the layers of a DXF file stand for, as the command line spells it.

#include <string>
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

}  // namespace toile::app
