// The contact sheet of a sweep, drawn when it is asked for.

#include <memory>
#include <utility>

#include "core/base/read_file.h"
#include "core/base/write_file.h"
#include "core/image/reduce.h"
#include "core/sweep/contact_sheet.h"
#include "server/jobs/results.h"
#include "server/jobs/sweeps.h"
#include "server/movie/draw_svg.h"

namespace toile::jobs {
namespace {

/// Small; empty where there is none that can be shown.
std::string still_of(store::Store& store, const store::RequestContext& context, const sweep::Cell& cell,
                     const std::string& still) {
  if (!cell.pictured) return "";
  const Result<std::string> bytes = store.result_bytes(context, cell.job, still);
  if (!bytes) return "";
  Result<std::string> small = image::reduced_png(*bytes, sweep::kStillWidth);
  return small ? std::move(*small) : "";
}

}  // namespace

Result<std::string> sheet_png(store::Store& store, const store::RequestContext& context,
                              const sweep::Table& table, const std::string& still) {
  std::vector<std::string> stills;
  for (const sweep::Cell& cell : table.cells) {
    if (context.is_given_up())
      return Error{"sweep.given_up", "nobody waits for it any more", "", ErrorKind::kCancelled};
    stills.push_back(still_of(store, context, cell, still));
  }
  const sweep::ContactSheet sheet = sweep::contact_sheet(table, stills);
  const std::unique_ptr<TemporaryFolder> folder = TRY(TemporaryFolder::make(store.scratch_folder()));
  const std::filesystem::path drawing = folder->path() / "sheet.svg", picture = folder->path() / "sheet.png";
  TRY(write_file(drawing, sheet.svg));
  TRY(movie::draw_svg(drawing, picture, sheet.width));
  std::optional<std::string> png = read_file(picture);
  if (png) return std::move(*png);
  return Error{"export.read", "cannot read the sheet back", picture.string(), ErrorKind::kInternal};
}

}  // namespace toile::jobs
