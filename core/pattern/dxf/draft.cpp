#include "core/pattern/dxf/draft.h"

#include <initializer_list>

namespace toile {

DxfType dxf_type_of(std::string_view name) {
  static const std::map<std::string_view, DxfType> kTypes{{"POLYLINE", DxfType::polyline},
                                                          {"VERTEX", DxfType::vertex},
                                                          {"SEQEND", DxfType::seqend},
                                                          {"LINE", DxfType::line},
                                                          {"ARC", DxfType::arc},
                                                          {"CIRCLE", DxfType::circle},
                                                          {"LWPOLYLINE", DxfType::lwpolyline},
                                                          {"TEXT", DxfType::text},
                                                          {"SPLINE", DxfType::spline},
                                                          {"ELLIPSE", DxfType::ellipse},
                                                          {"POINT", DxfType::point},
                                                          {"MTEXT", DxfType::mtext},
                                                          {"ATTRIB", DxfType::attribute},
                                                          {"INSERT", DxfType::insert},
                                                          {"BLOCK", DxfType::block}};
  const auto it = kTypes.find(name);
  return it == kTypes.end() ? DxfType::skipped : it->second;
}

bool wants(DxfType type, int code) {
  const auto any = [code](std::initializer_list<int> codes) {
    return code == kPaperSpace || std::find(codes.begin(), codes.end(), code) != codes.end();
  };
  switch (type) {
    case DxfType::polyline:
      return any({70, 230});
    case DxfType::vertex:
      return any({10, 20, 42, 70});
    case DxfType::lwpolyline:
      return any({10, 20, 42, 70, 90, 230});
    case DxfType::line:
      return any({10, 20, 11, 21});
    case DxfType::arc:
      return any({10, 20, 40, 50, 51, 230});
    case DxfType::circle:
      return any({10, 20, 40, 230});
    case DxfType::ellipse:
      return any({10, 20, 11, 21, 40, 41, 42, 230});
    case DxfType::spline:
      return any({10, 20, 11, 21, 40, 41, 70, 71, 72, 73});
    case DxfType::point:
      return any({10, 20, 30, 50});
    case DxfType::text:
    case DxfType::mtext:
    case DxfType::attribute:
      return any({10, 20, 40});
    case DxfType::insert:
      return any({10, 20, 41, 42, 50, 66, 70, 71, 230});
    case DxfType::block:
      return any({10, 20});
    default:
      return false;
  }
}

bool needs_numbers(DxfType type) {
  return type != DxfType::text && type != DxfType::mtext && type != DxfType::attribute &&
         type != DxfType::block && type != DxfType::skipped;
}

}  // namespace toile
