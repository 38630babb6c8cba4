// A fabric in the tests of laboratories, beside what is known beforehand.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "core/base/rounded.h"
#include "core/base/units.h"
#include "core/base/write_file.h"
#include "core/fabric/library.h"
#include "core/trials/fabric_trial.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/movie/draw_svg.h"

namespace toile::app {
namespace {

json::JsonValue cantilever_json(const trials::CantileverResult& r) {
  return std::vector<json::JsonMember>{{"measured_mm", rounded(mm_from_metres(r.measured), 2)},
                                       {"known_mm", rounded(mm_from_metres(r.known), 2)},
                                       {"chord_degrees", rounded(r.angle, 2)}};
}

/// Of a test whose figures are N/m.
template <typename Test>
json::JsonValue n_m_json(const Test& r) {
  return std::vector<json::JsonMember>{{"measured_n_m", rounded(r.measured, 1)},
                                       {"known_n_m", rounded(r.known, 1)}};
}

json::JsonValue drapes_json(const fabric::FabricCard& card, const trials::FabricTrial& trial) {
  std::vector<json::JsonValue> each;
  for (const trials::CusickDrape& d : trial.drapes) {
    each.push_back(std::vector<json::JsonMember>{{"percent", rounded(100 * d.shadow.coefficient, 2)},
                                                 {"folds", static_cast<double>(d.shadow.nodes)},
                                                 {"settled", d.settled},
                                                 {"particles", static_cast<double>(d.particles)},
                                                 {"cpu_s", rounded(d.cpu_s, 2)},
                                                 {"crossings_cloth_body", double(d.worst.cloth_body)},
                                                 {"crossings_cloth_cloth", double(d.worst.cloth_cloth)}});
  }
  std::vector<json::JsonMember> out{
      {"percent", rounded(100 * trial.coefficient(), 2)},
      {"spread", rounded(100 * trial.spread(), 2)},
      {"folds", rounded(trial.nodes(), 2)},
      {"particle_distance_mm", rounded(mm_from_metres(trial.particle_distance), 2)},
      {"drapes", std::move(each)}};
  if (card.drape_least_percent && card.drape_most_percent) {
    out.push_back({"published_percent",
                   std::vector<json::JsonValue>{*card.drape_least_percent, *card.drape_most_percent}});
  }
  return out;
}

void print_trial(const fabric::FabricCard& card, const trials::FabricTrial& trial) {
  const auto bending = [](const char* way, const trials::CantileverResult& r) {
    std::printf("  %s  %5.1f mm, known %5.1f mm; the chord falls by %.1f°, 41.5° is right\n", way,
                mm_from_metres(r.measured), mm_from_metres(r.known), r.angle);
  };
  const auto pull = [](const char* way, const auto& r) {
    std::printf("  %s  %7.1f N/m, known %7.1f N/m\n", way, r.measured, r.known);
  };
  std::printf("%s: %s\nBending length, strip 25 mm wide (ASTM D1388)\n", card.name.c_str(),
              card.title.c_str());
  bending("warp", trial.warp);
  bending("weft", trial.weft);
  bending("bias", trial.bias);
  std::printf("Tension per strain at 0.5 %%, strip of 50 by 200 mm\n");
  pull("warp", trial.pull_warp);
  pull("weft", trial.pull_weft);
  std::printf("Shear by half a degree, piece of 50 by 200 mm (as KES-FB1)\n");
  std::printf("         %5.1f N/m per radian, known %5.1f N/m\n", trial.shear.measured, trial.shear.known);
  std::printf("Tube 100 mm across under air pressure: its tension per strain around\n");
  pull("warp", trial.tube_warp);
  pull("weft", trial.tube_weft);
  std::printf("Slide down a slope, piece of 100 by 100 mm (as ISO 8295)\n");
  std::printf("         friction %.3f, known %.3f\n", trial.slide.measured, trial.slide.known);
  std::printf("Drape, 30 cm on 18 cm (BS 5058, ISO 9073-9), triangles of %.1f mm, %d of %zu at rest\n",
              mm_from_metres(trial.particle_distance), trial.settled(), trial.drapes.size());
  std::printf("  coefficient %.1f %%, spread %.1f; %.1f folds\n", 100 * trial.coefficient(),
              100 * trial.spread(), trial.nodes());
  if (!card.drape_least_percent || !card.drape_most_percent) return;
  const double percent = 100 * trial.coefficient();
  const bool inside = percent >= *card.drape_least_percent && percent <= *card.drape_most_percent;
  std::printf("  published %g to %g %%: %s\n", *card.drape_least_percent, *card.drape_most_percent,
              inside ? "inside" : "outside");
}

void print_json(const fabric::FabricCard& card, const trials::FabricTrial& trial) {
  const std::vector<json::JsonMember> out{
      {"name", card.name},
      {"bending_length", std::vector<json::JsonMember>{{"warp", cantilever_json(trial.warp)},
                                                       {"weft", cantilever_json(trial.weft)},
                                                       {"bias", cantilever_json(trial.bias)}}},
      {"tension", std::vector<json::JsonMember>{{"warp", n_m_json(trial.pull_warp)},
                                                {"weft", n_m_json(trial.pull_weft)}}},
      {"shear", n_m_json(trial.shear)},
      {"tube", std::vector<json::JsonMember>{{"warp", n_m_json(trial.tube_warp)},
                                             {"weft", n_m_json(trial.tube_weft)}}},
      {"friction", std::vector<json::JsonMember>{{"measured", rounded(trial.slide.measured, 3)},
                                                 {"known", rounded(trial.slide.known, 3)}}},
      {"drape", drapes_json(card, trial)}};
  std::printf("%s", json::write_json(out).c_str());
}

/// NAME.svg and, where ffmpeg is installed, NAME.png.
Status write_sheet(const FabricTestOptions& options, const fabric::FabricCard& card,
                   const trials::FabricTrial& trial) {
  if (options.out.empty()) return {};
  const std::filesystem::path folder = options.out;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);  // write_file says what is wrong with it
  const std::filesystem::path drawing = folder / (card.name + ".svg");
  TRY(write_file(drawing, trials::figure_sheet(card, trial)));
  constexpr int kWidth = 2000;  // pixels: twice the sheet's
  const Status drawn = movie::draw_svg(drawing, folder / (card.name + ".png"), kWidth);
  if (!drawn) std::fprintf(stderr, "toile: no PNG: %s\n", to_string(drawn.error()).c_str());
  return {};
}

}  // namespace

ExitCode fabric_test_command(const FabricTestOptions& options) {
  const Result<const fabric::FabricCard*> card = fabric::named(options.name, "");
  if (!card) return fail(card.error(), options.json);
  const Result<trials::FabricTrial> trial = trials::try_fabric(
      fabric::fabric_of(**card), options.drapes, metres_from_mm(options.particle_distance_mm), RunContext{});
  if (!trial) return fail(trial.error(), options.json);
  if (Status written = write_sheet(options, **card, *trial); !written)
    return fail(written.error(), options.json);
  if (options.json)
    print_json(**card, *trial);
  else
    print_trial(**card, *trial);
  return kDone;
}

}  // namespace toile::app
