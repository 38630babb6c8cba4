#include "core/pattern/dxf/layers.h"

#include <map>
#include <optional>

#include "core/base/text.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {
namespace {

/// The number of "1", "01", "Layer 1", "LAYER_14", "AAMA-8".
std::optional<int> layer_number(const std::string& layer) {
  std::string name = lower_case(layer);
  for (const char* prefix : {"layer", "aama", "astm", "l"}) {
    if (!name.starts_with(prefix)) continue;
    name.erase(0, std::string(prefix).size());
    break;
  }
  const std::size_t begin = name.find_first_not_of(" _-");
  if (begin == std::string::npos) return std::nullopt;
  return number_in<int>(std::string_view(name).substr(begin));
}

DxfRole role_of_number(int number) {
  static const std::map<int, DxfRole> kRoles{
      {1, DxfRole::cut},     {2, DxfRole::turn},   {3, DxfRole::curve},   {4, DxfRole::notch},
      {5, DxfRole::grade},   {6, DxfRole::mirror}, {7, DxfRole::grain},   {8, DxfRole::internal},
      {9, DxfRole::guide},   {10, DxfRole::guide}, {11, DxfRole::cutout}, {13, DxfRole::drill},
      {14, DxfRole::sew},    {15, DxfRole::text},  {80, DxfRole::notch},  {81, DxfRole::notch},
      {82, DxfRole::notch},  {83, DxfRole::notch}, {84, DxfRole::repeat}, {85, DxfRole::repeat},
      {86, DxfRole::repeat}, {87, DxfRole::repeat}};
  const auto it = kRoles.find(number);
  return it == kRoles.end() ? DxfRole::other : it->second;
}

DxfRole role_of_name(const std::string& layer) {
  static const std::map<std::string, DxfRole> kRoles{{"cut", DxfRole::cut},
                                                     {"cutline", DxfRole::cut},
                                                     {"cutting", DxfRole::cut},
                                                     {"cuttingline", DxfRole::cut},
                                                     {"boundary", DxfRole::cut},
                                                     {"outline", DxfRole::cut},
                                                     {"pieceboundary", DxfRole::cut},
                                                     {"sew", DxfRole::sew},
                                                     {"sewline", DxfRole::sew},
                                                     {"sewing", DxfRole::sew},
                                                     {"sewingline", DxfRole::sew},
                                                     {"stitch", DxfRole::sew},
                                                     {"stitchline", DxfRole::sew},
                                                     {"seam", DxfRole::sew},
                                                     {"seamline", DxfRole::sew},
                                                     {"notch", DxfRole::notch},
                                                     {"notches", DxfRole::notch},
                                                     {"grain", DxfRole::grain},
                                                     {"grainline", DxfRole::grain},
                                                     {"mirror", DxfRole::mirror},
                                                     {"mirrorline", DxfRole::mirror},
                                                     {"fold", DxfRole::mirror},
                                                     {"foldline", DxfRole::mirror},
                                                     {"internal", DxfRole::internal},
                                                     {"internals", DxfRole::internal},
                                                     {"internalline", DxfRole::internal},
                                                     {"drill", DxfRole::drill},
                                                     {"drillhole", DxfRole::drill},
                                                     {"drillholes", DxfRole::drill},
                                                     {"cutout", DxfRole::cutout},
                                                     {"cutouts", DxfRole::cutout},
                                                     {"text", DxfRole::text},
                                                     {"annotation", DxfRole::text}};
  std::string name;
  for (const char c : lower_case(layer))
    if (c != ' ' && c != '_' && c != '-') name += c;
  const auto it = kRoles.find(name);
  return it == kRoles.end() ? DxfRole::other : it->second;
}

}  // namespace

DxfRole role_of_layer(const std::string& layer) {
  const std::optional<int> number = layer_number(layer);
  return number ? role_of_number(*number) : role_of_name(layer);
}

DxfRole repeated_role(const std::string& layer) {
  const int number = layer_number(layer).value_or(0);
  if (number == 84) return DxfRole::cut;
  if (number == 85) return DxfRole::internal;
  if (number == 86) return DxfRole::cutout;
  if (number == 87) return DxfRole::sew;
  return role_of_layer(layer);
}

}  // namespace toile::dxf
