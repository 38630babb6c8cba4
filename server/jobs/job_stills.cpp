#include "server/jobs/job_stills.h"

#include <algorithm>
#include <string_view>
#include <variant>

#include "core/base/hash.h"
#include "core/base/text.h"
#include "core/exports/map_file.h"
#include "server/render/png.h"

namespace toile::jobs {
namespace {

constexpr std::string_view kBegins = "still-";
constexpr std::size_t kDigits = 12;  // of a camera's number

bool is_still(const std::string& name) { return name.starts_with(kBegins) && name.ends_with(".png"); }

std::string place_text(Vec3 p) { return number_text(p.x) + "," + number_text(p.y) + "," + number_text(p.z); }

std::string camera_word(const render::Viewpoint& from) {
  const std::string target = from.target ? place_text(*from.target) : "cloth";
  return "from-" +
         hash_of(place_text(from.eye) + " " + target + " " + number_text(from.angle)).substr(0, kDigits);
}

}  // namespace

std::string still_name(const movie::StillWish& wish) {
  const auto* view = std::get_if<render::View>(&wish.from);
  std::string name{kBegins};
  name += view ? render::word_of(*view) : camera_word(std::get<render::Viewpoint>(wish.from));
  if (!wish.map.empty()) name += "-" + wish.map;
  name += "-" + std::to_string(wish.settings.width) + "x" + std::to_string(wish.settings.height);
  if (wish.settings.samples != render::StillSettings().samples)
    name += "-" + std::to_string(wish.settings.samples) + "s";
  if (wish.settings.transparent) name += "-clear";
  return name + ".png";
}

JobStills::JobStills(store::Store& store, OrderLimits limits)
    : OnDemand(store, limits,
               {"still", "still.no_film", "still.busy", "still.too_many", "still.failed", is_still}) {}

Result<Order> JobStills::ask(const store::RequestContext& context, const std::string& job_id,
                             const movie::StillWish& wish) {
  TRY(movie::check_wish(wish));
  if (std::max(wish.settings.width, wish.settings.height) > limits().side)
    return Error{"render.settings",
                 "a still has at most " + std::to_string(limits().side) + " pixels a side here", "size"};
  return OnDemand::ask(context, job_id, still_name(wish),
                       [wish](const Ingredients& from, const RunContext&) -> Result<std::string> {
                         const auto maps = [&] { return from.result(exports::kMapFile); };
                         const render::Image image =
                             TRY(movie::take_still(from.film, wish, maps, from.stills));
                         return render::png_bytes(image);
                       });
}

}  // namespace toile::jobs
