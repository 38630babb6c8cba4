#include "server/documents/mannequins.h"

#include "core/base/text.h"

namespace toile {
namespace {

/// Equal for equal settings, bit for bit.
std::string key_of(const MannequinSettings& settings) {
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

Result<std::shared_ptr<const Mannequin>> MannequinCache::get(const MannequinSettings& settings) {
  const std::string key = key_of(settings);
  if (std::shared_ptr<const Mannequin> kept = kept_.find(key)) return kept;
  Mannequin made = TRY(make_mannequin(settings));
  auto figure = std::make_shared<const Mannequin>(std::move(made));
  kept_.keep(key, figure, 1);
  return std::shared_ptr<const Mannequin>(std::move(figure));
}

}  // namespace toile
