#include "server/store/links.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/names.h"
#include "server/store/store.h"

namespace toile::store {
namespace {

using Taking = bool LinkTakes::*;
constexpr std::array<std::pair<std::string_view, Taking>, 3> kWords{
    {{"pictures", &LinkTakes::pictures}, {"models", &LinkTakes::models}, {"report", &LinkTakes::report}}};

}  // namespace

bool may_take(const LinkTakes& takes, std::string_view result) {
  if (result.ends_with(".png") || result.ends_with(".mp4") || result.ends_with(".avi")) return takes.pictures;
  if (result == "final.glb" || result == "final.obj") return takes.models;
  return result == "report.json" && takes.report;
}

std::string to_text(const LinkTakes& takes) {
  std::string text;
  for (const auto& [word, taking] : kWords) {
    if (!(takes.*taking)) continue;
    if (!text.empty()) text += ',';
    text += word;
  }
  return text;
}

Result<LinkTakes> takes_from(std::string_view text) {
  LinkTakes takes;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view word = text.substr(0, comma);
    const auto found =
        std::find_if(kWords.begin(), kWords.end(), [&](const auto& one) { return one.first == word; });
    if (found == kWords.end()) {
      return Error{"links.take",
                   in_quotes(word) + " is nothing to take; there are pictures, models and report", ""};
    }
    takes.*(found->second) = true;
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return takes;
}

JobRow shown_by(const LinkRow& link, JobRow job) {
  job.id = link.id;
  job.project_id.clear();
  job.project_revision = 0;
  job.document.clear();
  job.files.clear();
  job.input.clear();
  job.lease = {};
  job.cell = {};
  job.reason_where.clear();
  std::erase_if(job.results, [&](const auto& result) { return !may_take(link.takes, result.first); });
  return job;
}

}  // namespace toile::store
