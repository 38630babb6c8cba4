#include "core/pattern/dxf/layer_use.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "core/base/names.h"
#include "core/pattern/dxf/roles.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {
namespace {

/// Kinds of entities and how many there are, by layer.
using Counts = std::map<std::string, std::map<std::string, std::size_t>>;

Counts counts_of(const DxfReport& report) {
  Counts counts;
  for (const DxfEntityGroup& group : report.groups) counts[group.layer][group.type] += group.lines.size();
  return counts;
}

/// Layers of lines and points by whether the places that they stand in go by AAMA's layers.
struct Drawn {
  std::set<std::string> by_aama, by_shape;
};

Drawn drawn_in(const std::vector<DxfPlace>& places, const DxfLayerMap& given) {
  Drawn drawn;
  for (const DxfPlace& place : places) {
    std::set<std::string> layers;
    bool by_aama = false;
    for (const DxfPart& part : place.parts) {
      for (const DxfCurve& curve : part.block->curves) {
        layers.insert(curve.layer);
        by_aama = by_aama || makes_aama(curve.layer, given);
      }
      for (const DxfMark& mark : part.block->marks) layers.insert(mark.layer);
    }
    (by_aama ? drawn.by_aama : drawn.by_shape).insert(layers.begin(), layers.end());
  }
  return drawn;
}

/// Those with numbers by these, then the others by name.
bool stands_before(const DxfLayerUse& a, const DxfLayerUse& b) {
  const auto key = [](const DxfLayerUse& use) {
    return std::tuple(layer_number(use.name).value_or(std::numeric_limits<int>::max()), use.name);
  };
  return key(a) < key(b);
}

template <typename T>
void leave_out(std::vector<T>& drawn, const DxfLayerMap& given, DxfLog& log) {
  std::erase_if(drawn, [&](const T& one) {
    if (given_role(one.layer, given) != DxfRole::kIgnored) return false;
    if constexpr (requires { one.text; })
      if (statement_of(one.text)) return false;
    log.mark(one.entity, DxfFate::kDropped, "its layer is ignored, as was asked");
    return true;
  });
}

}  // namespace

std::vector<DxfLayerUse> layer_uses(const DxfReport& report, const std::vector<DxfPlace>& places,
                                    const DxfLayerMap& given) {
  const Drawn drawn = drawn_in(places, given);
  std::vector<DxfLayerUse> uses;
  for (const auto& [layer, kinds] : counts_of(report)) {
    DxfLayerUse& use = uses.emplace_back();
    use.name = layer;
    use.role = role_of_layer(layer, given);
    use.given = given_role(layer, given).has_value();
    use.drawn = drawn.by_aama.contains(layer) || drawn.by_shape.contains(layer);
    use.by_shape =
        !told_role(layer, 0, given) && !drawn.by_aama.contains(layer) && drawn.by_shape.contains(layer);
    use.kinds.assign(kinds.begin(), kinds.end());
    for (const auto& [kind, count] : kinds) use.entities += count;
  }
  std::sort(uses.begin(), uses.end(), stands_before);
  return uses;
}

Status check_layers(const DxfFile& file, const DxfLayerMap& given) {
  if (given.empty()) return {};
  const Counts counts = counts_of(file.log.report({}));
  std::vector<std::string> names;
  names.reserve(counts.size());
  for (const auto& [layer, kinds] : counts) names.push_back(layer);
  for (const auto& [layer, role] : given)
    if (!counts.contains(layer))
      return Error{"dxf.unknown_layer",
                   "the file has no layer " + in_quotes(layer) + "; " + advice(layer, names), ""};
  return {};
}

DxfFile without_ignored(DxfFile file, const DxfLayerMap& given) {
  const auto of_block = [&](DxfBlock& block) {
    leave_out(block.curves, given, file.log);
    leave_out(block.marks, given, file.log);
    leave_out(block.texts, given, file.log);
  };
  of_block(file.entities);
  for (DxfBlock& block : file.blocks) of_block(block);
  return file;
}

}  // namespace toile::dxf
