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
      {1, DxfRole::kCut},     {2, DxfRole::kTurn},   {3, DxfRole::kCurve},   {4, DxfRole::kNotch},
      {5, DxfRole::kGrade},   {6, DxfRole::kMirror}, {7, DxfRole::kGrain},   {8, DxfRole::kInternal},
      {9, DxfRole::kGuide},   {10, DxfRole::kGuide}, {11, DxfRole::kCutout}, {13, DxfRole::kDrill},
      {14, DxfRole::kSew},    {15, DxfRole::kText},  {80, DxfRole::kNotch},  {81, DxfRole::kNotch},
      {82, DxfRole::kNotch},  {83, DxfRole::kNotch}, {84, DxfRole::kRepeat}, {85, DxfRole::kRepeat},
      {86, DxfRole::kRepeat}, {87, DxfRole::kRepeat}};
  const auto it = kRoles.find(number);
  return it == kRoles.end() ? DxfRole::kOther : it->second;
}

DxfRole role_of_name(const std::string& layer) {
  static const std::map<std::string, DxfRole> kRoles{{"cut", DxfRole::kCut},
                                                     {"cutline", DxfRole::kCut},
                                                     {"cutting", DxfRole::kCut},
                                                     {"cuttingline", DxfRole::kCut},
                                                     {"boundary", DxfRole::kCut},
                                                     {"outline", DxfRole::kCut},
                                                     {"pieceboundary", DxfRole::kCut},
                                                     {"sew", DxfRole::kSew},
                                                     {"sewline", DxfRole::kSew},
                                                     {"sewing", DxfRole::kSew},
                                                     {"sewingline", DxfRole::kSew},
                                                     {"stitch", DxfRole::kSew},
                                                     {"stitchline", DxfRole::kSew},
                                                     {"seam", DxfRole::kSew},
                                                     {"seamline", DxfRole::kSew},
                                                     {"notch", DxfRole::kNotch},
                                                     {"notches", DxfRole::kNotch},
                                                     {"grain", DxfRole::kGrain},
                                                     {"grainline", DxfRole::kGrain},
                                                     {"mirror", DxfRole::kMirror},
                                                     {"mirrorline", DxfRole::kMirror},
                                                     {"fold", DxfRole::kMirror},
                                                     {"foldline", DxfRole::kMirror},
                                                     {"internal", DxfRole::kInternal},
                                                     {"internals", DxfRole::kInternal},
                                                     {"internalline", DxfRole::kInternal},
                                                     {"drill", DxfRole::kDrill},
                                                     {"drillhole", DxfRole::kDrill},
                                                     {"drillholes", DxfRole::kDrill},
                                                     {"cutout", DxfRole::kCutout},
                                                     {"cutouts", DxfRole::kCutout},
                                                     {"text", DxfRole::kText},
                                                     {"annotation", DxfRole::kText}};
  std::string name;
  for (const char c : lower_case(layer))
    if (c != ' ' && c != '_' && c != '-') name += c;
  const auto it = kRoles.find(name);
  return it == kRoles.end() ? DxfRole::kOther : it->second;
}

}  // namespace

DxfRole role_of_layer(const std::string& layer) {
  const std::optional<int> number = layer_number(layer);
  return number ? role_of_number(*number) : role_of_name(layer);
}

DxfRole repeated_role(const std::string& layer) {
  const int number = layer_number(layer).value_or(0);
  if (number == 84) return DxfRole::kCut;
  if (number == 85) return DxfRole::kInternal;
  if (number == 86) return DxfRole::kCutout;
  if (number == 87) return DxfRole::kSew;
  return role_of_layer(layer);
}

}  // namespace toile::dxf
