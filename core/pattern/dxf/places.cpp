#include "core/pattern/dxf/places.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/words.h"

namespace toile {
namespace {

constexpr int kDeepest = 8;                  // blocks within blocks
constexpr std::size_t kMostParts = 100'000;  // blocks as they stand in the drawing, all sizes

/// Blocks of the program's own, such as *Model_Space and $Paper_Space.
bool is_internal(const DxfBlock& block) {
  return block.name.empty() || block.name.front() == '*' || block.name.front() == '$';
}

bool is_model_space(const DxfBlock& block) {
  const std::string name = lower(block.name);
  return name == "*model_space" || name == "$model_space";
}

/// The box of all that is drawn in the block, in its own coordinates.
std::optional<Aabb2> box_of(const DxfBlock& block) {
  std::vector<Vec2> points;
  for (const DxfCurve& c : block.curves)
    for (const DxfVertex& v : c.vertices) points.push_back(v.at);
  if (points.empty()) return std::nullopt;
  return bounding_box(points);
}

class Finder {
 public:
  Finder(DxfFile& file, const DxfSettings& settings) : file_(file), settings_(settings) {
    for (const DxfBlock& block : file_.blocks) named_[block.name].push_back(&block);
  }

  Result<DxfLayout> run() {
    hear_style(file_.entities);
    const DxfBlock* drawing = &file_.entities;
    for (const DxfBlock& block : file_.blocks)
      if (file_.entities.is_empty() && is_model_space(block) && !block.is_empty()) {
        drawing = &block;
        hear_style(block);
      }
    find_inserts(*drawing);
    if (!drawing->curves.empty()) {
      DxfPlace place;
      place.parts = {{drawing, {}}};
      layout_.places.push_back(std::move(place));
    }
    find_left_over();
    if (parts_ > kMostParts)
      return Error{"dxf.too_large",
                   "The drawing inserts more than " + std::to_string(kMostParts) + " blocks, the limit.", ""};
    for (DxfPlace& place : layout_.places) describe(place);
    forget_offsets();
    if (auto error = choose_size()) return *error;
    return std::move(layout_);
  }

 private:
  void hear_style(const DxfBlock& block) {
    for (const DxfText& text : block.texts) {
      const auto statement = statement_of(text.text);
      if (!statement) continue;
      DxfStyle& style = layout_.style;
      const auto told = [&](const char* what) { file_.log.mark(text.entity, DxfFate::converted, what); };
      if (statement->key == "style name") {
        style.name = statement->value;
        told("name of the style");
      }
      if (statement->key == "sample size" || statement->key == "base size") {
        style.sample_size = statement->value;
        told("sample size");
      }
      if (statement->key == "units" || statement->key == "unit") {
        style.units.push_back({statement->value, text.line});
        told("unit of the drawing");
      }
    }
  }

  void find_inserts(const DxfBlock& drawing) {
    for (const DxfInsert& insert : drawing.inserts) {
      const DxfBlock* block = take_block(insert);
      if (!block) continue;
      DxfPlace place;
      place.is_block = true;
      place.block = block->name;
      place.line = insert.line;
      add_parts(place, *block, transform_of(insert, *block), 1);
      file_.log.mark(insert.entity, DxfFate::kept, "puts a block in its place");
      layout_.places.push_back(std::move(place));
    }
  }

  /// The block that the insert means: of several of one name the first, the second, … by the inserts' order.
  const DxfBlock* take_block(const DxfInsert& insert) {
    const auto it = named_.find(insert.block);
    if (it == named_.end()) {
      if (!file_.fault)
        file_.fault = Error{"dxf.unknown_block",
                            "INSERT names the block '" + insert.block + "', which the file does not hold.",
                            line_text(insert.line)};
      file_.log.mark(insert.entity, DxfFate::dropped, "the file does not hold the block that it names");
      file_.log.warn(insert.line,
                     "INSERT names the block '" + insert.block + "', which the file does not hold");
      return nullptr;
    }
    const std::size_t turn = std::min(taken_[insert.block]++, it->second.size() - 1);
    if (it->second.size() > 1)
      file_.log.warn(insert.line, "several blocks are called '" + insert.block + "': taken by their order");
    used_.insert(it->second[turn]);
    return it->second[turn];
  }

  void add_parts(DxfPlace& place, const DxfBlock& block, const DxfTransform& transform, int depth) {
    if (++parts_ > kMostParts) return;
    place.parts.push_back({&block, transform});
    for (const DxfInsert& insert : block.inserts) {
      const auto it = named_.find(insert.block);
      if (it == named_.end() || depth >= kDeepest) {
        file_.log.mark(insert.entity, DxfFate::dropped,
                       depth >= kDeepest ? "blocks stand in blocks too deeply"
                                         : "the file does not hold the block that it names");
        file_.log.warn(insert.line, "INSERT of '" + insert.block + "' within a block is left out");
        continue;
      }
      const DxfBlock& inner = *it->second.front();
      used_.insert(&inner);
      file_.log.mark(insert.entity, DxfFate::kept, "puts a block within a block");
      add_parts(place, inner, transform.after(transform_of(insert, inner)), depth + 1);
    }
  }

  /// Blocks that nothing inserts hold pieces when they say so, or when there is nothing else.
  void find_left_over() {
    const bool nothing_else = layout_.places.empty();
    for (const DxfBlock& block : file_.blocks) {
      if (used_.contains(&block) || is_internal(block) || block.curves.empty()) continue;
      const bool says_so = std::any_of(block.texts.begin(), block.texts.end(), [](const DxfText& t) {
        const auto statement = statement_of(t.text);
        return statement && statement->key == "piece name";
      });
      if (!nothing_else && !says_so) continue;
      if (!nothing_else)
        file_.log.warn(block.line, "the block '" + block.name + "' holds a piece that nothing inserts");
      DxfPlace place;
      place.is_block = true;
      place.block = block.name;
      place.line = block.line;
      add_parts(place, block, {}, 1);
      layout_.places.push_back(std::move(place));
    }
  }

  void describe(DxfPlace& place) {
    if (!place.is_block) return;
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
    std::size_t bar = place.block.rfind('_');
    if (bar == std::string::npos) bar = place.block.rfind('-');
    if (place.size.empty() && bar != std::string::npos && bar > 0 && bar + 1 < place.block.size())
      suffixes_[&place - layout_.places.data()] = place.block.substr(bar + 1);
    if (place.name_is_stated) return;
    place.name = place.block;
    if (!place.size.empty() && lower(place.name).ends_with("_" + lower(place.size)))
      place.name.resize(place.name.size() - place.size.size() - 1);
  }

  /// Some programs write the place of a piece into its vertices and into its INSERT. Pieces that lie apart by
  /// their vertices alone need no further offsets.
  void forget_offsets() {
    std::vector<std::pair<DxfPlace*, Aabb2>> moved;
    std::vector<Aabb2> boxes;
    for (DxfPlace& place : layout_.places) {
      if (!place.is_block || place.parts.size() != 1) continue;
      const DxfTransform& t = place.parts[0].transform;
      const bool only_moved = t.x == Vec2{1, 0} && t.y == Vec2{0, 1};
      const auto box = box_of(*place.parts[0].block);
      if (!only_moved || !box || !(place.parts[0].block->base == Vec2{})) return;
      if (!(t.origin == Vec2{})) moved.emplace_back(&place, *box);
      boxes.push_back(*box);
    }
    constexpr std::size_t kMost = 2000;
    if (moved.empty() || boxes.size() < 2 || boxes.size() > kMost) return;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t k = i + 1; k < boxes.size(); ++k)
        if (boxes[i].low.x < boxes[k].high.x && boxes[k].low.x < boxes[i].high.x &&
            boxes[i].low.y < boxes[k].high.y && boxes[k].low.y < boxes[i].high.y)
          return;
    for (auto& [place, box] : moved) place->parts[0].transform.origin = {};
    file_.log.warn(moved[0].first->line,
                   "the blocks' vertices have their place in the drawing already: the INSERTs' offsets are "
                   "passed over");
  }

  std::optional<Error> choose_size() {
    read_suffixes();
    std::map<std::string, std::set<std::string>> sizes_of;  // piece → its sizes
    for (const DxfPlace& p : layout_.places)
      if (!p.size.empty()) sizes_of[p.name].insert(p.size);
    const bool graded = std::any_of(sizes_of.begin(), sizes_of.end(),
                                    [](const auto& entry) { return entry.second.size() > 1; });
    for (const DxfPlace& p : layout_.places)
      if (!p.size.empty() &&
          std::find(layout_.sizes.begin(), layout_.sizes.end(), p.size) == layout_.sizes.end())
        layout_.sizes.push_back(p.size);
    layout_.size = graded || settings_.size ? sample_size() : layout_.sizes.empty() ? "" : layout_.sizes[0];
    if (settings_.size) {
      if (!has_size(*settings_.size)) return unknown_size();
      layout_.size = *settings_.size;
    }
    if (graded || settings_.size) keep_size();
    return std::nullopt;
  }

  bool has_size(const std::string& size) const {
    return std::any_of(layout_.sizes.begin(), layout_.sizes.end(),
                       [&](const std::string& s) { return lower(s) == lower(size); });
  }

  /// "FRONT_42" is size 42 of FRONT where FRONT comes in several sizes and no text tells them.
  void read_suffixes() {
    std::map<std::string, std::set<std::string>> stems;
    for (const auto& [index, suffix] : suffixes_) {
      const std::string& block = layout_.places[std::size_t(index)].block;
      stems[block.substr(0, block.size() - suffix.size() - 1)].insert(suffix);
    }
    // Parts of a garment are told apart by such endings too (FRONT_1, FRONT_2): sizes recur with many pieces,
    // or one of them is the sample size.
    std::map<std::string, int> uses;
    for (const auto& [stem, suffixes] : stems)
      for (const std::string& suffix : suffixes) ++uses[suffix];
    const bool sample_is_there = uses.contains(layout_.style.sample_size);
    const std::set<std::string> nested = nested_stems();
    for (const auto& [index, suffix] : suffixes_) {
      DxfPlace& place = layout_.places[std::size_t(index)];
      const std::string stem = place.block.substr(0, place.block.size() - suffix.size() - 1);
      const bool in_sizes =
          stems[stem].size() > 1 && sample_is_there && stems[stem].contains(layout_.style.sample_size);
      const bool sample_only = stems[stem].size() == 1 && suffix == layout_.style.sample_size;
      const bool recurs = stems[stem].size() > 1 && stems.size() > 1 && uses[suffix] > 1 &&
                          nested.contains(stem) && !are_places(stems[stem]);
      if (!in_sizes && !sample_only && !recurs) continue;
      place.size = suffix;
      if (!place.name_is_stated) place.name = stem;
    }
  }

  /// Stems whose blocks lie on one another, as the sizes of one piece do and its parts do not.
  std::set<std::string> nested_stems() const {
    constexpr double kCommon = 0.4;  // of both boxes together
    std::map<std::string, std::vector<Aabb2>> boxes;
    for (const auto& [index, suffix] : suffixes_) {
      const DxfPlace& place = layout_.places[std::size_t(index)];
      if (const auto box = box_of(*place.parts[0].block))
        boxes[place.block.substr(0, place.block.size() - suffix.size() - 1)].push_back(*box);
    }
    const auto area = [](Vec2 low, Vec2 high) {
      return std::max(0.0, high.x - low.x) * std::max(0.0, high.y - low.y);
    };
    std::set<std::string> nested;
    for (const auto& [stem, all] : boxes) {
      bool on_one_another = true;
      for (std::size_t i = 1; i < all.size(); ++i) {
        const Aabb2 &a = all[i - 1], &b = all[i];
        const double common = area(most_of(a.low, b.low), least_of(a.high, b.high));
        on_one_another =
            on_one_another && common > kCommon * (area(a.low, a.high) + area(b.low, b.high) - common);
      }
      if (on_one_another) nested.insert(stem);
    }
    return nested;
  }

  /// Whether endings say where on the body a part belongs, and no size among them.
  static bool are_places(const std::set<std::string>& suffixes) {
    static const std::set<std::string> kPlaces{"l",     "r",     "left", "right", "lh",    "rh",   "f",
                                               "b",     "fr",    "bk",   "front", "back",  "top",  "under",
                                               "upper", "lower", "in",   "out",   "inner", "outer"};
    return std::all_of(suffixes.begin(), suffixes.end(),
                       [](const std::string& suffix) { return kPlaces.contains(lower(suffix)); });
  }

  /// The stated one; else the one with the most texts, since they stand on one size only; else the middle.
  std::string sample_size() {
    if (has_size(layout_.style.sample_size)) return layout_.style.sample_size;
    std::map<std::string, std::size_t> words;
    for (const DxfPlace& p : layout_.places)
      for (const DxfPart& part : p.parts)
        words[p.size] += part.block->texts.size() + part.block->marks.size();
    std::string best = layout_.sizes.empty() ? "" : layout_.sizes[layout_.sizes.size() / 2];
    for (const std::string& size : layout_.sizes)
      if (words[size] > words[best]) best = size;
    if (!layout_.sizes.empty())
      file_.log.warn(0, "the file has sizes but no sample size: " + best + " is taken");
    return best;
  }

  Error unknown_size() const {
    std::string list;
    for (const std::string& size : layout_.sizes) list += (list.empty() ? "" : ", ") + size;
    return {"dxf.unknown_size",
            "The file has no size '" + *settings_.size + "'; " +
                (list.empty() ? "its pieces come in one size without a name." : "it has " + list + "."),
            ""};
  }

  /// Leaves the pieces of the size taken, and those without a size.
  void keep_size() {
    const std::string wanted = lower(layout_.size);
    const std::string sample = lower(sample_size_or(layout_.size));
    std::map<std::string, const DxfPlace*> of_sample;
    std::map<std::string, bool> there;
    for (const DxfPlace& p : layout_.places) {
      there[p.name] = there[p.name] || p.size.empty() || lower(p.size) == wanted;
      if (lower(p.size) == sample) of_sample.emplace(p.name, &p);
    }
    std::vector<DxfPlace> kept;
    for (const DxfPlace& p : layout_.places) {
      if (!p.size.empty() && lower(p.size) != wanted) {
        drop_size(p);
        if (!there[p.name]) {
          there[p.name] = true;
          file_.log.warn(p.line, "the piece '" + p.name + "' does not come in size " + layout_.size +
                                     " and is left out");
        }
        continue;
      }
      kept.push_back(p);
      const auto it = of_sample.find(p.name);
      if (it != of_sample.end() && it->second != &p) kept.back().inherited = it->second->statements;
    }
    layout_.places = std::move(kept);
  }

  std::string sample_size_or(const std::string& otherwise) const {
    return layout_.style.sample_size.empty() ? otherwise : layout_.style.sample_size;
  }

  void drop_size(const DxfPlace& place) {
    const std::string reason = "another size (" + place.size + ")";
    for (const DxfPart& part : place.parts) {
      for (const DxfCurve& c : part.block->curves) file_.log.mark(c.entity, DxfFate::dropped, reason);
      for (const DxfText& t : part.block->texts) file_.log.mark(t.entity, DxfFate::dropped, reason);
      for (const DxfMark& m : part.block->marks) file_.log.mark(m.entity, DxfFate::dropped, reason);
    }
  }

  DxfFile& file_;
  const DxfSettings& settings_;
  DxfLayout layout_;
  std::map<std::string, std::vector<const DxfBlock*>> named_;
  std::map<std::string, std::size_t> taken_;
  std::set<const DxfBlock*> used_;                  // only asked, never run through
  std::map<std::ptrdiff_t, std::string> suffixes_;  // place → what stands behind the last '_' of its block
  std::size_t parts_ = 0;
};

}  // namespace

Result<DxfLayout> layout_of(DxfFile& file, const DxfSettings& settings) {
  return Finder(file, settings).run();
}

}  // namespace toile
