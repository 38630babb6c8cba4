#pragma once
// Damage to bytes as a list of strokes, so that rapidcheck finds the fewest of them that still fail.

#include <rapidcheck.h>

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace toile::test {

enum class Blow { kFlip, kSet, kTruncate, kAppend, kErase, kDouble };

struct Stroke {
  Blow blow = Blow::kFlip;
  std::uint32_t at = 0;  ///< modulo the size then
  std::uint8_t value = 0;
};

inline void strike(std::string& bytes, const Stroke& stroke) {
  if (bytes.empty()) return;
  const std::size_t at = stroke.at % bytes.size(), few = 1u + stroke.value % 20u;
  switch (stroke.blow) {
    case Blow::kFlip:
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << stroke.value % 8));
      break;
    case Blow::kSet:
      bytes[at] = static_cast<char>(stroke.value);
      break;
    case Blow::kTruncate:
      bytes.resize(at);
      break;
    case Blow::kAppend:
      bytes.append(few, static_cast<char>(stroke.value));
      break;
    case Blow::kErase:
      bytes.erase(at, few);
      break;
    case Blow::kDouble:
      bytes.insert(at, bytes.substr(at, few));
      break;
  }
}

inline std::string struck(std::string bytes, const std::vector<Stroke>& strokes) {
  for (const Stroke& stroke : strokes) strike(bytes, stroke);
  return bytes;
}

inline void showValue(const Stroke& stroke, std::ostream& out) {
  out << "{blow " << static_cast<int>(stroke.blow) << " at " << stroke.at << " with " << int{stroke.value}
      << "}";
}

/// One to four strokes. `values` says what bytes they bring.
inline rc::Gen<std::vector<Stroke>> damage(const rc::Gen<std::uint8_t>& values) {
  const auto blows =
      rc::gen::element(Blow::kFlip, Blow::kSet, Blow::kTruncate, Blow::kAppend, Blow::kErase, Blow::kDouble);
  const auto stroke = rc::gen::build<Stroke>(
      rc::gen::set(&Stroke::blow, blows),
      rc::gen::set(&Stroke::at, rc::gen::resize(100, rc::gen::arbitrary<std::uint32_t>())),
      rc::gen::set(&Stroke::value, rc::gen::resize(100, values)));
  return rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 5), [=](std::size_t count) {
    return rc::gen::container<std::vector<Stroke>>(count, stroke);
  });
}

}  // namespace toile::test
