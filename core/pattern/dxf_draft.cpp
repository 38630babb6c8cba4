#include "core/pattern/dxf_draft.h"

#include <initializer_list>

namespace toile {

DxfType dxf_type_of(std::string_view name) {
  static const std::map<std::string_view, DxfType> kTypes{{"POLYLINE", DxfType::polyline},
                                                          {"VERTEX", DxfType::vertex},
                                                          {"SEQEND", DxfType::seqend},
                                                          {"LINE", DxfType::line},
                                                          {"LWPOLYLINE", DxfType::lwpolyline},
                                                          {"ARC", DxfType::arc},
                                                          {"CIRCLE", DxfType::circle},
                                                          {"SPLINE", DxfType::spline},
                                                          {"TEXT", DxfType::text},
                                                          {"INSERT", DxfType::insert},
                                                          {"BLOCK", DxfType::block}};
  const auto it = kTypes.find(name);
  return it == kTypes.end() ? DxfType::skipped : it->second;
}

bool wants(DxfType type, int code) {
  const auto any = [code](std::initializer_list<int> codes) {
    return std::find(codes.begin(), codes.end(), code) != codes.end();
  };
  switch (type) {
    case DxfType::polyline:
      return any({70, 230, kPaperSpace});
    case DxfType::vertex:
      return any({10, 20, 42, 70});
    case DxfType::lwpolyline:
      return any({10, 20, 42, 70, 230, kPaperSpace});
    case DxfType::line:
      return any({10, 20, 11, 21, kPaperSpace});
    case DxfType::arc:
      return any({10, 20, 40, 50, 51, 230, kPaperSpace});
    case DxfType::circle:
      return any({10, 20, 40, 230, kPaperSpace});
    case DxfType::spline:
      return any({10, 20, 40, 41, 70, 71, kPaperSpace});
    case DxfType::text:
      return any({10, 20});
    case DxfType::insert:
      return any({10, 20, 41, 42, 50, 70, 71, 230, kPaperSpace});
    case DxfType::block:
      return any({10, 20});
    default:
      return false;
  }
}

}  // namespace toile
