#include "core/pattern/dxf/places.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/text.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {
namespace {

constexpr int kDeepestBlocks = 8;            // blocks within blocks
constexpr std::size_t kMostParts = 100'000;  // blocks as they stand in the drawing, all sizes

/// Blocks of the program's own, such as *Model_Space and $Paper_Space.
bool is_internal(const DxfBlock& block) {
  return block.name.empty() || block.name.front() == '*' || block.name.front() == '$';
}

bool is_model_space(const DxfBlock& block) {
  const std::string name = lower_case(block.name);
  return name == "*model_space" || name == "$model_space";
}

/// "cm" of "1 unit = 1 cm"; nothing of what is no such equation.
std::optional<std::string> unit_of_scale(const std::string& value) {
  const std::size_t equals = value.find('=');
  if (equals == std::string::npos || lower_case(value.substr(0, equals)).find("unit") == std::string::npos)
    return std::nullopt;
  std::string_view right = trimmed(std::string_view(value).substr(equals + 1));
  if (right.starts_with("1 ")) right.remove_prefix(2);
  return std::string(trimmed(right));
}

/// Adds what the block's texts say of the whole drawing.
void hear_style(const DxfBlock& block, DxfPlaces& out) {
  for (const DxfText& text : block.texts) {
    const auto statement = statement_of(text.text);
    if (!statement) continue;
    const auto told = [&](const char* what) { out.notes.mark(text.entity, DxfFate::kConverted, what); };
    if (statement->key == "style name") {
      out.style.name = statement->value;
      told("name of the style");
    }
    if (statement->key == "sample size") {
      out.style.sample_size = statement->value;
      told("sample size");
    }
    const std::optional<std::string> scale = unit_of_scale(statement->value);
    if (statement->key == "units" || scale) {
      out.style.units.push_back({scale.value_or(statement->value), text.line});
      told("unit of the drawing");
    }
  }
}

/// The blocks of each name, in the file's order: careless programs use a name more than once.
using NamedBlocks = std::map<std::string, std::vector<const DxfBlock*>>;

NamedBlocks blocks_by_name(const DxfFile& file) {
  NamedBlocks named;
  for (const DxfBlock& block : file.blocks) named[block.name].push_back(&block);
  return named;
}

/// What inserts have put into the drawing so far.
struct Inserted {
  std::set<const DxfBlock*> used;  // only asked, never run through
  std::size_t parts = 0;
};

/// Adds the block and those that it inserts to the place.
void add_parts(const NamedBlocks& named, const DxfBlock& block, const DxfTransform& transform, int depth,
               DxfPlace& place, Inserted& inserted, DxfNotes& notes) {
  if (++inserted.parts > kMostParts) return;
  place.parts.push_back({&block, transform});
  for (const DxfInsert& insert : block.inserts) {
    const auto it = named.find(insert.block);
    if (it == named.end() || depth >= kDeepestBlocks) {
      notes.mark(insert.entity, DxfFate::kDropped,
                 depth >= kDeepestBlocks ? "blocks stand in blocks too deeply"
                                         : "the file does not hold the block that it names");
      notes.warn(insert.line, "INSERT of '" + insert.block + "' within a block is left out");
      continue;
    }
    const DxfBlock& inner = *it->second.front();
    inserted.used.insert(&inner);
    notes.mark(insert.entity, DxfFate::kKept, "puts a block within a block");
    add_parts(named, inner, transform.after(transform_of(insert, inner)), depth + 1, place, inserted, notes);
  }
}

DxfPlace place_of(const DxfBlock& block, int line) {
  DxfPlace place;
  place.is_block = true;
  place.block = block.name;
  place.line = line;
  return place;
}

void tell_unknown_block(const DxfInsert& insert, DxfNotes& notes) {
  notes.fail({"dxf.unknown_block",
              "INSERT names the block '" + insert.block + "', which the file does not hold.",
              line_text(insert.line)});
  notes.mark(insert.entity, DxfFate::kDropped, "the file does not hold the block that it names");
  notes.warn(insert.line, "INSERT names the block '" + insert.block + "', which the file does not hold");
}

/// Adds a place for each insert. Of several blocks of one name the first insert means the first, and so on.
void add_inserted(const NamedBlocks& named, const DxfBlock& drawing, DxfPlaces& out, Inserted& inserted) {
  std::map<std::string, std::size_t> taken;
  for (const DxfInsert& insert : drawing.inserts) {
    const auto it = named.find(insert.block);
    if (it == named.end()) {
      tell_unknown_block(insert, out.notes);
      continue;
    }
    const std::vector<const DxfBlock*>& blocks = it->second;
    const DxfBlock& block = *blocks[std::min(taken[insert.block]++, blocks.size() - 1)];
    if (blocks.size() > 1)
      out.notes.warn(insert.line, "several blocks are called '" + insert.block + "': taken by their order");
    inserted.used.insert(&block);
    DxfPlace place = place_of(block, insert.line);
    add_parts(named, block, transform_of(insert, block), 1, place, inserted, out.notes);
    out.notes.mark(insert.entity, DxfFate::kKept, "puts a block in its place");
    out.places.push_back(std::move(place));
  }
}

bool states_a_piece(const DxfBlock& block) {
  return std::any_of(block.texts.begin(), block.texts.end(), [](const DxfText& t) {
    const auto statement = statement_of(t.text);
    return statement && statement->key == "piece name";
  });
}

/// Blocks that nothing inserts hold pieces when they say so, or when there is nothing else.
void add_left_over(const NamedBlocks& named, const DxfFile& file, DxfPlaces& out, Inserted& inserted) {
  const bool nothing_else = out.places.empty();
  for (const DxfBlock& block : file.blocks) {
    if (inserted.used.contains(&block) || is_internal(block) || block.curves.empty()) continue;
    if (!nothing_else && !states_a_piece(block)) continue;
    if (!nothing_else)
      out.notes.warn(block.line, "the block '" + block.name + "' holds a piece that nothing inserts");
    DxfPlace place = place_of(block, block.line);
    add_parts(named, block, {}, 1, place, inserted, out.notes);
    out.places.push_back(std::move(place));
  }
}

/// What stands behind the last '_' or '-' of the name; empty where nothing stands before or behind it.
std::string ending_of(const std::string& name) {
  std::size_t bar = name.rfind('_');
  if (bar == std::string::npos) bar = name.rfind('-');
  return bar == std::string::npos || bar == 0 ? "" : name.substr(bar + 1);
}

/// The place with what its texts state of it.
DxfPlace described(DxfPlace place) {
  if (!place.is_block) return place;
  for (const DxfPart& part : place.parts) {
    for (const DxfText& text : part.block->texts) {
      const auto statement = statement_of(text.text);
      if (!statement) continue;
      place.statements.push_back(&text);
      if (statement->key == "piece name" && !place.name_is_stated && !is_lost(statement->value) &&
          !statement->value.empty()) {
        place.name = statement->value;
        place.name_is_stated = true;
      }
      if (statement->key == "size" && place.size.empty()) place.size = statement->value;
    }
  }
  if (place.size.empty()) place.ending = ending_of(place.block);
  if (place.name_is_stated) return place;
  place.name = place.block;
  if (!place.size.empty() && lower_case(place.name).ends_with("_" + lower_case(place.size)))
    place.name.resize(place.name.size() - place.size.size() - 1);
  return place;
}

bool lie_apart(const std::vector<Aabb2>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = i + 1; k < boxes.size(); ++k)
      if (boxes[i].low.x < boxes[k].high.x && boxes[k].low.x < boxes[i].high.x &&
          boxes[i].low.y < boxes[k].high.y && boxes[k].low.y < boxes[i].high.y)
        return false;
  return true;
}

/// The places that stand twice where they are: some programs write the place of a piece into its vertices and
/// into its INSERT. Pieces that lie apart by their vertices alone need no further offsets. Their numbers, or
/// none.
std::vector<std::size_t> moved_twice(const std::vector<DxfPlace>& places) {
  constexpr std::size_t kMost = 2000;
  std::vector<std::size_t> moved;
  std::vector<Aabb2> boxes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const DxfPlace& place = places[i];
    if (!place.is_block || place.parts.size() != 1) continue;
    const DxfTransform& t = place.parts[0].transform;
    const bool only_moved = t.x == Vec2{1, 0} && t.y == Vec2{0, 1};
    const auto box = box_of(*place.parts[0].block);
    if (!only_moved || !box || !(place.parts[0].block->base == Vec2{})) return {};
    if (!(t.origin == Vec2{})) moved.push_back(i);
    boxes.push_back(*box);
  }
  if (boxes.size() < 2 || boxes.size() > kMost || !lie_apart(boxes)) return {};
  return moved;
}

/// The block that holds the drawing: that of the model space where nothing stands in the entities themselves.
const DxfBlock& drawing_of(const DxfFile& file) {
  const DxfBlock* drawing = &file.entities;
  for (const DxfBlock& block : file.blocks)
    if (file.entities.is_empty() && is_model_space(block) && !block.is_empty()) drawing = &block;
  return *drawing;
}

}  // namespace

std::optional<Aabb2> box_of(const DxfBlock& block) {
  std::vector<Vec2> points;
  for (const DxfCurve& c : block.curves)
    for (const DxfVertex& v : c.vertices) points.push_back(v.at);
  if (points.empty()) return std::nullopt;
  return bounding_box(points);
}

Result<DxfPlaces> places_of(const DxfFile& file) {
  DxfPlaces out;
  hear_style(file.entities, out);
  for (const DxfBlock& block : file.blocks)
    if (file.entities.is_empty() && is_model_space(block)) hear_style(block, out);
  const NamedBlocks named = blocks_by_name(file);
  const DxfBlock& drawing = drawing_of(file);
  Inserted inserted;
  add_inserted(named, drawing, out, inserted);
  if (!drawing.curves.empty()) {
    DxfPlace place;
    place.parts = {{&drawing, {}}};
    out.places.push_back(std::move(place));
  }
  add_left_over(named, file, out, inserted);
  if (inserted.parts > kMostParts)
    return Error{"dxf.too_large",
                 "The drawing inserts more than " + std::to_string(kMostParts) + " blocks, the limit.", "",
                 ErrorKind::kTooLarge};
  for (DxfPlace& place : out.places) place = described(std::move(place));
  const std::vector<std::size_t> moved = moved_twice(out.places);
  for (const std::size_t i : moved) out.places[i].parts[0].transform.origin = {};
  if (!moved.empty())
    out.notes.warn(out.places[moved[0]].line,
                   "the blocks' vertices have their place in the drawing already: the INSERTs' offsets are "
                   "passed over");
  return out;
}

}  // namespace toile::dxf
