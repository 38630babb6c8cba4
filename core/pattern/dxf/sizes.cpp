#include "core/pattern/dxf/sizes.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/text.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {
namespace {

using Endings = std::map<std::string, std::set<std::string>>;  // by the stem before them

bool may_have_size(const DxfPlace& place) { return !place.ending.empty(); }

/// Stems whose blocks lie on one another, as the sizes of one piece do and its parts do not.
std::set<std::string> nested_stems(const std::vector<DxfPlace>& places) {
  constexpr double kCommon = 0.4;  // of both boxes together
  std::map<std::string, std::vector<Aabb2>> boxes;
  for (const DxfPlace& place : places) {
    if (!may_have_size(place)) continue;
    if (const auto box = box_of(*place.parts[0].block)) boxes[place.stem()].push_back(*box);
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

/// Whether the ending is as sizes are: a figure among it, "XL", "medium".
bool is_like_size(const std::string& ending) {
  static const std::set<std::string> kSizes{"s",      "m",       "l",    "small", "medium", "large",
                                            "petite", "regular", "tall", "short", "long",   "uni"};
  const std::string text = lower_case(ending);
  if (std::any_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; })) return true;
  const std::size_t begins = text.find_first_not_of('x');
  return kSizes.contains(text) || (begins != std::string::npos && begins > 0 && begins + 1 == text.size() &&
                                   kSizes.contains(text.substr(begins)));
}

/// Whether all endings are; but "L" and "R" are left and right.
bool are_sizes(const std::set<std::string>& endings) {
  const bool sides = endings.size() == 2 && endings.contains("R");
  return !sides && std::all_of(endings.begin(), endings.end(), is_like_size);
}

/// The places with the sizes that their blocks' names end with: "FRONT_42" is size 42 of FRONT where FRONT
/// comes in several sizes and no text tells them. Parts of a garment are told apart by such endings too
/// (FRONT_1, FRONT_2): sizes recur with many pieces, or one of them is the sample size.
std::vector<DxfPlace> with_sizes_from_names(std::vector<DxfPlace> places, const std::string& sample) {
  Endings endings;
  for (const DxfPlace& place : places)
    if (may_have_size(place)) endings[place.stem()].insert(place.ending);
  std::map<std::string, int> uses;
  for (const auto& [stem, some] : endings)
    for (const std::string& ending : some) ++uses[ending];
  const bool sample_is_there = uses.contains(sample);
  const std::set<std::string> nested = nested_stems(places);
  for (DxfPlace& place : places) {
    if (!may_have_size(place)) continue;
    const std::string stem = place.stem();
    const std::set<std::string>& some = endings[stem];
    const bool in_sizes = some.size() > 1 && sample_is_there && some.contains(sample);
    const bool sample_only = some.size() == 1 && place.ending == sample;
    const bool recurs = some.size() > 1 && endings.size() > 1 && uses[place.ending] > 1 &&
                        nested.contains(stem) && are_sizes(some);
    if (!in_sizes && !sample_only && !recurs) continue;
    place.size = place.ending;
    if (!place.name_is_stated) place.name = stem;
  }
  return places;
}

/// The sizes in the file's order.
std::vector<std::string> sizes_of(const std::vector<DxfPlace>& places) {
  std::vector<std::string> sizes;
  for (const DxfPlace& p : places)
    if (!p.size.empty() && std::find(sizes.begin(), sizes.end(), p.size) == sizes.end())
      sizes.push_back(p.size);
  return sizes;
}

/// Whether any piece comes in several sizes.
bool is_graded(const std::vector<DxfPlace>& places) {
  std::map<std::string, std::set<std::string>> sizes;  // of each piece
  for (const DxfPlace& p : places)
    if (!p.size.empty()) sizes[p.name].insert(p.size);
  return std::any_of(sizes.begin(), sizes.end(), [](const auto& entry) { return entry.second.size() > 1; });
}

bool has_size(const std::vector<std::string>& sizes, const std::string& size) {
  return std::any_of(sizes.begin(), sizes.end(),
                     [&](const std::string& s) { return lower_case(s) == lower_case(size); });
}

/// The size with the most texts, since they stand on one size only; else the middle one.
std::string likely_sample(const std::vector<DxfPlace>& places, const std::vector<std::string>& sizes) {
  std::map<std::string, std::size_t> words;
  for (const DxfPlace& p : places)
    for (const DxfPart& part : p.parts) words[p.size] += part.block->texts.size() + part.block->marks.size();
  std::string best = sizes.empty() ? "" : sizes[sizes.size() / 2];
  for (const std::string& size : sizes)
    if (words[size] > words[best]) best = size;
  return best;
}

Error unknown_size(const std::string& wanted, const std::vector<std::string>& sizes) {
  std::string list;
  for (const std::string& size : sizes) list += (list.empty() ? "" : ", ") + size;
  return {"dxf.unknown_size",
          "The file has no size '" + wanted + "'; " +
              (list.empty() ? "its pieces come in one size without a name." : "it has " + list + "."),
          ""};
}

void tell_other_size(const DxfPlace& place, DxfNotes& notes) {
  const std::string reason = "another size (" + place.size + ")";
  for (const DxfPart& part : place.parts) {
    for (const DxfCurve& c : part.block->curves) notes.mark(c.entity, DxfFate::kDropped, reason);
    for (const DxfText& t : part.block->texts) notes.mark(t.entity, DxfFate::kDropped, reason);
    for (const DxfMark& m : part.block->marks) notes.mark(m.entity, DxfFate::kDropped, reason);
  }
}

/// The layout with the pieces of its size, and those without a size.
DxfLayout of_its_size(DxfLayout layout) {
  const std::string wanted = lower_case(layout.size);
  const std::string sample =
      lower_case(layout.style.sample_size.empty() ? layout.size : layout.style.sample_size);
  const auto is_wanted = [&](const DxfPlace& p) { return p.size.empty() || lower_case(p.size) == wanted; };
  std::map<std::string, const DxfPlace*> of_sample;
  std::map<std::string, bool> there;
  for (const DxfPlace& p : layout.places) {
    there[p.name] = there[p.name] || is_wanted(p);
    if (lower_case(p.size) == sample) of_sample.emplace(p.name, &p);
  }
  std::vector<DxfPlace> kept;
  for (const DxfPlace& p : layout.places) {
    if (is_wanted(p)) {
      kept.push_back(p);
      const auto it = of_sample.find(p.name);
      if (it != of_sample.end() && it->second != &p) kept.back().inherited = it->second->statements;
      continue;
    }
    tell_other_size(p, layout.notes);
    if (there[p.name]) continue;
    there[p.name] = true;
    layout.notes.warn(p.line,
                      "the piece '" + p.name + "' does not come in size " + layout.size + " and is left out");
  }
  layout.places = std::move(kept);
  return layout;
}

}  // namespace

Result<DxfLayout> in_one_size(DxfPlaces all, const DxfSettings& settings) {
  DxfLayout layout;
  layout.style = std::move(all.style);
  layout.notes = std::move(all.notes);
  layout.places = with_sizes_from_names(std::move(all.places), layout.style.sample_size);
  layout.sizes = sizes_of(layout.places);
  const bool graded = is_graded(layout.places);
  if (!graded && !settings.size) {
    layout.size = layout.sizes.empty() ? "" : layout.sizes[0];
    return layout;
  }
  layout.size = layout.style.sample_size;
  if (!has_size(layout.sizes, layout.size)) {
    layout.size = likely_sample(layout.places, layout.sizes);
    if (!layout.sizes.empty())
      layout.notes.warn(0, "the file has sizes but no sample size: " + layout.size + " is taken");
  }
  if (settings.size) {
    if (!has_size(layout.sizes, *settings.size)) return unknown_size(*settings.size, layout.sizes);
    layout.size = *settings.size;
  }
  return of_its_size(std::move(layout));
}

}  // namespace toile::dxf
