#include "server/app/layer_option.h"

#include <CLI/CLI.hpp>

#include "core/pattern/dxf/read.h"

namespace toile::app {

void add_layer_option(CLI::App& verb, std::vector<std::string>& layers) {
  std::string words;
  for (const std::string& word : dxf::given_role_words()) words += (words.empty() ? "" : ", ") + word;
  verb.add_option("--layer", layers,
                  "LAYER=WHAT: what a layer of a DXF file stands for, where its number or name says it\n"
                  "wrong: " +
                      words + ". May be given several times")
      ->allow_extra_args(false);
}

Result<dxf::DxfLayerMap> read_layers(const std::vector<std::string>& given) {
  dxf::DxfLayerMap layers;
  for (const std::string& text : given) {
    const std::size_t sign = text.rfind('=');
    if (sign == std::string::npos)
      return Error{"pattern.layer", "this is LAYER=WHAT, such as 3=sew", "--layer " + text};
    const Result<dxf::DxfRole> role = dxf::role_named(text.substr(sign + 1));
    if (!role) return placed_at(role.error(), "--layer " + text);
    layers[text.substr(0, sign)] = *role;
  }
  return layers;
}

Error with_way_out(Error error, std::string_view text, const std::string& file) {
  if (dxf::layers_may_help(text, error))
    error.message +=
        " If the outlines stand on another layer than usual: toile pattern layers " + file +
        " lists what there is, and --layer NAME=cut (or sew, internal, ignore, ...) says what a layer is.";
  return error;
}

}  // namespace toile::app
