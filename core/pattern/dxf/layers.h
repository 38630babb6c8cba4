#pragma once
// What the layers of a pattern drawing stand for.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace toile::dxf {

/// By the numbers of ANSI/AAMA-292 and ASTM D6673, and by the names that people give.
enum class DxfRole {
  kCut,       ///< 1
  kTurn,      ///< 2: points where the outline turns
  kCurve,     ///< 3: points on its curves
  kNotch,     ///< 4, and 80 to 83 for other shapes of notch
  kGrade,     ///< 5
  kMirror,    ///< 6
  kGrain,     ///< 7
  kInternal,  ///< 8
  kGuide,     ///< 9, 10: stripes and plaids
  kCutout,    ///< 11
  kDrill,     ///< 13
  kSew,       ///< 14
  kText,      ///< 15
  kRepeat,    ///< 84, 85, 86, 87: layers 1, 8, 11, 14 once more, more closely drawn
  kOther,
  kIgnored  ///< only ever given: what is drawn there is not read
};

/// What a person says that layers stand for, by their names in the file: it counts before numbers and names.
using DxfLayerMap = std::map<std::string, DxfRole>;

/// What the map gives the layer; nothing where it does not speak of it.
std::optional<DxfRole> given_role(const std::string& layer, const DxfLayerMap& given);

/// What holds of a line so long (a point: 0) in any drawing, whether its layers have AAMA's meaning or not:
/// what is given, and that a layer is one of notches or of grain lines by its name, in many languages.
std::optional<DxfRole> told_role(const std::string& layer, double length_mm, const DxfLayerMap& given);

/// As given, else by the layer's number or name.
DxfRole role_of_layer(const std::string& layer, const DxfLayerMap& given = {});

/// Of a layer that repeats another one at another density: the other one's role. Else its own.
DxfRole repeated_role(const std::string& layer, const DxfLayerMap& given = {});

/// The number in a layer's name: 14 of "14", "Layer 14", "AAMA-14".
std::optional<int> layer_number(const std::string& layer);

/// "cut", "sew", …, as reports and documents have it.
std::string_view role_word(DxfRole role);

/// The words of the roles that a layer can be given, in the order in which a person would look for them.
std::vector<std::string> given_role_words();

/// The role that a layer is given by this word. Error: dxf.unknown_role.
Result<DxfRole> role_named(const std::string& word);

/// One layer of a drawing.
struct DxfLayerUse {
  std::string name;
  DxfRole role = DxfRole::kOther;
  /// Nothing tells what it is: its closed lines are pieces and holes by how they lie, whatever `role` says.
  bool by_shape = false;
  bool drawn = false;        ///< lines or points stand on it, in what is read of the file
  bool given = false;        ///< a person says what it is
  std::size_t entities = 0;  ///< in the whole file, all sizes
  std::vector<std::pair<std::string, std::size_t>> kinds;  ///< POLYLINE, TEXT, …, and how many of each
};

/// "cut", "sew", …, "shape": what it is read as, in a word.
std::string_view read_as(const DxfLayerUse& layer);

}  // namespace toile::dxf
