#include "server/documents/mannequins.h"

#include "core/base/text.h"

namespace toile::documents {
namespace {

/// Equal for equal settings, bit for bit.
std::string key_of(const mannequin::MannequinSettings& settings) {
  std::string key =
      std::to_string(static_cast<int>(settings.sex)) + " " + std::to_string(settings.triangle_count);
  const auto add = [&key](double value) { key += ' ' + number_text(value); };
  add(settings.arm_angle);
  for (const std::optional<double>& value : settings.asked.values) {
    if (value) add(*value);
    key += ',';
  }
  return key;
}

}  // namespace

Result<std::shared_ptr<const mannequin::Mannequin>> MannequinCache::get(
    const mannequin::MannequinSettings& settings) {
  const std::string key = key_of(settings);
  if (std::shared_ptr<const mannequin::Mannequin> kept = kept_.find(key)) return kept;
  mannequin::Mannequin made = TRY(mannequin::make_mannequin(settings));
  auto figure = std::make_shared<const mannequin::Mannequin>(std::move(made));
  kept_.keep(key, figure, 1);
  return std::shared_ptr<const mannequin::Mannequin>(std::move(figure));
}

}  // namespace toile::documents
