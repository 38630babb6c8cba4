// bench_dressing DATA even|odd|NAME|PROJECT.json… [--mm 22] [--way K] [--stills DIR]: puts the random
// GarmentCode designs of DATA/garmentcode/random on garmentcode-mean_all, each in the ways of core/dressing
// until one is certified, and prints what each try gave, and its time.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/base/stopwatch.h"
#include "core/drape/pipeline.h"
#include "core/dressing/dress.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/project/create/create.h"
#include "core/project/resolve/resolve.h"
#include "server/render/png.h"
#include "server/render/still.h"

namespace {

using namespace toile;

std::string slurp(const std::filesystem::path& p) {
  std::ifstream in(p, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Result<drape::DrapeInput> input_of(const std::filesystem::path& data, const std::string& name, double mm,
                                   bool with_body) {
  if (name.ends_with(".json")) {
    auto read = TRY(resolve::read_project(name));
    read.input.settings.particle_distance = mm * 1e-3;
    return std::move(read.input);
  }
  create::NewProjectSettings settings;
  settings.name = name;
  settings.body_file = "garmentcode-mean_all.obj";
  auto made =
      TRY(create::new_project(slurp(data / (name.find("random") == 0 ? "garmentcode/random" : "garmentcode") /
                                    (name + "_specification.json")),
                              settings));
  made.project.bodies[0].unit = "m";
  if (!with_body) made.project.bodies.clear();
  made.project.settings.particle_distance_mm = mm;
  return resolve::resolve_project(made.project, resolve::files_in(data / "bodies", {}));
}

void still(const sewing::GarmentMesh& g, const std::vector<Vec3>& x, const body::Body& body,
           const std::filesystem::path& file) {
  render::Scene scene;
  scene.cloth = {x, g.triangles, g.panel_of_triangle, g.weld, {}, {}, nullptr};
  scene.bodies.push_back({&body.mesh});
  scene.floor = 0;
  for (const auto& [view, tag] : {std::pair{render::View::kFront, "_f"}, {render::View::kBack, "_b"}}) {
    auto image = render::render_still(scene, view, {500, 640});
    if (image) (void)render::write_png(file.string() + tag + ".png", *image);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const std::filesystem::path data = arguments[1];
  double mm = 22;
  int only = -1;
  std::string stills;
  std::vector<std::string> names;
  for (int i = 2; i < count; ++i) {
    const std::string a = arguments[i];
    if (a == "--mm")
      mm = std::atof(arguments[++i]);
    else if (a == "--way")
      only = std::atoi(arguments[++i]);
    else if (a == "--stills")
      stills = arguments[++i];
    else if (a == "even" || a == "odd") {
      for (const auto& entry : std::filesystem::directory_iterator(data / "garmentcode/random")) {
        const std::string f = entry.path().filename().string();
        const auto end = f.find("_specification.json");
        if (end == std::string::npos) continue;
        const int seed = std::atoi(f.substr(7, 4).c_str());
        if ((seed % 2 == 0) == (a == "even")) names.push_back(f.substr(0, end));
      }
      std::sort(names.begin(), names.end());
    } else
      names.push_back(std::isdigit(static_cast<unsigned char>(a[0])) ? "random_" + a : a);
  }
  std::unique_ptr<const dressing::Wearer> wearer;
  std::vector<body::Body> bodies;
  int certified = 0;
  double cpu = 0;
  for (const std::string& name : names) {
    auto input = input_of(data, name, mm, bodies.empty());
    if (!input) {
      std::printf("%s: %s\n", name.c_str(), to_string(input.error()).c_str());
      continue;
    }
    if (bodies.empty() || name.ends_with(".json")) {
      bodies = input->bodies;
      Stopwatch w;
      const auto person = dressing::find_person(bodies);
      if (!person) return 1;
      wearer = std::make_unique<const dressing::Wearer>(*person);
      std::printf("wearer %.2f s\n", w.cpu_s());
    }
    auto meshes = mesh::make_panel_meshes(input->pattern, mm * 1e-3, {});
    if (!meshes) {
      std::printf("%s: %s\n", name.c_str(), to_string(meshes.error()).c_str());
      continue;
    }
    auto assembly = sewing::assemble(*meshes, input->placements, input->attachments, input->notions);
    if (!assembly) continue;
    Stopwatch all;
    bool done = false;
    for (std::size_t k = 0; k < dressing::dressing_ways().size() && !done; ++k) {
      if (only >= 0 && static_cast<int>(k) != only) continue;
      Stopwatch w;
      const auto d = dressing::dress(*assembly, *wearer, dressing::dressing_ways()[k], {});
      const auto& c = d.certificate;
      std::string rings;
      for (const auto& r : c.rings) {
        rings += r.right ? " " : " !";
        for (int n : r.around.times) rings += std::to_string(n);
      }
      done = c.holds();
      std::printf(
          "%s way %zu: %d v gap %.1f mm body %d cloth %d stretch %.2f %.2f shrink %.2f gap %.0f um out %.2f "
          "rings%s  "
          "%.2f s %s\n",
          name.c_str(), k, assembly->garment.vertex_count(), d.seam_gap * 1e3, c.crossings.cloth_body,
          c.crossings.cloth_cloth, c.stretch_p99, c.stretch_max, c.shrink_p99, c.gap * 1e6, c.faces_out,
          rings.c_str(), w.cpu_s(), done ? "OK" : "-");
      std::fflush(stdout);
      if (!stills.empty())
        still(assembly->garment, d.positions, bodies[0],
              std::filesystem::path(stills) /
                  (std::filesystem::path(name).parent_path().filename().string() +
                   (name.ends_with(".json") ? "" : name) + "_w" + std::to_string(k)));
    }
    certified += done;
    cpu += all.cpu_s();
  }
  std::printf("%d of %zu certified, %.2f s each\n", certified, names.size(),
              cpu / static_cast<double>(names.size()));
}
