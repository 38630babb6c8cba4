// bench_dressing DATA even|odd|NAME|PROJECT.json… [--body OBJ]… [--arrange] [--mm 20] [--way K]
//                [--film] [--stills DIR]
// Puts garments on people, each in the ways of core/dressing until one is certified, and prints what each try
// gave, and its time. Garments: the random GarmentCode designs of DATA/garmentcode/random, on
// DATA/bodies/garmentcode-mean_all.obj or the bodies named, where they were placed or arranged anew; or
// projects with bodies of their own. --film tells of the way there, not of the end alone.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/arrange/arrange.h"
#include "core/base/stopwatch.h"
#include "core/drape/pipeline.h"
#include "core/drape/worn_part.h"
#include "core/dressing/dress.h"
#include "core/mesh/make_panel_meshes.h"
#include "server/render/png.h"
#include "server/render/still.h"
#include "tests/bench/designs.h"

namespace {

namespace fs = std::filesystem;
using namespace toile;

struct Options {
  fs::path data;
  std::vector<fs::path> bodies;
  std::vector<fs::path> garments;
  bool arrange = false, film = false;
  double mm = 20;
  int way = -1;  ///< of dressing_ways(), -1: each in turn
  fs::path stills;
};

Options read_options(int count, char** arguments) {
  Options o;
  o.data = arguments[1];
  for (int i = 2; i < count; ++i) {
    const std::string a = arguments[i];
    if (a == "--mm") {
      o.mm = std::atof(arguments[++i]);
    } else if (a == "--way") {
      o.way = std::atoi(arguments[++i]);
    } else if (a == "--body") {
      o.bodies.emplace_back(arguments[++i]);
    } else if (a == "--stills") {
      o.stills = arguments[++i];
    } else if (a == "--arrange") {
      o.arrange = true;
    } else if (a == "--film") {
      o.film = true;
    } else {
      const auto named = bench::garments_named(o.data, a);
      o.garments.insert(o.garments.end(), named.begin(), named.end());
    }
  }
  if (o.bodies.empty()) o.bodies.push_back(o.data / "bodies/garmentcode-mean_all.obj");
  return o;
}

void make_still(const sewing::GarmentMesh& g, std::span<const Vec3> x, const body::Body& body,
                const fs::path& file) {
  render::Scene scene;
  scene.cloth = {{x.begin(), x.end()}, g.triangles, g.panel_of_triangle, g.weld, {}, {}, nullptr};
  scene.bodies.push_back({&body.mesh});
  scene.floor = 0;
  render::Stills stills;
  for (const auto& [view, tag] : {std::pair{render::View::kFront, "_f"}, {render::View::kBack, "_b"}}) {
    auto image = stills.render(scene, view, {500, 640});
    if (image) (void)render::write_png(file.string() + tag + ".png", *image);
  }
}

/// What goes through each: head, left and right arm, left and right leg.
std::string words_of(const std::vector<dressing::WornRing>& rings) {
  std::string words;
  for (const dressing::WornRing& r : rings) {
    words += r.right ? " " : " !";
    for (const int n : r.around.times) words += std::to_string(n);
  }
  return words;
}

std::string words_of(const dressing::Dressed& d) {
  const dressing::Certificate& c = d.certificate;
  char text[300];
  std::snprintf(
      text, sizeof text,
      "seams %.1f mm, body %d cloth %d, stretch %.2f %.2f shrink %.2f, room %.0f um, out %.2f, rings",
      d.seam_gap * 1e3, c.crossings.cloth_body, c.crossings.cloth_cloth, c.stretch_p99, c.stretch_max,
      c.shrink_p99, c.gap * 1e6, c.faces_out);
  return text + words_of(c.rings);
}

Status place_anew(drape::DrapeInput& input, const mesh::PanelMeshes& meshes) {
  arrange::Arrangement made = TRY(arrange::arrange({input.pattern, meshes, input.bodies}));
  input.placements = std::move(made.placements);
  input.attachments = std::move(made.attachments);
  return {};
}

/// Whether a way was certified.
Result<bool> put_on(const Options& o, const fs::path& garment, const fs::path& body) {
  drape::DrapeInput input = drape::worn_part(TRY(bench::garment_input(garment, body)));
  const auto person = dressing::find_person(input.bodies);
  if (!person) return Error{"body.not_standing", "nobody to dress", body.string()};
  const dressing::Wearer wearer(*person);
  const auto meshes = TRY(mesh::make_panel_meshes(input.pattern, o.mm * 1e-3, {}));
  if (o.arrange) TRY(place_anew(input, meshes));
  const auto assembly = TRY(sewing::assemble(meshes, input.placements, input.attachments, input.notions));
  const std::string name =
      bench::name_of_garment(garment) + "_" + body.stem().string() + (o.arrange ? "_arranged" : "");
  for (std::size_t k = 0; k < dressing::dressing_ways().size(); ++k) {
    if (o.way >= 0 && static_cast<int>(k) != o.way) continue;
    const std::string title = name + "_w" + std::to_string(k);
    int looked = 0;
    const dressing::ShapeWatch film = [&](std::span<const Vec3> x) {
      char number[16];
      std::snprintf(number, sizeof number, "_%02d", looked++);
      std::printf("%s%s%s\n", title.c_str(), number,
                  words_of(dressing::worn_rings(assembly.garment, x, wearer.skeleton())).c_str());
      if (!o.stills.empty()) make_still(assembly.garment, x, input.bodies[0], o.stills / (title + number));
    };
    const Stopwatch watch;
    const auto way = dressing::dressing_ways()[k];
    const auto on = dressing::dress(assembly, wearer, way, {}, o.film ? film : dressing::ShapeWatch{});
    const bool holds = on.certificate.holds();
    std::printf("%s: %s  %.2f s %s\n", title.c_str(), words_of(on).c_str(), watch.cpu_s(),
                holds ? "OK" : "-");
    std::fflush(stdout);
    if (!o.stills.empty()) make_still(assembly.garment, on.positions, input.bodies[0], o.stills / title);
    if (holds) return true;
  }
  return false;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "bench_dressing DATA even|odd|NAME|PROJECT.json… see the head of its source\n");
    return 2;
  }
  const Options o = read_options(count, arguments);
  const Stopwatch watch;
  std::size_t certified = 0, tried = 0;
  for (const fs::path& body : o.bodies) {
    std::size_t here = 0;
    for (const fs::path& garment : o.garments) {
      const auto on = put_on(o, garment, body);
      if (!on)
        std::printf("%s %s: %s\n", garment.c_str(), body.stem().c_str(), to_string(on.error()).c_str());
      here += on && *on;
    }
    std::printf("%s: %zu of %zu certified\n", body.stem().c_str(), here, o.garments.size());
    certified += here;
    tried += o.garments.size();
  }
  std::printf("%zu of %zu certified, %.2f s each\n", certified, tried,
              watch.cpu_s() / static_cast<double>(std::max<std::size_t>(1, tried)));
}
