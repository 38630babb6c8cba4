#include "core/pattern/dxf/report.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "core/pattern/dxf/groups.h"

namespace toile::dxf {
namespace {
constexpr std::size_t kMostWarnings = 500;  // a broken file must not answer with a book
}

std::string warning_text(const DxfWarning& w) {
  std::string text;
  if (w.line > 0) text = line_text(w.line);
  if (!w.piece.empty()) text += (text.empty() ? "piece " : ", piece ") + w.piece;
  text += (text.empty() ? "" : ": ") + w.text;
  if (w.count > 1) text += " (" + std::to_string(w.count) + " times)";
  return text;
}

void DxfNotes::mark(std::size_t entity, DxfFate fate, std::string reason, int piece) {
  marks.push_back({entity, fate, std::move(reason), piece});
}

void DxfNotes::warn(int line, std::string text, int piece, std::optional<Vec2> at) {
  warnings.push_back({line, std::move(text), piece, at});
}

void DxfNotes::fail(const Error& error) {
  if (!fault) fault = error;
}

void DxfNotes::add(DxfNotes later) {
  marks.insert(marks.end(), std::make_move_iterator(later.marks.begin()),
               std::make_move_iterator(later.marks.end()));
  warnings.insert(warnings.end(), std::make_move_iterator(later.warnings.begin()),
                  std::make_move_iterator(later.warnings.end()));
  if (!fault) fault = std::move(later.fault);
  if (!open) open = std::move(later.open);
}

int DxfLog::number_of_word(std::string_view word) {
  const auto it = numbers_.find(word);
  if (it != numbers_.end()) return it->second;
  words_.emplace_back(word);
  return numbers_.emplace(word, static_cast<int>(words_.size()) - 1).first->second;
}

std::size_t DxfLog::add(std::string_view type, std::string_view layer, std::string_view block, int line) {
  Entity entity;
  entity.type = number_of_word(type);
  entity.layer = number_of_word(layer);
  entity.block = number_of_word(block);
  entity.line = line;
  entities_.push_back(entity);
  return entities_.size() - 1;
}

void DxfLog::mark(std::size_t entity, DxfFate fate, std::string_view reason, int piece) {
  Entity& e = entities_[entity];
  e.fate = fate;
  e.reason = number_of_word(reason);
  e.piece = piece;
}

void DxfLog::warn(int line, std::string text, int piece, std::optional<Vec2> at) {
  auto key = std::pair{std::move(text), piece};
  const auto it = warnings_.find(key);
  if (it != warnings_.end()) {
    ++it->second.count;
  } else if (warnings_.size() < kMostWarnings) {
    warnings_.emplace(std::move(key), Warning{line, piece, at, 1});
  }
}

void DxfLog::take(const DxfNotes& notes) {
  for (const DxfNotes::Mark& m : notes.marks) mark(m.entity, m.fate, m.reason, m.piece);
  for (const DxfNotes::Warning& w : notes.warnings) warn(w.line, w.text, w.piece, w.at);
}

DxfReport DxfLog::report(const std::vector<std::string>& names) const {
  DxfReport report = report_;
  report.entities = entities_.size();
  report.records = report.structure + report.elsewhere + report.vertices + report.entities;
  const auto name = [&](int piece) {
    return piece >= 0 && std::size_t(piece) < names.size() ? names[std::size_t(piece)] : std::string();
  };
  using Key = std::tuple<int, int, int, DxfFate, int, int>;
  std::map<Key, std::size_t> groups;
  for (const Entity& e : entities_) {
    std::size_t& sum = e.fate == DxfFate::kKept        ? report.kept
                       : e.fate == DxfFate::kConverted ? report.converted
                                                       : report.dropped;
    ++sum;
    const Key key{e.type, e.layer, e.block, e.fate, e.reason, e.piece};
    const auto [it, fresh] = groups.emplace(key, report.groups.size());
    if (fresh) {
      DxfEntityGroup group;
      group.type = words_[std::size_t(e.type)];
      group.layer = words_[std::size_t(e.layer)];
      group.block = words_[std::size_t(e.block)];
      group.fate = e.fate;
      group.piece = name(e.piece);
      group.reason = e.reason < 0 ? "nothing is made of it" : words_[std::size_t(e.reason)];
      report.groups.push_back(std::move(group));
    }
    report.groups[it->second].lines.push_back(e.line);
  }
  for (const auto& [key, w] : warnings_)
    report.warnings.push_back({w.line, name(w.piece), w.at, key.first, w.count});
  std::stable_sort(report.warnings.begin(), report.warnings.end(),
                   [](const DxfWarning& a, const DxfWarning& b) { return a.line < b.line; });
  return report;
}

}  // namespace toile::dxf
