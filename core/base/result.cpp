#include "core/base/result.h"

namespace toile {

std::string to_string(const Error& error) {
  std::string text = error.code + ": " + error.message;
  if (!error.where.empty()) text += " (" + error.where + ")";
  return text;
}

Error placed_at(Error error, std::string where) {
  error.where = std::move(where);
  return error;
}

}  // namespace toile
