#include "core/body/mesh_import/message.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "core/body/mesh_import/load.h"

namespace toile::mesh_import {
namespace {

static_assert(std::endian::native == std::endian::little, "both sides run on one machine");

constexpr std::string_view kOpening = "TOILEMSH";
constexpr std::size_t kLongestText = 1000;  // bytes of an error's texts
constexpr std::uint32_t kError = 0, kMesh = 1;

/// Visits each count of a MeshRepairs; the binding keeps a new one from being forgotten.
template <typename Visit>
void each_count(MeshRepairs& repairs, Visit visit) {
  auto& [welded, flat, doubled, crowded, parted, turned, holes, filling, shells, open, borders, one_sided] =
      repairs;
  for (int* count : {&welded, &flat, &doubled, &crowded, &parted, &turned, &holes, &filling, &shells, &open,
                     &borders, &one_sided}) {
    visit(*count);
  }
}

void put(std::string& out, std::uint32_t value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <typename T>
void put_all(std::string& out, const std::vector<T>& values) {
  out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// Takes values off the front; `whole` turns false where there are too few.
class MessageReader {
 public:
  explicit MessageReader(std::string_view bytes) : bytes_(bytes) {}
  std::string_view take(std::size_t count) {
    whole_ = whole_ && count <= bytes_.size();
    const std::string_view taken = whole_ ? bytes_.substr(0, count) : std::string_view();
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  std::uint32_t number() {
    std::uint32_t value = 0;
    const std::string_view taken = take(sizeof value);
    if (whole_) std::memcpy(&value, taken.data(), sizeof value);
    return value;
  }
  template <typename T>
  std::vector<T> list(std::size_t count) {
    std::vector<T> out;
    const std::string_view taken = take(count * sizeof(T));
    if (!whole_ || count == 0) return out;  // an empty list has no address, and memcpy wants one
    out.resize(count);
    std::memcpy(out.data(), taken.data(), taken.size());
    return out;
  }
  bool whole() const { return whole_; }
  bool at_end() const { return whole_ && bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool whole_ = true;
};

/// What the other side may name: the kinds of an error by their number.
constexpr auto kLastKind = static_cast<std::uint32_t>(ErrorKind::kInternal);

Error no_message() {
  return {
      "mesh.crashed",
      "The mesh reader gave no whole answer. The file is damaged, or of a kind that the reader cannot take; "
      "export it anew, as OBJ, STL or GLB.",
      ""};
}

/// A text of the other side, printable and not too long.
std::string text_of(std::string_view bytes) {
  // Whatever the reader says ends on a terminal or in a page.
  std::string text(bytes.substr(0, kLongestText));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c >= 0 && c < 0x20; }, ' ');
  return text;
}

bool is_code(std::string_view text) {
  return text.starts_with("mesh.") && text.size() < 40 && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || c == '.' || c == '_';
         });
}

Error error_of(MessageReader& reader) {
  const std::uint32_t kind = reader.number();
  std::string texts[3];
  for (std::string& text : texts) text = text_of(reader.take(reader.number()));
  if (!reader.at_end() || !is_code(texts[0]) || kind > kLastKind) return no_message();
  return {texts[0], texts[1], texts[2], static_cast<ErrorKind>(kind)};
}

bool is_sound(const geometry::TriangleMesh& mesh) {
  const auto count = static_cast<Index>(mesh.vertices.size());
  const auto there = [count](Index v) { return v >= 0 && v < count; };
  return !mesh.triangles.empty() &&
         std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](Vec3 p) { return is_finite(p); }) &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Tri& t) {
           return there(t[0]) && there(t[1]) && there(t[2]) && t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
         });
}

}  // namespace

std::string mesh_message(const Result<RepairedMesh>& mesh) {
  std::string out(kOpening);
  if (!mesh) {
    put(out, kError);
    put(out, static_cast<std::uint32_t>(mesh.error().kind));
    for (const std::string& text : {mesh.error().code, mesh.error().message, mesh.error().where}) {
      put(out, static_cast<std::uint32_t>(text.size()));
      out += text;
    }
    return out;
  }
  put(out, kMesh);
  MeshRepairs repairs = mesh->repairs;
  each_count(repairs, [&](int count) { put(out, static_cast<std::uint32_t>(count)); });
  put(out, static_cast<std::uint32_t>(mesh->mesh.vertices.size()));
  put(out, static_cast<std::uint32_t>(mesh->mesh.triangles.size()));
  put_all(out, mesh->mesh.vertices);
  put_all(out, mesh->mesh.triangles);
  return out;
}

Result<RepairedMesh> parse_mesh_message(std::string_view bytes) {
  MessageReader reader(bytes);
  if (reader.take(kOpening.size()) != kOpening) return no_message();
  const std::uint32_t kind = reader.number();
  if (reader.whole() && kind == kError) return error_of(reader);
  if (kind != kMesh) return no_message();
  RepairedMesh out;
  bool countable = true;
  each_count(out.repairs, [&](int& count) {
    const std::uint32_t number = reader.number();
    countable = countable && std::in_range<int>(number);
    count = countable ? static_cast<int>(number) : 0;
  });
  if (!countable) return no_message();
  const std::size_t vertices = reader.number(), triangles = reader.number();
  out.mesh.vertices = reader.list<Vec3>(vertices);
  out.mesh.triangles = reader.list<Tri>(triangles);
  if (!reader.at_end() || !is_sound(out.mesh)) return no_message();
  return out;
}

}  // namespace toile::mesh_import
